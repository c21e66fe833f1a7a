#pragma once

#include "engine/film/film_maker.h"
#include "engine/replay.h"
#include "engine/replay_deck.h"

#include <vector>

namespace engine {

/// Positions in ticks of a film's frames: the first at the flight's start, the others one frame's time apart.
std::vector<double> frame_positions(ReplayDeck& deck, const FilmRequest& request);

/// A recorded flight as a film.
FilmReel replay_reel(const Replay& replay, const FilmRequest& request);

} // namespace engine
