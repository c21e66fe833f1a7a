#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

/// Small tensors at an event of a curved spacetime. `T` is double, float, a dual number or lanes of rays.
namespace sim {

/// Four components in the order (t, x, y, z) of a spacetime's chart: an event x^mu, a vector v^mu or a covector p_mu.
/// Which of them it is, the name says.
template <class T>
struct Components {
    T t{}, x{}, y{}, z{};

    constexpr T& operator[](int mu) { return mu == 0 ? t : mu == 1 ? x : mu == 2 ? y : z; }
    constexpr const T& operator[](int mu) const { return mu == 0 ? t : mu == 1 ? x : mu == 2 ? y : z; }
    friend constexpr Components operator+(const Components& a, const Components& b) {
        return {a.t + b.t, a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend constexpr Components operator-(const Components& a, const Components& b) {
        return {a.t - b.t, a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend constexpr Components operator*(const T& s, const Components& a) {
        return {s * a.t, s * a.x, s * a.y, s * a.z};
    }
};

/// The sum over mu of v^mu p_mu.
template <class T>
constexpr T contract(const Components<T>& vector, const Components<T>& covector) {
    return vector.t * covector.t + vector.x * covector.x + vector.y * covector.y + vector.z * covector.z;
}

/// sqrt(x^2 + y^2 + z^2), the radius of Cartesian charts.
template <class T>
T chart_radius(const Components<T>& a) {
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

inline glm::dvec3 space(const Components<double>& a) {
    return {a.x, a.y, a.z};
}

/// A symmetric tensor of rank two, g_{mu nu} or g^{mu nu}: its ten independent components.
template <class T>
struct SymmetricTensor {
    std::array<T, 10> upper{}; ///< row by row: tt tx ty tz xx xy xz yy yz zz

    static constexpr std::size_t index(int mu, int nu) {
        const auto i = static_cast<std::size_t>(mu < nu ? mu : nu);
        const auto j = static_cast<std::size_t>(mu < nu ? nu : mu);
        return i * (7 - i) / 2 + j;
    }
    constexpr T& operator()(int mu, int nu) { return upper[index(mu, nu)]; }
    constexpr const T& operator()(int mu, int nu) const { return upper[index(mu, nu)]; }
};

/// The tensor with one index contracted: v_mu = g_{mu nu} v^nu, or p^mu = g^{mu nu} p_nu.
template <class T>
constexpr Components<T> operator*(const SymmetricTensor<T>& g, const Components<T>& v) {
    Components<T> result;
    for (int mu = 0; mu < 4; ++mu) {
        result[mu] = g(mu, 0) * v.t + g(mu, 1) * v.x + g(mu, 2) * v.y + g(mu, 3) * v.z;
    }
    return result;
}

/// Diagonal tensor.
template <class T>
constexpr SymmetricTensor<T> diagonal(const T& tt, const T& xx, const T& yy, const T& zz) {
    SymmetricTensor<T> g;
    g(0, 0) = tt;
    g(1, 1) = xx;
    g(2, 2) = yy;
    g(3, 3) = zz;
    return g;
}

/// Inverse by cofactors. No pivoting: fit for metrics, whose determinant is never near zero within their chart.
template <class T>
constexpr SymmetricTensor<T> inverse(const SymmetricTensor<T>& g) {
    // Minors of rows (t, x) and of rows (y, z), by pairs of columns.
    const auto minor = [&](int r0, int r1, int c0, int c1) { return g(r0, c0) * g(r1, c1) - g(r0, c1) * g(r1, c0); };
    const T s0 = minor(0, 1, 0, 1), s1 = minor(0, 1, 0, 2), s2 = minor(0, 1, 0, 3);
    const T s3 = minor(0, 1, 1, 2), s4 = minor(0, 1, 1, 3), s5 = minor(0, 1, 2, 3);
    const T c0 = minor(2, 3, 0, 1), c1 = minor(2, 3, 0, 2), c2 = minor(2, 3, 0, 3);
    const T c3 = minor(2, 3, 1, 2), c4 = minor(2, 3, 1, 3), c5 = minor(2, 3, 2, 3);
    const T scale = T(1.0) / (s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0);
    SymmetricTensor<T> result;
    result(0, 0) = scale * (g(1, 1) * c5 - g(1, 2) * c4 + g(1, 3) * c3);
    result(0, 1) = scale * (g(0, 2) * c4 - g(0, 1) * c5 - g(0, 3) * c3);
    result(0, 2) = scale * (g(3, 1) * s5 - g(3, 2) * s4 + g(3, 3) * s3);
    result(0, 3) = scale * (g(2, 2) * s4 - g(2, 1) * s5 - g(2, 3) * s3);
    result(1, 1) = scale * (g(0, 0) * c5 - g(0, 2) * c2 + g(0, 3) * c1);
    result(1, 2) = scale * (g(3, 2) * s2 - g(3, 0) * s5 - g(3, 3) * s1);
    result(1, 3) = scale * (g(2, 0) * s5 - g(2, 2) * s2 + g(2, 3) * s1);
    result(2, 2) = scale * (g(3, 0) * s4 - g(3, 1) * s2 + g(3, 3) * s0);
    result(2, 3) = scale * (g(2, 1) * s2 - g(2, 0) * s4 - g(2, 3) * s0);
    result(3, 3) = scale * (g(2, 0) * s3 - g(2, 1) * s1 + g(2, 2) * s0);
    return result;
}

} // namespace sim
