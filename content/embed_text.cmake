# Writes a C++ source that defines `std::string_view content::embedded::SYMBOL()` with the text of INPUT.
# cmake -DINPUT=file -DOUTPUT=file.cpp -DSYMBOL=name -P embed_text.cmake
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}"
  "#include \"content/embedded_text.h\"\n"
  "static constexpr char text[] = {${bytes}};\n"
  "std::string_view content::embedded::${SYMBOL}() { return {text, sizeof(text)}; }\n")
