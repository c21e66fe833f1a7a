#pragma once

#include "content/camera_path.h"
#include "engine/film/film_maker.h"

namespace engine {

/// A film of a scenario by an eye on a path, at the scenario's pace, in the world's time unless asked otherwise. Every
/// frame's eye is checked before any is drawn. Throws sim::BadInput for a path that no eye can take.
FilmReel path_reel(const content::Scenario& scenario, const content::CameraPath& path, const FilmRequest& request);

} // namespace engine
