#include "tests/paths.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::array rooms{"sim", "content", "input", "render", "engine"};

/// Which rooms a room may include from, itself apart.
const std::map<std::string, std::set<std::string>> allowed{{"sim", {}},
                                                           {"content", {"sim"}},
                                                           {"input", {"sim"}},
                                                           {"render", {"sim", "content"}},
                                                           {"engine", {"sim", "content", "input", "render"}}};

std::vector<fs::path> sources_of(const std::string& room) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(tests::source_folder()) / room)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".h" || extension == ".cpp" || extension == ".glsl" || extension == ".vert" ||
            extension == ".frag") {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The path that a line includes, or "".
std::string included(const std::string& line) {
    const auto include = line.find("#include ");
    if (include == std::string::npos) {
        return {};
    }
    const auto begin = line.find_first_of("\"<", include) + 1;
    return line.substr(begin, line.find_first_of("\">", begin) - begin);
}

} // namespace

TEST_CASE("each room includes only the rooms that it may know") {
    for (const std::string room : rooms) {
        for (const fs::path& file : sources_of(room)) {
            for (const std::string& line : lines_of(file)) {
                const std::string path = included(line);
                const std::string other = path.substr(0, path.find('/'));
                if (allowed.contains(other) && other != room) {
                    INFO(file << " includes " << path);
                    CHECK(allowed.at(room).contains(other));
                }
            }
        }
    }
}

TEST_CASE("sim uses the standard library and GLM alone") {
    for (const fs::path& file : sources_of("sim")) {
        for (const std::string& line : lines_of(file)) {
            const std::string path = included(line);
            const bool standard = path.find_first_of("/.") == std::string::npos;
            INFO(file << " includes " << path);
            CHECK((standard || path.starts_with("sim/") || path.starts_with("glm/")));
        }
    }
}

TEST_CASE("every header of sim says what it is about") {
    for (const fs::path& file : sources_of("sim")) {
        if (file.extension() == ".h") {
            INFO(file);
            CHECK(std::ranges::any_of(lines_of(file), [](const std::string& line) { return line.starts_with("///"); }));
        }
    }
}

TEST_CASE("no file has grown beyond 400 lines") {
    for (const std::string room : rooms) {
        for (const fs::path& file : sources_of(room)) {
            INFO(file);
            CHECK(lines_of(file).size() <= 400);
        }
    }
}
