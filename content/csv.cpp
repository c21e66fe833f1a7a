#include "content/csv.h"

#include "content/file_bytes.h"
#include "content/gzip.h"
#include "content/number.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <istream>
#include <sstream>
#include <string_view>

namespace content {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // spreadsheets put it before UTF-8

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split_cells(const std::string& line) {
    std::vector<std::string> cells;
    std::size_t begin = 0;
    while (true) {
        const std::size_t comma = line.find(',', begin);
        cells.push_back(trimmed(line.substr(begin, comma - begin)));
        if (comma == std::string::npos) {
            return cells;
        }
        begin = comma + 1;
    }
}

} // namespace

std::size_t CsvTable::column(const std::string& name) const {
    const auto found = std::ranges::find_if(
        header, [&name](const std::string& told) { return told == name || told.starts_with(name + " ["); });
    if (found == header.end()) {
        throw sim::BadInput(source, name, "", "this column is missing");
    }
    return static_cast<std::size_t>(found - header.begin());
}

double CsvTable::number(std::size_t row, std::size_t column_index) const {
    const std::string& text = rows[row][column_index];
    if (const std::optional<double> value = finite_number(text)) {
        return *value;
    }
    throw sim::BadInput(source, fmt::format("line {}, {}", line_numbers[row], header[column_index]), text,
                        "not a finite number");
}

CsvTable read_csv(const std::filesystem::path& file) {
    if (file.extension() == ".gz") {
        std::istringstream text(text_from_gzip(read_file_bytes(file), file.string()));
        return parse_csv(text, file.string());
    }
    std::ifstream stream(file);
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", "cannot be opened for reading");
    }
    return parse_csv(stream, file.string());
}

CsvTable parse_csv(std::istream& stream, const std::string& source) {
    CsvTable table;
    table.source = source;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (number == 1 && line.starts_with(byte_order_mark)) {
            line.erase(0, byte_order_mark.size());
        }
        const std::string text = trimmed(line);
        if (text.empty() || text.front() == '#') {
            continue;
        }
        auto cells = split_cells(text);
        if (table.header.empty()) {
            table.header = std::move(cells);
            continue;
        }
        if (cells.size() != table.header.size()) {
            throw sim::BadInput(table.source, fmt::format("line {}", number), "",
                                fmt::format("{} cells where the header has {}", cells.size(), table.header.size()));
        }
        table.rows.push_back(std::move(cells));
        table.line_numbers.push_back(number);
    }
    if (table.header.empty()) {
        throw sim::BadInput(table.source, "", "", "the file is empty");
    }
    return table;
}

} // namespace content
