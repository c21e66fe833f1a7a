#include "sim/exact_step.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace sim {
namespace {

/// What a constant drive does in a given time, in powers of the generator G.
struct Exponential {
    Complex cosh_minus_one; ///< C - 1: what a small step changes keeps its own precision
    Complex sinh_over_root; ///< S
    double i0;
    Complex i1;
    double i2;
};

/// 4 q h^2 = (A + B) + 2 i sqrt(-A B), where A >= 0 is the square of the rapidity and -B >= 0 that of the angle gained.
struct Squares {
    double sum;           ///< A + B
    double root_of_minus; ///< sqrt(-A B) with the sign of Im q: rapidity times angle
    double difference;    ///< A - B
};

constexpr int terms = 9;

/// 1/n!
constexpr std::array<double, 2 * terms + 3> inverse_factorial = [] {
    std::array<double, 2 * terms + 3> values{1.0};
    for (std::size_t n = 1; n < values.size(); ++n) {
        values[n] = values[n - 1] / static_cast<double>(n);
    }
    return values;
}();

/// For |A|, |B| < 1, where the ninth term is below a rounding of the first; fewer are summed where fewer count.
Exponential by_series(const Squares& z, Complex q_h2, double h) {
    // Divided differences d_n = (A^(n+1) - B^(n+1)) / (A - B) and power sums p_n = A^n + B^n without A and B
    // themselves: both follow x_n = (A + B) x_(n-1) - A B x_(n-2).
    const double minus_product = z.root_of_minus * z.root_of_minus;
    double d_before = 0.0;
    double d = 1.0;
    double p_before = 0.0;
    double p = 2.0;
    Complex power{1.0, 0.0}; // (q h^2)^n

    double sinhc_sum = 0.0;        // shc(A) + shc(B), shc(z) = sum of z^n/(2n+1)!
    double sinhc_difference = 0.0; // (shc(A) - shc(B)) / (A - B)
    double cosh_difference = 0.0;  // (cosh(sqrt A) - cosh(sqrt B)) / (A - B)
    double coshc_difference = 0.0; // (chc(A) - chc(B)) / (A - B), chc(z) = sum of z^n/(2n+2)!
    Complex cosh_minus_one{};
    Complex sinhc{};
    double largest = 1.0; // bound of d_n / (n + 1)
    for (std::size_t n = 0; n < terms && largest > 1e-18; ++n, largest *= z.difference) {
        sinhc_sum += inverse_factorial[2 * n + 1] * p;
        cosh_difference += inverse_factorial[2 * n + 2] * d;
        sinhc_difference += inverse_factorial[2 * n + 3] * d;
        coshc_difference += inverse_factorial[2 * n + 4] * d;
        sinhc = sinhc + inverse_factorial[2 * n + 1] * power;
        power = power * q_h2;
        cosh_minus_one = cosh_minus_one + inverse_factorial[2 * n + 2] * power;
        d_before = std::exchange(d, z.sum * d + minus_product * d_before);
        p_before = std::exchange(p, n == 0 ? z.sum : z.sum * p + minus_product * p_before);
    }
    const double h2 = h * h;
    return {cosh_minus_one,
            h * sinhc,
            0.5 * h * sinhc_sum,
            {h2 * cosh_difference, -h2 * z.root_of_minus * coshc_difference},
            2.0 * h * h2 * sinhc_difference};
}

Exponential by_functions(const Squares& z, double h) {
    // The larger of the two from the sum that does not cancel, the other from their product.
    const double larger = std::sqrt(0.5 * (z.difference + std::abs(z.sum)));
    const double smaller = std::abs(z.root_of_minus) / larger;
    const double rapidity = z.sum > 0.0 ? larger : smaller;
    const double angle = std::copysign(z.sum > 0.0 ? smaller : larger, z.root_of_minus);
    const auto sinhc = [](double x) { return x == 0.0 ? 1.0 : std::sinh(x) / x; };
    const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; };
    const double cosh_minus_one = 2.0 * std::pow(std::sinh(0.5 * rapidity), 2.0);
    const double one_minus_cos = 2.0 * std::pow(std::sin(0.5 * angle), 2.0);
    const double half_sinhc = sinhc(0.5 * rapidity);
    const double half_sinc = sinc(0.5 * angle);
    // (cosh x - 1)/x^2 and (1 - cos y)/y^2.
    const double coshc = 0.5 * half_sinhc * half_sinhc;
    const double cosc = 0.5 * half_sinc * half_sinc;

    const double ch = std::cosh(0.5 * rapidity);
    const double sh = std::sinh(0.5 * rapidity);
    const double c = std::cos(0.5 * angle);
    const double s = std::sin(0.5 * angle);
    const Complex root{0.5 * rapidity, 0.5 * angle}; // h sqrt q
    const Complex sinh_of_root{sh * c, ch * s};
    const double h2 = h * h;
    return {
        {ch * c - 1.0, sh * s},
        (h / norm2(root)) * (sinh_of_root * conj(root)),
        0.5 * h * (sinhc(rapidity) + sinc(angle)),
        {h2 * (cosh_minus_one + one_minus_cos) / z.difference, h2 * z.root_of_minus * (cosc - coshc) / z.difference},
        2.0 * h * h2 * (sinhc(rapidity) - sinc(angle)) / z.difference};
}

} // namespace

Motion exact_motion(const SpinMatrix& spin_before, ProperTime duration, const Drive& drive) {
    const glm::dvec3& a = drive.proper_acceleration;
    const glm::dvec3& w = drive.angular_velocity;
    const double h = duration.value;
    const double a2 = glm::dot(a, a);
    const double w2 = glm::dot(w, w);
    const double a_w = glm::dot(a, w);
    // 4 q = (a - i w).(a - i w)
    const Squares z{h * h * (a2 - w2), -h * h * a_w, h * h * std::hypot(a2 - w2, 2.0 * a_w)};
    const Exponential e =
        z.difference < 1.0 ? by_series(z, {0.25 * z.sum, 0.5 * z.root_of_minus}, h) : by_functions(z, h);

    const FourVector<Vehicle> moved{e.i0 + 0.25 * (a2 + w2) * e.i2,
                                    e.i1.re * a + e.i1.im * w - 0.5 * e.i2 * glm::cross(a, w)};
    const SpinMatrix g = half_generator(drive);
    const Complex s = e.sinh_over_root;
    const Complex c = e.cosh_minus_one;
    const SpinMatrix change{c + s * g.a, s * g.b, s * g.c, c + s * g.d};
    return {Lorentz<World, Vehicle>{spin_before} * moved, spin_before * change};
}

} // namespace sim
