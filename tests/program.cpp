#include "tests/program.h"

#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace tests {
namespace {

std::string quoted(const std::string& word) {
    return "'" + word + "'";
}

} // namespace

Run run_program(const std::vector<std::string>& words, const std::map<std::string, std::string>& environment,
                const std::string& through) {
    std::string command = "env";
    for (const auto& [name, value] : environment) {
        command.append(" ").append(quoted(name)).append("=").append(quoted(value));
    }
    command += (through.empty() ? "" : " " + quoted(through)) + " " + quoted(program());
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

} // namespace tests
