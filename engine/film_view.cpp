#include "engine/film_view.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace engine {
namespace {

/// One picture of the head turned by `turn` and moved by `offset` (head axes, light clock units).
render::Picture seen(FrameMaker& maker, const Flight& flight, const FlightMoment& moment,
                     const PictureSettings& picture, const glm::dquat& turn, const glm::dvec3& offset) {
    const sim::VehicleState ship = moment.between();
    const glm::dquat head = moment.head();
    render::RenderFrame frame = build_frame(flight, ship, head * turn, picture, 0.0);
    if (offset != glm::dvec3(0.0)) {
        frame.eye.position =
            sim::head_event(ship, moment.control.head_position + head * offset).space * flight.metres_per_light_unit();
    }
    return maker.picture(frame);
}

render::Picture side_by_side(const render::Picture& left, const render::Picture& right) {
    render::Picture both{left.width + right.width, left.height, left.channels, {}};
    const auto row_size = static_cast<std::ptrdiff_t>(left.width) * left.channels;
    for (int row = 0; row < left.height; ++row) {
        for (const render::Picture* half : {&left, &right}) {
            const auto begin = half->values.begin() + row * row_size;
            both.values.insert(both.values.end(), begin, begin + row_size);
        }
    }
    return both;
}

/// Six square pictures around the head, each with a border of a pixel beyond its 90 degrees so that colours between
/// two pixels are found within one picture.
class Cube {
  public:
    Cube(FrameMaker& maker, const Flight& flight, const FlightMoment& moment, PictureSettings picture, int inner)
        : inner_(inner) {
        picture.width = picture.height = inner + 2;
        picture.horizontal_field_of_view = 2.0 * std::atan(static_cast<double>(inner + 2) / inner);
        constexpr double quarter = std::numbers::pi / 2.0;
        const glm::dvec3 right(1.0, 0.0, 0.0);
        const glm::dvec3 up(0.0, 1.0, 0.0);
        turns_ = {glm::angleAxis(0.0, up),     glm::angleAxis(-quarter, up),   glm::angleAxis(2.0 * quarter, up),
                  glm::angleAxis(quarter, up), glm::angleAxis(quarter, right), glm::angleAxis(-quarter, right)};
        for (std::size_t face = 0; face < turns_.size(); ++face) {
            faces_.at(face) = seen(maker, flight, moment, picture, turns_.at(face), glm::dvec3(0.0));
        }
    }

    /// Light from a direction in head axes, between the four nearest pixels.
    glm::vec3 light(const glm::dvec3& direction) const {
        std::size_t best = 0;
        glm::dvec3 local(0.0);
        for (std::size_t face = 0; face < turns_.size(); ++face) {
            const glm::dvec3 turned = glm::conjugate(turns_.at(face)) * direction;
            if (turned.z < local.z) {
                best = face;
                local = turned;
            }
        }
        const double half = 0.5 * inner_;
        const double x = half - half * local.x / local.z + 0.5; // pixels from the middle of the first
        const double y = half + half * local.y / local.z + 0.5;
        const int column = std::clamp(static_cast<int>(x), 0, inner_);
        const int row = std::clamp(static_cast<int>(y), 0, inner_);
        const auto u = static_cast<float>(x - column);
        const auto v = static_cast<float>(y - row);
        const render::Picture& face = faces_.at(best);
        return (1.0f - v) * ((1.0f - u) * pixel(face, column, row) + u * pixel(face, column + 1, row)) +
               v * ((1.0f - u) * pixel(face, column, row + 1) + u * pixel(face, column + 1, row + 1));
    }

  private:
    static glm::vec3 pixel(const render::Picture& picture, int column, int row) {
        const std::size_t at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                    static_cast<std::size_t>(column));
        return {picture.values.at(at), picture.values.at(at + 1), picture.values.at(at + 2)};
    }

    int inner_;
    std::array<glm::dquat, 6> turns_;
    std::array<render::Picture, 6> faces_;
};

render::Picture around(FrameMaker& maker, const Flight& flight, const FlightMoment& moment,
                       const PictureSettings& settings) {
    // As many pixels a radian in the middle of a face as the sphere's picture has along its equator.
    const int inner = std::max(1, static_cast<int>(std::ceil(settings.width / std::numbers::pi)));
    const Cube cube(maker, flight, moment, settings, inner);
    render::Picture picture{settings.width, settings.height, 3, {}};
    picture.values.reserve(3 * static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
    for (int row = 0; row < settings.height; ++row) {
        for (int column = 0; column < settings.width; ++column) {
            const glm::vec3 light = cube.light(equirectangular_direction(column, row, settings.width, settings.height));
            picture.values.insert(picture.values.end(), {light.x, light.y, light.z});
        }
    }
    return picture;
}

} // namespace

glm::dvec3 equirectangular_direction(int column, int row, int width, int height) {
    const double longitude = 2.0 * std::numbers::pi * ((column + 0.5) / width - 0.5);
    const double latitude = std::numbers::pi * (0.5 - (row + 0.5) / height);
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), -std::cos(latitude) * std::cos(longitude)};
}

render::Picture film_picture(FrameMaker& maker, const Flight& flight, const FlightMoment& moment,
                             const PictureSettings& picture, const FilmView& view) {
    const glm::dquat ahead(1.0, 0.0, 0.0, 0.0);
    if (view.projection == FilmProjection::equirectangular) {
        return around(maker, flight, moment, picture);
    }
    if (view.eye_distance > 0.0) {
        PictureSettings half = picture;
        half.width = picture.width / 2;
        const glm::dvec3 right(0.5 * view.eye_distance / flight.metres_per_light_unit(), 0.0, 0.0);
        return side_by_side(seen(maker, flight, moment, half, ahead, -right),
                            seen(maker, flight, moment, half, ahead, right));
    }
    return seen(maker, flight, moment, picture, ahead, glm::dvec3(0.0));
}

} // namespace engine
