#include "tests/xr/program.h"

#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace xr_kit {
namespace {

std::string quoted(const std::string& word) {
    return "'" + word + "'";
}

Run run(const std::string& before, const std::vector<std::string>& words,
        const std::map<std::string, std::string>& environment) {
    std::string command = "env";
    for (const auto& [name, value] : environment) {
        command += " " + quoted(name + "=" + value);
    }
    command += " " + before + quoted(tests::program());
    for (const std::string& word : words) {
        command += " " + quoted(word);
    }
    command += " 2>&1";
    std::FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    Run result;
    std::array<char, 4096> bytes{};
    for (std::size_t count = 0; (count = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;) {
        result.output.append(bytes.data(), count);
    }
    const int status = pclose(pipe);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

} // namespace

Run run_program(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment) {
    return run("", words, environment);
}

Run run_program_in_window(const std::vector<std::string>& words,
                          const std::map<std::string, std::string>& environment) {
    return run(quoted(tests::source_folder() + "/tests/xr/on_display.sh") + " ", words, environment);
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++found;
    }
    return found;
}

} // namespace xr_kit
