#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace engine {

/// A running 64-bit checksum against accidents, not against forgers. Every step is a bijection of the sum so far, so
/// that one changed word always shows. The mixing is the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
class Checksum {
  public:
    void add(std::uint64_t word) {
        std::uint64_t z = (sum_ ^ word) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
        sum_ = z ^ (z >> 31u);
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(std::string_view text) {
        add(static_cast<std::uint64_t>(text.size()));
        for (const char c : text) {
            add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
        }
    }

    std::uint64_t sum() const { return sum_; }

  private:
    std::uint64_t sum_ = 0;
};

} // namespace engine
