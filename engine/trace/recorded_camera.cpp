#include "engine/trace/recorded_camera.h"

#include "engine/replay_deck.h"

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace engine {
namespace {

glm::dvec3 chart_from_world(const glm::dvec3& world) {
    return {world.x, -world.z, world.y};
}

render::CameraPose pose_of(const sim::VehicleState& state) {
    const sim::BoostAndRotation eye =
        sim::split(sim::world_from_head(state.world_from_vehicle, glm::dquat(1.0, 0.0, 0.0, 0.0)));
    render::CameraPose pose;
    pose.time = state.event.t;
    pose.position = chart_from_world(state.event.space);
    pose.velocity = std::tanh(eye.xi.value) * chart_from_world(eye.along);
    pose.look = -chart_from_world(eye.boosted_from_head[2]);
    pose.up = chart_from_world(eye.boosted_from_head[1]);
    return pose;
}

} // namespace

std::vector<render::CameraPose> recorded_camera(const std::filesystem::path& recording, int frames) {
    ReplayDeck deck(read_sound_recording(recording));
    const auto last = static_cast<double>(deck.end() - deck.first());
    std::vector<render::CameraPose> poses;
    for (int i = 0; i < frames; ++i) {
        const double share = frames > 1 ? static_cast<double>(i) / (frames - 1) : 0.0;
        deck.seek(static_cast<double>(deck.first()) + std::round(share * last));
        poses.push_back(pose_of(deck.moment().before));
    }
    return poses;
}

} // namespace engine
