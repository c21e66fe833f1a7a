#pragma once

#include "input/replay_pilot.h"

#include <string>
#include <string_view>
#include <vector>

/// Demands packed into bytes: each as what differs from the one before it. A hand that never rests at 240 Hz takes a
/// quarter of what plain rows take, one that rests takes nothing.
///
/// A pack begins from the tick 0 and the default ControlFrame. A demand in it is
///   mask     varint: bit 0: the tick is the one after the last demand's; bit 1: the buttons differ; bit 2 + i: number
///            i of numbers_of() differs
///   tick     varint, only without bit 0: ticks since the last demand
///   numbers  each that differs: a byte that says how it is written, and what it says:
///            16 z + n, n from 1 to 8: its bits XOR the last demand's: n bytes from the lowest that counts; z zero
///            bytes
///                      are below them, zeros above
///            9         k 2^e: a byte e and two bytes k, both with a sign; e is this number's step from now on
///            10        k 2^e: two bytes k, e its step, 0 at first
///            11        two bytes k, as 10; and so are all further numbers of this demand, without a byte before them
///   buttons  varint, only where they differ: XOR the last demand's
/// A number that is added to ControlFrame after the others changes nothing of older packs. Packs of version 5 do
/// without 9 to 11.
/// varint: seven bits a byte, lowest first, the eighth set in all but the last.
namespace engine {

std::string pack_demands(const std::vector<input::TimedControl>& demands);

/// The demands of a pack, bit for bit. Throws DatabaseError for bytes that are none, and for ticks that do not rise.
std::vector<input::TimedControl> unpack_demands(std::string_view pack);

} // namespace engine
