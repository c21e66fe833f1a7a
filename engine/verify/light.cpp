#include "engine/verify/truth_table.h"
#include "render/colour/colour_space.h"
#include "render/colour/doppler_colour.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

/// blackbody_xyz.csv: what the eye sees of a black body. doppler_white_5762K.csv: a white surface under one, shifted.
namespace engine {
namespace {

ComputedRows black_body_each(const content::CsvTable& table) {
    const std::size_t temperature = table.column("temperature_K");
    const render::Observer observer;
    const render::BlackBodyTable black_bodies(observer);
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const render::LogXyz seen = black_bodies.at_ln(std::log(table.number(row, temperature)));
        const glm::dvec3 xyz = std::exp(seen.ln_y) * glm::dvec3(seen.x_over_y, 1.0, seen.z_over_y);
        const double sum = xyz.x + xyz.y + xyz.z;
        const glm::dvec3 rgb = render::srgb_from_xyz() * xyz;
        computed.push_back({xyz.x, xyz.y, xyz.z, xyz.x / sum, xyz.y / sum, rgb.r, rgb.g, rgb.b});
    }
    return computed;
}

ComputedRows shifted_white_each(const content::CsvTable& table) {
    const std::size_t illuminant = table.column("illuminant_K");
    const std::size_t ratio = table.column("D");
    std::optional<render::DopplerColour> colour;
    ComputedRows computed;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double temperature = table.number(row, illuminant);
        if (!colour || colour->white().light_temperature() != temperature) {
            colour.emplace(temperature);
        }
        const double ln_ratio = std::log(table.number(row, ratio));
        const glm::dvec3 rgb = colour->matrix(render::Mode::full, ln_ratio) * glm::dvec3(1.0);
        const glm::dvec3 xyz = glm::inverse(colour->white().rgb_from_xyz()) * rgb;
        computed.push_back({xyz.x, xyz.y, xyz.z});
    }
    return computed;
}

} // namespace

TruthTable black_body_truth_table() {
    TruthTable table;
    table.name = "blackbody_xyz";
    table.columns = {{"temperature_K", ""},
                     {"X", "XYZ"},
                     {"Y", "XYZ"},
                     {"Z", "XYZ"},
                     {"x", "xy"},
                     {"y", "xy"},
                     {"linear_R", "linear RGB"},
                     {"linear_G", "linear RGB"},
                     {"linear_B", "linear RGB"}};
    table.tolerance = 1e-4;
    table.compute = black_body_each;
    return table;
}

TruthTable doppler_white_truth_table() {
    TruthTable table;
    table.name = "doppler_white";
    table.columns = {{"illuminant_K", ""}, {"D", ""}, {"X_rel", "XYZ"}, {"Y_rel", "XYZ"}, {"Z_rel", "XYZ"}};
    table.tolerance = 1e-3;
    table.compute = shifted_white_each;
    return table;
}

} // namespace engine
