#pragma once

#include "engine/database.h"
#include "input/replay_pilot.h"

#include <vector>

namespace engine {

/// The demands of a recording up to version 4, which kept them by groups: a row of thrust, turn, head or buttons says
/// what is demanded from its tick on. Throws DatabaseError.
std::vector<input::TimedControl> read_older_demands(Database& database);

} // namespace engine
