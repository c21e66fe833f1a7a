#include "engine/demand_code.h"

#include "engine/recording_format.h"

#include <array>
#include <bit>
#include <limits>
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

    std::uint64_t number() {
        const std::uint64_t head = byte();
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

  private:
    std::string_view bytes_;
};

} // namespace

std::string pack_demands(const std::vector<input::TimedControl>& demands) {
    std::string bytes;
    sim::Tick tick = 0;
    Bits last = bits_of({});
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
        for (std::size_t i = 0; i < now.size(); ++i) {
            if (now[i] != last[i]) {
                put_number(bytes, now[i] ^ last[i]);
            }
        }
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
    std::uint32_t buttons = 0;
    while (!unpacker.at_end()) {
        const std::uint64_t mask = unpacker.varint();
        const std::uint64_t ticks = (mask & next_tick) != 0 ? 1 : unpacker.varint();
        if (mask >= first_number << last.size() || ticks > largest_tick - tick || (ticks == 0 && !demands.empty())) {
            throw DatabaseError("its demands are damaged");
        }
        tick += ticks;
        for (std::size_t i = 0; i < last.size(); ++i) {
            last[i] ^= (mask & first_number << i) != 0 ? unpacker.number() : 0;
        }
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
