#include "engine/demand_code.h"

#include "engine/recording_format.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace engine {
namespace {

using Bits = std::array<std::uint64_t, std::tuple_size_v<decltype(numbers_of(sim::ControlFrame()))>>;

constexpr std::uint64_t next_tick = 1;
constexpr std::uint64_t buttons_differ = 2;
constexpr std::uint64_t first_number = 4;

Bits bits_of(const sim::ControlFrame& control) {
    return std::bit_cast<Bits>(numbers_of(control));
}

void put_varint(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80u; value >>= 7u) {
        bytes += static_cast<char>(0x80u | (value & 0x7fu));
    }
    bytes += static_cast<char>(value);
}

/// The steps that the numbers are written in, as powers of two.
using Steps = std::array<int, std::tuple_size_v<Bits>>;

constexpr std::uint64_t short_with_step = 9;
constexpr std::uint64_t short_number = 10;
constexpr std::uint64_t short_from_here = 11;
constexpr int largest_count = std::numeric_limits<std::int16_t>::max();
constexpr int lowest_step = std::numeric_limits<std::int8_t>::min();
constexpr int highest_step = std::numeric_limits<std::int8_t>::max();

/// k where the number is k 2^step, bit for bit.
std::optional<std::int16_t> count_of(std::uint64_t number, int step) {
    const double count = std::ldexp(std::bit_cast<double>(number), -step);
    if (!(std::abs(count) <= largest_count)) {
        return std::nullopt;
    }
    const auto whole = static_cast<std::int16_t>(count);
    return std::bit_cast<std::uint64_t>(std::ldexp(static_cast<double>(whole), step)) == number
               ? std::optional(whole)
               : std::nullopt; // a fraction, or minus zero
}

/// The largest step that the number is a multiple of; none: it is too fine, or no number.
std::optional<int> step_of(std::uint64_t number) {
    const double value = std::bit_cast<double>(number);
    if (!std::isfinite(value) || value == 0.0) {
        return std::nullopt;
    }
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent); // in [0.5, 1): a multiple of 2^-53
    const auto whole = static_cast<std::uint64_t>(std::abs(std::ldexp(mantissa, 53)));
    const int step = exponent - 53 + std::countr_zero(whole);
    return step >= lowest_step && step <= highest_step ? std::optional(step) : std::nullopt;
}

void put_count(std::string& bytes, std::int16_t count) {
    const auto bits = static_cast<std::uint16_t>(count);
    bytes += static_cast<char>(bits & 0xffu);
    bytes += static_cast<char>(bits >> 8u);
}

void put_number(std::string& bytes, std::uint64_t difference) {
    const int zeros = std::countr_zero(difference) / 8;
    const int count = 8 - std::countl_zero(difference) / 8 - zeros;
    bytes += static_cast<char>(16 * zeros + count);
    difference >>= 8u * static_cast<unsigned>(zeros);
    for (int i = 0; i < count; ++i) {
        bytes += static_cast<char>(difference & 0xffu);
        difference >>= 8u;
    }
}

/// How many bytes put_number takes.
int size_of_number(std::uint64_t difference) {
    return 9 - std::countl_zero(difference) / 8 - std::countr_zero(difference) / 8;
}

/// Those of `now` that differ from `last`, each as short as it can be written.
void put_numbers(std::string& bytes, const Bits& now, const Bits& last, Steps& steps) {
    std::size_t last_long = 0; // behind the last that is not short
    for (std::size_t i = 0; i < now.size(); ++i) {
        last_long = now[i] != last[i] && !count_of(now[i], steps[i]) ? i + 1 : last_long;
    }
    bool all_short = false;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == last[i]) {
            continue;
        }
        if (const std::optional<std::int16_t> count = count_of(now[i], steps[i])) {
            if (!all_short) {
                all_short = i >= last_long;
                bytes += static_cast<char>(all_short ? short_from_here : short_number);
            }
            put_count(bytes, *count);
            continue;
        }
        constexpr int short_size = 4;
        const std::optional<int> step = step_of(now[i]);
        const std::optional<std::int16_t> count = step ? count_of(now[i], *step) : std::nullopt;
        if (count && size_of_number(now[i] ^ last[i]) >= short_size) {
            steps[i] = *step;
            bytes += static_cast<char>(short_with_step);
            bytes += static_cast<char>(*step);
            put_count(bytes, *count);
        } else {
            put_number(bytes, now[i] ^ last[i]);
        }
    }
}

