#include "engine/flight_file.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

namespace engine {
namespace {

std::string safe_in_a_file_name(std::string name) {
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') {
            c = '_';
        }
    }
    return name.empty() ? "flight" : name;
}

std::string local_time_stamp() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    std::array<char, 32> stamp{};
    std::strftime(stamp.data(), stamp.size(), "%Y%m%d-%H%M%S", &local);
    return stamp.data();
}

/// Creates an empty file unless there is one of that name already.
bool reserve(const std::filesystem::path& file) {
    struct Close {
        void operator()(std::FILE* open) const { std::fclose(open); }
    };
    return std::unique_ptr<std::FILE, Close>(std::fopen(file.c_str(), "wx")) != nullptr;
}

} // namespace

std::filesystem::path flights_folder() {
    const char* chosen = std::getenv("RAPIDITY_FLIGHTS_DIR");
    return chosen != nullptr && *chosen != '\0' ? chosen : "flights";
}

std::filesystem::path new_flight_file(const std::string& scenario_name, const std::filesystem::path& folder) {
    std::error_code ignored; // the recorder says what it cannot write
    std::filesystem::create_directories(folder, ignored);

    const std::string stem = safe_in_a_file_name(scenario_name) + "-" + local_time_stamp();
    std::filesystem::path file = folder / (stem + ".rapidity");
    for (int other = 2; !reserve(file) && std::filesystem::exists(file, ignored); ++other) {
        file = folder / (stem + "-" + std::to_string(other) + ".rapidity");
    }
    return file;
}

} // namespace engine
