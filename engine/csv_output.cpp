#include "engine/csv_output.h"

#include "engine/failure.h"
#include "sim/bad_input.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>

namespace engine {

void write_csv(const std::filesystem::path& file, const CsvOutput& table) {
    std::string text = fmt::format("{}\n", fmt::join(table.header, ","));
    for (const auto& row : table.rows) {
        text += fmt::format("{}\n", fmt::join(row, ","));
    }
    write_text(file, text);
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    errno = 0;
    std::ofstream stream(file, std::ios::trunc);
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", fmt::format("cannot be written: {}", std::strerror(errno)));
    }
    stream << text;
    stream.close();
    if (!stream) {
        throw Failure(fmt::format("{}: writing stopped: {}", file.string(), std::strerror(errno)));
    }
}

std::string exact_text(double value) {
    return fmt::format("{:.17g}", value);
}

} // namespace engine
