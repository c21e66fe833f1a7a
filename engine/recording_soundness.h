#pragma once

#include "engine/recording_file.h"

namespace engine {

/// The first contradiction, by tick, between a recording's parts and their checksums.
std::optional<Damage> find_damage(const Recording& recording);

} // namespace engine
