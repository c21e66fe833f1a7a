#pragma once

#include <glm/vec3.hpp>

/// Complex 2x2 matrices in plain doubles. std::complex would check every product for infinities; these do not.
namespace sim {

struct Complex {
    double re = 0.0;
    double im = 0.0;

    friend constexpr Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
    friend constexpr Complex operator-(Complex a, Complex b) { return {a.re - b.re, a.im - b.im}; }
    friend constexpr Complex operator-(Complex a) { return {-a.re, -a.im}; }
    friend constexpr Complex operator*(double s, Complex a) { return {s * a.re, s * a.im}; }
    friend constexpr Complex operator*(Complex a, Complex b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend constexpr bool operator==(Complex, Complex) = default;
};

constexpr Complex conj(Complex a) {
    return {a.re, -a.im};
}
constexpr double norm2(Complex a) {
    return a.re * a.re + a.im * a.im;
}

/// [[a, b], [c, d]].
struct SpinMatrix {
    /// Nothing but zeros; the default is the unit matrix.
    static constexpr SpinMatrix zero() { return {{}, {}, {}, {}}; }

    Complex a{1.0, 0.0};
    Complex b{};
    Complex c{};
    Complex d{1.0, 0.0};

    friend constexpr SpinMatrix operator+(const SpinMatrix& p, const SpinMatrix& q) {
        return {p.a + q.a, p.b + q.b, p.c + q.c, p.d + q.d};
    }
    friend constexpr SpinMatrix operator-(const SpinMatrix& p, const SpinMatrix& q) {
        return {p.a - q.a, p.b - q.b, p.c - q.c, p.d - q.d};
    }
    friend constexpr SpinMatrix operator*(double s, const SpinMatrix& p) {
        return {s * p.a, s * p.b, s * p.c, s * p.d};
    }
    friend constexpr SpinMatrix operator*(const SpinMatrix& p, const SpinMatrix& q) {
        return {p.a * q.a + p.b * q.c, p.a * q.b + p.b * q.d, p.c * q.a + p.d * q.c, p.c * q.b + p.d * q.d};
    }
    friend constexpr bool operator==(const SpinMatrix&, const SpinMatrix&) = default;
};

constexpr SpinMatrix dagger(const SpinMatrix& m) {
    return {conj(m.a), conj(m.c), conj(m.b), conj(m.d)};
}
constexpr Complex determinant(const SpinMatrix& m) {
    return m.a * m.d - m.b * m.c;
}
constexpr double frobenius2(const SpinMatrix& m) {
    return norm2(m.a) + norm2(m.b) + norm2(m.c) + norm2(m.d);
}
/// The change of the determinant by a small change of the matrix, to first order.
constexpr Complex determinant_change(const SpinMatrix& m, const SpinMatrix& change) {
    return m.a * change.d + m.d * change.a - (m.b * change.c + m.c * change.b);
}
/// adj(m) m = det(m); the inverse where det = 1.
constexpr SpinMatrix adjugate(const SpinMatrix& m) {
    return {m.d, -m.b, -m.c, m.a};
}

/// (real + i imaginary).sigma for two real 3-vectors.
constexpr SpinMatrix pauli(const glm::dvec3& real, const glm::dvec3& imaginary) {
    return {{real.z, imaginary.z},
            {real.x + imaginary.y, imaginary.x - real.y},
            {real.x - imaginary.y, imaginary.x + real.y},
            {-real.z, -imaginary.z}};
}

/// What has to be added to m, whose determinant is `det`, near 1, for the nearest matrix of determinant 1, to first
/// order:
/// ((1 - det)/|m|^2) conj(adj m)^T. Scaling by 1/sqrt(det) instead would spread a rounding error of det, about
/// gamma * 2e-16, over every entry and spoil fast frames.
constexpr SpinMatrix smallest_correction(const SpinMatrix& m, Complex det) {
    const double inverse_norm = 1.0 / frobenius2(m);
    const Complex factor{(1.0 - det.re) * inverse_norm, -det.im * inverse_norm};
    const SpinMatrix gradient = dagger(adjugate(m));
    return {factor * gradient.a, factor * gradient.b, factor * gradient.c, factor * gradient.d};
}

} // namespace sim
