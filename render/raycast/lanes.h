#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Sixteen rays side by side: the width of the widest packet that Embree traces at once. Arithmetic on them is written
/// as loops over plain numbers, which the compiler turns into vector instructions; results are the same bits whatever
/// the processor offers, for no product is fused with a sum.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
/// Compiles a function once for each width of vectors; the program picks when it starts.
#define RAPIDITY_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define RAPIDITY_VECTOR_CLONES
#endif

namespace render {

inline constexpr int lane_count = 16;

struct alignas(64) Lanes {
    std::array<float, lane_count> values{};

    float& operator[](int lane) { return values[static_cast<std::size_t>(lane)]; }
    float operator[](int lane) const { return values[static_cast<std::size_t>(lane)]; }
};

struct Lanes3 {
    Lanes x;
    Lanes y;
    Lanes z;
};

/// Four numbers that are filtered together; one vector register everywhere.
using Four [[gnu::vector_size(16)]] = float;

struct alignas(64) LaneIndices {
    std::array<std::uint32_t, lane_count> values{};

    std::uint32_t& operator[](int lane) { return values[static_cast<std::size_t>(lane)]; }
    std::uint32_t operator[](int lane) const { return values[static_cast<std::size_t>(lane)]; }
};

/// One bit a lane.
using LaneMask = std::uint32_t;
inline constexpr LaneMask all_lanes = (1u << lane_count) - 1u;

inline bool has(LaneMask mask, int lane) {
    return ((mask >> static_cast<unsigned>(lane)) & 1u) != 0;
}

/// log2 of a positive normal number, to 1e-7 absolute: 2 artanh((m - 1) / (m + 1)) / ln 2 by its series, m the mantissa
/// between the roots of 1/2 and 2. Straight code, unlike the library's, so that loops of it become vectors.
inline float log2_of_lane(float x) {
    constexpr std::uint32_t bits_of_root_half = 0x3f3504f3u;
    const auto shifted = std::bit_cast<std::uint32_t>(x) - bits_of_root_half;
    const auto exponent = static_cast<float>(static_cast<std::int32_t>(shifted) >> 23);
    const auto mantissa = std::bit_cast<float>((shifted & 0x007fffffu) + bits_of_root_half);
    const float s = (mantissa - 1.0f) / (mantissa + 1.0f);
    const float s2 = s * s;
    return exponent + s * (2.8853901f + s2 * (0.96179669f + s2 * (0.57707802f + s2 * 0.41219859f)));
}

/// Largest integer not above x, as far as an int reaches; without a library call.
inline int floor_of_lane(float x) {
    const int truncated = static_cast<int>(x);
    return truncated - (static_cast<float>(truncated) > x ? 1 : 0);
}

/// A float as a half, rounded to nearest even; |x| below 65520. No denormal float comes up, for threads may flush
/// those.
inline std::uint16_t half_of_lane(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    const std::uint32_t size = bits & 0x7fffffffu;
    // Beside 1/2 the last place is a denormal half's.
    const std::uint32_t denormal = std::bit_cast<std::uint32_t>(std::bit_cast<float>(size) + 0.5f) - 0x3f000000u;
    const std::uint32_t normal = ((size + 0x0fffu + ((size >> 13) & 1u)) >> 13) - (112u << 10);
    return static_cast<std::uint16_t>(sign | (size < 0x38800000u ? denormal : normal));
}

} // namespace render
