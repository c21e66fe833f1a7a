#include "render/colour/colour_difference.h"

#include "render/colour/colour_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

double lab_curve(double t) {
    constexpr double edge = 6.0 / 29.0;
    return t > edge * edge * edge ? std::cbrt(t) : t / (3.0 * edge * edge) + 4.0 / 29.0;
}

double hue_degrees(double a, double b) {
    if (a == 0.0 && b == 0.0) {
        return 0.0;
    }
    const double hue = std::atan2(b, a) / degree;
    return hue < 0.0 ? hue + 360.0 : hue;
}

double seventh_power_share(double chroma) {
    const double power = std::pow(chroma, 7.0);
    return std::sqrt(power / (power + std::pow(25.0, 7.0)));
}

} // namespace

glm::dvec3 lab_from_xyz(const glm::dvec3& xyz) {
    const double x = lab_curve(xyz.x / d65_xyz.x);
    const double y = lab_curve(xyz.y / d65_xyz.y);
    const double z = lab_curve(xyz.z / d65_xyz.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double ciede2000(const glm::dvec3& lab_1, const glm::dvec3& lab_2) {
    const double mean_chroma = 0.5 * (std::hypot(lab_1.y, lab_1.z) + std::hypot(lab_2.y, lab_2.z));
    const double stretch = 1.0 + 0.5 * (1.0 - seventh_power_share(mean_chroma));
    const double a_1 = stretch * lab_1.y;
    const double a_2 = stretch * lab_2.y;
    const double c_1 = std::hypot(a_1, lab_1.z);
    const double c_2 = std::hypot(a_2, lab_2.z);
    const double h_1 = hue_degrees(a_1, lab_1.z);
    const double h_2 = hue_degrees(a_2, lab_2.z);
    const bool grey = c_1 * c_2 == 0.0;

    double turn = h_2 - h_1;
    double mean_hue = h_1 + h_2;
    if (!grey) {
        mean_hue *= 0.5;
        if (std::abs(turn) > 180.0) {
            mean_hue += mean_hue < 180.0 ? 180.0 : -180.0;
            turn += turn < 0.0 ? 360.0 : -360.0;
        }
    }
    const double delta_l = lab_2.x - lab_1.x;
    const double delta_c = c_2 - c_1;
    const double delta_h = grey ? 0.0 : 2.0 * std::sqrt(c_1 * c_2) * std::sin(0.5 * turn * degree);

    const double from_middle = std::pow(0.5 * (lab_1.x + lab_2.x) - 50.0, 2.0);
    const double mean_c = 0.5 * (c_1 + c_2);
    const double t = 1.0 - 0.17 * std::cos((mean_hue - 30.0) * degree) + 0.24 * std::cos(2.0 * mean_hue * degree) +
                     0.32 * std::cos((3.0 * mean_hue + 6.0) * degree) -
                     0.20 * std::cos((4.0 * mean_hue - 63.0) * degree);
    const double s_l = 1.0 + 0.015 * from_middle / std::sqrt(20.0 + from_middle);
    const double s_c = 1.0 + 0.045 * mean_c;
    const double s_h = 1.0 + 0.015 * mean_c * t;
    const double rotation = 60.0 * std::exp(-std::pow((mean_hue - 275.0) / 25.0, 2.0));
    const double r_t = -2.0 * seventh_power_share(mean_c) * std::sin(rotation * degree);
    const double l = delta_l / s_l;
    const double c = delta_c / s_c;
    const double h = delta_h / s_h;
    return std::sqrt(std::max(l * l + c * c + h * h + r_t * c * h, 0.0));
}

} // namespace render
