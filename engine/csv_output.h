#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace engine {

/// A table to be written as CSV.
struct CsvOutput {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;
};

/// Writes the table. Throws sim::BadInput when the file cannot be created, engine::Failure when it cannot be written
/// to its end.
void write_csv(const std::filesystem::path& file, const CsvOutput& table);

/// Writes a text that is a whole file; throws as write_csv does.
void write_text(const std::filesystem::path& file, const std::string& text);

/// A double with the 17 digits that give the same bits back.
std::string exact_text(double value);

} // namespace engine
