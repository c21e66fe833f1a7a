#pragma once

#include "engine/flight.h"
#include "engine/frame_builder.h"
#include "engine/frame_maker.h"

#include <cstdint>

namespace engine {

/// What a film's picture covers.
enum class FilmProjection : std::uint8_t {
    perspective,     ///< a screen before the eye
    equirectangular, ///< the whole sphere about the head, 4 pi: the middle looks ahead, the upper edge is up
};

struct FilmView {
    FilmProjection projection = FilmProjection::perspective;
    double eye_distance = 0.0; ///< scene metres; > 0: two perspective pictures side by side, left eye left
};

/// The picture that a film shows of a flight that stands at a moment; `picture` gives the whole picture's size. Light
/// as radiance.
render::Picture film_picture(FrameMaker& maker, const Flight& flight, const FlightMoment& moment,
                             const PictureSettings& picture, const FilmView& view);

/// Direction in head axes that the middle of a pixel of an equirectangular picture shows, unit.
glm::dvec3 equirectangular_direction(int column, int row, int width, int height);

} // namespace engine
