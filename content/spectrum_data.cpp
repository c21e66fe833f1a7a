#include "content/spectrum_data.h"

#include "content/csv.h"
#include "content/embedded_text.h"

#include <sstream>
#include <string>

namespace content {
namespace {

CsvTable embedded_table(std::string_view text, const char* name) {
    std::istringstream stream{std::string(text)};
    return parse_csv(stream, name);
}

TabulatedSpectrum spectrum_column(const CsvTable& table, const std::string& name, TabulatedSpectrum::Beyond beyond) {
    const std::size_t wavelengths = table.column("wavelength_nm");
    const std::size_t column = table.column(name);
    TabulatedSpectrum spectrum;
    spectrum.first_nm = table.number(0, wavelengths);
    spectrum.step_nm = table.number(1, wavelengths) - spectrum.first_nm;
    spectrum.beyond = beyond;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        spectrum.values.push_back(table.number(row, column));
    }
    return spectrum;
}

} // namespace

std::array<TabulatedSpectrum, 3> cie_1931_observer() {
    const CsvTable table = embedded_table(embedded::cie1931_2deg_xyz_5nm(), "cie1931_2deg_xyz_5nm.csv");
    const auto zero = TabulatedSpectrum::Beyond::zero;
    return {spectrum_column(table, "x_bar", zero), spectrum_column(table, "y_bar", zero),
            spectrum_column(table, "z_bar", zero)};
}

TabulatedSpectrum illuminant_d65() {
    const CsvTable table = embedded_table(embedded::cie_d65_5nm(), "cie_d65_5nm.csv");
    return spectrum_column(table, "relative_power", TabulatedSpectrum::Beyond::zero);
}

std::array<TabulatedSpectrum, 3> reflectance_primaries() {
    const CsvTable table = embedded_table(embedded::reflectance_primaries(), "reflectance_primaries.csv");
    const auto held = TabulatedSpectrum::Beyond::held;
    return {spectrum_column(table, "F_R", held), spectrum_column(table, "F_G", held),
            spectrum_column(table, "F_B", held)};
}

} // namespace content
