#pragma once

#include "content/generator/generate.h"
#include "render/moving/ship_body.h"
#include "render/render_frame.h"
#include "sim/retarded.h"
#include "sim/ship_world_line.h"
#include "tests/render/scene_kit.h"

#include <cmath>
#include <memory>

/// Ships on known world lines before known eyes.
namespace ship_kit {

using scene_kit::empty_scene;

/// The built-in ship, glowing all over by itself as its paint says, in each part differently: what its surroundings
/// are makes no difference.
inline content::SceneDesc glowing_ship() {
    content::SceneDesc model = content::generator::generate_model("ship");
    std::erase_if(model.instances, [&](const content::Instance& instance) {
        return model.materials[model.meshes[instance.mesh].material].name.starts_with("exhaust");
    });
    float brightness = 0.3f;
    for (content::Material& material : model.materials) {
        material.emission = glm::vec3(brightness, 1.1f - brightness, 0.5f);
        material.base_colour = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
        brightness += 0.15f;
    }
    return model;
}

/// Two small lamps, 4 m before and behind the pilot.
inline content::SceneDesc two_lamps() {
    content::SceneDesc model;
    content::Material glow;
    glow.emission = glm::vec3(2.0f);
    glow.base_colour = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    for (const float z : {-4.0f, 4.0f}) {
        scene_kit::add(model, scene_kit::sphere({0.0f, 0.0f, z}, 0.25f, 24), glow);
    }
    return model;
}

/// A ship at `position` (scene metres) at the world's time 0, its nose along -z, moving uniformly.
inline sim::VehicleState coasting(const glm::dvec3& position, double beta, const glm::dvec3& heading, double metres) {
    sim::VehicleState state;
    state.event.space = position / metres;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(beta)), heading);
    return state;
}

/// Adds a ship to a frame.
inline void add_ship(render::RenderFrame& frame, const content::SceneDesc& model,
                     std::shared_ptr<const sim::ShipWorldLine> line, double world_time, double metres) {
    frame.moving.ships.push_back(
        {std::make_shared<const render::ShipBody>(render::make_ship_body(model)), std::move(line), 1.0});
    frame.moving.world_time = world_time;
    frame.moving.metres_per_light_unit = metres;
}

/// The same eye's view of the model at rest, the eye moving instead: the principle of relativity.
inline render::RenderFrame in_ships_frame(const render::RenderFrame& frame, const sim::VehicleState& ship) {
    render::RenderFrame other = frame;
    const double metres = frame.moving.metres_per_light_unit;
    const auto vehicle_from_world = sim::inverse(ship.world_from_vehicle);
    const sim::Event eye{frame.moving.world_time, frame.eye.position / metres};
    other.eye.position = metres * (vehicle_from_world * (eye - ship.event)).space;
    other.eye.world_from_head = {vehicle_from_world.spin * frame.eye.world_from_head.spin};
    other.moving = {};
    return other;
}

/// An eye beside the way of a ship that passes along -z at 12 m to the side, when the ship's light of that moment
/// arrives.
inline render::RenderFrame passing_frame(double beta, const content::SceneDesc& model, sim::VehicleState& ship) {
    constexpr double metres = 20.0;
    const glm::dvec3 ahead(0.0, 0.0, -1.0);
    ship = coasting({12.0, 0.0, 0.0}, beta, ahead, metres);
    render::RenderFrame frame = scene_kit::frame(0.0, ahead, {1.0, 0.0, 0.0}, 320, 180);
    add_ship(frame, model, std::make_shared<const sim::ShipWorldLine>(ship), 12.0 / metres, metres);
    return frame;
}

/// Share of the pixels that show a ship in just one of two object pictures, of those that do in the first.
inline double disagreement(const render::Picture& a, const render::Picture& b, double first_object_a,
                           double first_object_b) {
    double differing = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const bool in_a = a.values[i] >= static_cast<float>(first_object_a);
        const bool in_b = b.values[i] >= static_cast<float>(first_object_b);
        all += in_a ? 1.0 : 0.0;
        differing += in_a != in_b ? 1.0 : 0.0;
    }
    return all > 0.0 ? differing / all : 1.0;
}

/// The middle of the pixels brighter than 0.001 in a part of the picture, and how many they are.
struct Spot {
    double x = 0.0;
    double y = 0.0;
    int pixels = 0;
};
inline Spot spot_in(const render::Picture& picture, int left, int right) {
    Spot spot;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = left; column < right; ++column) {
            if (scene_kit::colour_at(picture, column, row).g > 1e-3) {
                spot.x += column + 0.5;
                spot.y += row + 0.5;
                ++spot.pixels;
            }
        }
    }
    spot.x /= std::max(spot.pixels, 1);
    spot.y /= std::max(spot.pixels, 1);
    return spot;
}

} // namespace ship_kit
