#include "sim/state_hash.h"

#include "sim/state_fields.h"

#include <bit>

namespace sim {
namespace {

class Hash {
  public:
    void add(double value) {
        constexpr std::uint64_t prime = 1099511628211u;
        auto bits = std::bit_cast<std::uint64_t>(value + 0.0); // -0.0 + 0.0 is 0.0
        for (int byte = 0; byte < 8; ++byte) {
            value_ = (value_ ^ (bits & 0xffu)) * prime;
            bits >>= 8u;
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037u; // FNV's offset basis
};

} // namespace

std::uint64_t state_hash(const VehicleState& state) {
    Hash hash;
    for (const StateField& field : state_fields) {
        hash.add(field.get(state));
    }
    return hash.value();
}

std::uint64_t state_hash(const VehicleState& state, std::span<const std::size_t> fields) {
    Hash hash;
    for (const std::size_t field : fields) {
        hash.add(state_fields.at(field).get(state));
    }
    return hash.value();
}

} // namespace sim
