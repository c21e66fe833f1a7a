#pragma once

#include "engine/frame_maker.h"
#include "engine/option_values.h"

#include <cstdint>

namespace engine {

/// What a film's picture covers.
enum class FilmProjection : std::uint8_t {
    perspective,     ///< a screen before the eye
    equirectangular, ///< the whole sphere about the head, 4 pi: the middle looks ahead, the upper edge is up
};

inline constexpr NamedValues<FilmProjection, 2> projection_names{
    {{"perspective", FilmProjection::perspective}, {"equirectangular", FilmProjection::equirectangular}}};

struct FilmView {
    FilmProjection projection = FilmProjection::perspective;
    double eye_distance = 0.0; ///< scene metres; > 0: two perspective pictures side by side, left eye left
};

/// The picture that a film shows of a frame, whose eye is the middle of the head and whose size is that of the whole
/// picture. Light as radiance.
render::Picture film_picture(FrameMaker& maker, const render::RenderFrame& frame, const FilmView& view);

/// Direction in head axes that the middle of a pixel of an equirectangular picture shows, unit.
glm::dvec3 equirectangular_direction(int column, int row, int width, int height);

} // namespace engine
