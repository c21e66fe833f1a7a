#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace content {

/// A comma-separated table: one header line, then rows of as many cells. Blank lines and lines opening with # are
/// skipped.
struct CsvTable {
    std::string source;
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
    std::vector<int> line_numbers; ///< of each row in the file, from 1

    /// Column index by name, told in the header with its unit, "name [unit]", or without; throws sim::BadInput naming
    /// the missing column.
    std::size_t column(const std::string& name) const;
    /// A finite number; throws sim::BadInput with file, line, column and the offending text.
    double number(std::size_t row, std::size_t column_index) const;
};

/// Reads a table, packed by gzip if the name ends in .gz; throws sim::BadInput when the file is missing, empty or
/// ragged.
CsvTable read_csv(const std::filesystem::path& file);

/// The same from a text that is already open; `source` names it in messages.
CsvTable parse_csv(std::istream& stream, const std::string& source);

} // namespace content
