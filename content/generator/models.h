#pragma once

#include "content/scene_desc.h"

namespace content::generator {

/// Square beams along three axes with a joint where they meet, 12 x 12 x 32 cells of 10 m about the origin, which is
/// the middle of a cell. Each axis has its own tint, so that a bent beam can be told from a turned one.
SceneDesc lattice();

/// The accelerating box of the course: a closed corridor along z, 14 m wide and 9 m high, from z = 0 to z = -300.
SceneDesc corridor();

/// A street of an old town along z, from z = 40 to a church at z = -214, with a crossing at z = -70.
SceneDesc street();

/// A round paved square of 24 m radius on a terrace of 60 m, with a fountain in the middle: made to stand in a
/// panorama, whose ground it covers.
SceneDesc square();

/// A small ship in vehicle axes, the pilot's eyes at the origin: 9.4 m long, 7 m wide. Materials whose names begin with
/// "exhaust aft" or "exhaust ahead" are its flames at full thrust.
SceneDesc ship();

} // namespace content::generator