class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}
    bool at_end() const { return bytes_.empty(); }

    std::uint64_t byte() {
        if (bytes_.empty()) {
            throw DatabaseError("its demands are damaged");
        }
        const auto value = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return value;
    }

    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            const std::uint64_t next = byte();
            value |= (next & 0x7fu) << shift;
            if (next < 0x80u) {
                return value;
            }
        }
        throw DatabaseError("its demands are damaged");
    }

    /// The numbers of a demand for which `mask` has bits, from what they were.
    void numbers(std::uint64_t mask, Bits& numbers, Steps& steps) {
        bool all_short = false;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if ((mask & first_number << i) == 0) {
                continue;
            }
            const std::uint64_t head = all_short ? short_number : byte();
            if (head == short_with_step) {
                steps[i] = static_cast<std::int8_t>(byte());
            }
            if (head >= short_with_step && head <= short_from_here) {
                all_short = all_short || head == short_from_here;
                numbers[i] = std::bit_cast<std::uint64_t>(std::ldexp(static_cast<double>(count()), steps[i]));
            } else {
                numbers[i] ^= difference(head);
            }
        }
    }

  private:
    std::int16_t count() {
        const std::uint64_t low = byte();
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(low | byte() << 8u));
    }

    std::uint64_t difference(std::uint64_t head) {
        const std::uint64_t count = head % 16;
        const std::uint64_t zeros = head / 16;
        if (count == 0 || count + zeros > 8) {
            throw DatabaseError("its demands are damaged");
        }
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < count; ++i) {
            value |= byte() << 8u * (zeros + i);
        }
        return value;
    }

    std::string_view bytes_;
};

} // namespace

std::string pack_demands(const std::vector<input::TimedControl>& demands) {
    std::string bytes;
    sim::Tick tick = 0;
    Bits last = bits_of({});
    Steps steps{};
    std::uint32_t buttons = 0;
    for (const input::TimedControl& timed : demands) {
        const Bits now = bits_of(timed.control);
        std::uint64_t mask = timed.tick == tick + 1 ? next_tick : 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            mask |= now[i] != last[i] ? first_number << i : 0;
        }
        mask |= timed.control.buttons != buttons ? buttons_differ : 0;
        put_varint(bytes, mask);
        if ((mask & next_tick) == 0) {
            put_varint(bytes, timed.tick - tick);
        }
        put_numbers(bytes, now, last, steps);
        if (timed.control.buttons != buttons) {
            put_varint(bytes, timed.control.buttons ^ buttons);
        }
        tick = timed.tick;
        last = now;
        buttons = timed.control.buttons;
    }
    return bytes;
}

std::vector<input::TimedControl> unpack_demands(std::string_view pack) {
    std::vector<input::TimedControl> demands;
    Unpacker unpacker(pack);
    sim::Tick tick = 0;
    Bits last = bits_of({});
    Steps steps{};
    std::uint32_t buttons = 0;
    while (!unpacker.at_end()) {
        const std::uint64_t mask = unpacker.varint();
        const std::uint64_t ticks = (mask & next_tick) != 0 ? 1 : unpacker.varint();
        if (mask >= first_number << last.size() || ticks > largest_tick - tick || (ticks == 0 && !demands.empty())) {
            throw DatabaseError("its demands are damaged");
        }
        tick += ticks;
        unpacker.numbers(mask, last, steps);
        const std::uint64_t pressed = (mask & buttons_differ) != 0 ? unpacker.varint() : 0;
        if (pressed > std::numeric_limits<std::uint32_t>::max()) {
            throw DatabaseError("its demands are damaged");
        }
        buttons ^= static_cast<std::uint32_t>(pressed);
        demands.push_back({tick, control_of(std::bit_cast<decltype(numbers_of({}))>(last), buttons)});
    }
    return demands;
}

} // namespace engine
