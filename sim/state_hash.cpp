#include "sim/state_hash.h"

#include "sim/state_fields.h"

#include <bit>

namespace sim {

std::uint64_t state_hash(const VehicleState& state) {
    constexpr std::uint64_t offset_basis = 14695981039346656037u;
    constexpr std::uint64_t prime = 1099511628211u;
    std::uint64_t hash = offset_basis;
    for (const StateField& field : state_fields) {
        auto bits = std::bit_cast<std::uint64_t>(field.get(state) + 0.0); // -0.0 + 0.0 is 0.0
        for (int byte = 0; byte < 8; ++byte) {
            hash = (hash ^ (bits & 0xffu)) * prime;
            bits >>= 8u;
        }
    }
    return hash;
}

} // namespace sim
