#include "tests/xr/program.h"

#include "tests/paths.h"

namespace xr_kit {

Run run_program_in_window(const std::vector<std::string>& words,
                          const std::map<std::string, std::string>& environment) {
    return run_program(words, environment, tests::source_folder() + "/tests/xr/on_display.sh");
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++found;
    }
    return found;
}

} // namespace xr_kit
