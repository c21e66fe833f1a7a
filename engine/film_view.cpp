#include "engine/film_view.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace engine {
namespace {

/// One picture of the head moved by `offset` scene metres, in its own axes.
render::Picture seen(FrameMaker& maker, render::RenderFrame frame, const glm::dvec3& offset) {
    frame.eye.position += (frame.eye.world_from_head * sim::FourVector<sim::Head>{0.0, offset}).space;
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
    Cube(FrameMaker& maker, const render::RenderFrame& around, int inner) : inner_(inner) {
        constexpr double quarter = std::numbers::pi / 2.0;
        const glm::dvec3 right(1.0, 0.0, 0.0);
        const glm::dvec3 up(0.0, 1.0, 0.0);
        const std::array<std::pair<double, glm::dvec3>, 6> turns{
            {{0.0, up}, {-quarter, up}, {2.0 * quarter, up}, {quarter, up}, {quarter, right}, {-quarter, right}}};
        for (std::size_t face = 0; face < turns.size(); ++face) {
            const auto [angle, axis] = turns.at(face);
            turns_.at(face) = glm::angleAxis(angle, axis);
            render::RenderFrame frame = around;
            frame.eye.width = frame.eye.height = inner + 2;
            frame.eye.horizontal_field_of_view = 2.0 * std::atan(static_cast<double>(inner + 2) / inner);
            frame.eye.world_from_head =
                around.eye.world_from_head * sim::rotation<sim::Head, sim::Head>(sim::Radians(angle), axis);
            faces_.at(face) = maker.picture(frame);
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

render::Picture around(FrameMaker& maker, const render::RenderFrame& frame) {
    const int width = frame.eye.width;
    const int height = frame.eye.height;
    // As many pixels a radian in the middle of a face as the sphere's picture has along its equator.
    const int inner = std::max(1, static_cast<int>(std::ceil(width / std::numbers::pi)));
    const Cube cube(maker, frame, inner);
    render::Picture picture{width, height, 3, {}};
    picture.values.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const glm::vec3 light = cube.light(equirectangular_direction(column, row, width, height));
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

render::Picture film_picture(FrameMaker& maker, const render::RenderFrame& frame, const FilmView& view) {
    if (view.projection == FilmProjection::equirectangular) {
        return around(maker, frame);
    }
    if (view.eye_distance > 0.0) {
        render::RenderFrame half = frame;
        half.eye.width = frame.eye.width / 2;
        const glm::dvec3 right(0.5 * view.eye_distance, 0.0, 0.0);
        return side_by_side(seen(maker, half, -right), seen(maker, half, right));
    }
    return maker.picture(frame);
}

} // namespace engine
