#pragma once

/// Conventions of the whole program, on one page.
///
/// Units: c = 1. Times in clock units, lengths in light clock units (a scenario fixes both in seconds and metres).
/// Signature (-,+,+,+); components in the order (t, x, y, z); right-handed space.
/// Frames: World, where the scenery is at rest (axes as glTF: y up); Vehicle, the ship's rest frame, and Head, the
/// eyes' rest frame, both with a camera's axes (x right, y up, -z ahead). Boosted: the eye's rest frame with the
/// world's axes carried over by the pure boost from World, used where a picture needs no rotation. Goal: the rest frame
/// of what the ship flies to, its axes the world's likewise.
/// Transforms are named a_from_b and compose by adjacent equal names.
/// A direction n says where light is SEEN COMING FROM; the photon itself moves along -n.
/// D = lambda_observed / lambda_emitted: D < 1 is blueshift.
/// Rapidity xi = atanh(beta), gamma = cosh(xi). Tested range: rapidity 0 to 30 (gamma up to 5e12).
///
/// A Lorentz frame is one matrix Lambda in SL(2,C), body to world: X_world = Lambda X_body Lambda^dagger with
/// X = t + x.sigma; four-velocity = Lambda Lambda^dagger; boost: cosh(xi/2) + n.sigma sinh(xi/2); rotation by phi about
/// n: cos(phi/2) - i n.sigma sin(phi/2). Entries grow like e^(xi/2), so it stays exact far beyond a 4x4 matrix.
namespace sim {

struct World {};
struct Vehicle {};
struct Head {};
struct Boosted {};
struct Goal {};

} // namespace sim
