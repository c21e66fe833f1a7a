#include "engine/trace/recorded_camera.h"

#include "engine/flight.h"
#include "engine/replay.h"

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
    Replay replay = load_replay(recording);
    Flight flight(replay.scenario, nullptr);
    flight.follow(std::move(replay.changes));
    std::vector<sim::VehicleState> states{flight.state()};
    while (flight.tick(*replay.pilot)) {
        states.push_back(flight.state());
    }
    std::vector<render::CameraPose> poses;
    for (int i = 0; i < frames; ++i) {
        const double share = frames > 1 ? static_cast<double>(i) / (frames - 1) : 0.0;
        poses.push_back(
            pose_of(states[static_cast<std::size_t>(std::llround(share * static_cast<double>(states.size() - 1)))]));
    }
    return poses;
}

} // namespace engine
