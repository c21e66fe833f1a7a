#include "render/whole_file.h"

#include "sim/bad_input.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace render {

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
    std::filesystem::path unfinished = file;
    unfinished += ".part";
    errno = 0;
    std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    std::error_code trouble;
    if (!out) {
        trouble = std::error_code(errno, std::system_category());
    } else {
        std::filesystem::rename(unfinished, file, trouble);
    }
    if (!out || trouble) {
        std::error_code ignored;
        std::filesystem::remove(unfinished, ignored);
        throw sim::BadInput(file.string(), "", "", "cannot be written: " + trouble.message());
    }
}

} // namespace render
