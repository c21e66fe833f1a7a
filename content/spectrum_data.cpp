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

template <std::size_t count>
std::array<TabulatedSpectrum, count> reflectance_columns(const std::array<const char*, count>& names) {
    const CsvTable table = embedded_table(embedded::reflectance_primaries(), "reflectance_primaries.csv");
    std::array<TabulatedSpectrum, count> columns;
    for (std::size_t i = 0; i < count; ++i) {
        columns[i] = spectrum_column(table, names[i], TabulatedSpectrum::Beyond::held);
    }
    return columns;
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
    return reflectance_columns<3>({"F_R", "F_G", "F_B"});
}

std::array<TabulatedSpectrum, 5> reflectance_five_terms() {
    return reflectance_columns<5>({"N_R", "N_G", "N_B", "N_green", "N_red"});
}

std::array<TabulatedSpectrum, 4> reflectance_vegetation_terms() {
    return reflectance_columns<4>({"V_R", "V_G", "V_B", "V_dark"});
}

std::vector<TabulatedSpectrum> cie_test_colours() {
    const CsvTable table = embedded_table(embedded::cie_test_colour_reflectances(), "cie_test_colour_reflectances.csv");
    std::vector<TabulatedSpectrum> colours;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        TabulatedSpectrum spectrum;
        spectrum.first_nm = std::stod(table.header[1]);
        spectrum.step_nm = std::stod(table.header[2]) - spectrum.first_nm;
        spectrum.beyond = TabulatedSpectrum::Beyond::held;
        for (std::size_t column = 1; column < table.header.size(); ++column) {
            spectrum.values.push_back(table.number(row, column));
        }
        colours.push_back(std::move(spectrum));
    }
    return colours;
}

} // namespace content
