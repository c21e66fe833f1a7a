#include "render/offline/traced/traced_scene.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

namespace render {

CameraPose camera_pose(const content::TracedScenario& scenario, double moment) {
    const content::CameraMoment at = content::camera_at(scenario.camera, moment);
    CameraPose pose;
    pose.time = at.time;
    pose.position = at.position;
    pose.velocity = scenario.camera.velocity;
    pose.look = glm::length(at.look) > 0.0 ? at.look : -at.position;
    if (!(glm::length(pose.look) > 0.0)) {
        throw sim::BadInput(scenario.name, "camera.look", "", "is needed for a camera at the chart's origin");
    }
    pose.look = glm::normalize(pose.look);
    pose.up = scenario.camera.up - glm::dot(scenario.camera.up, pose.look) * pose.look;
    if (!(glm::length(pose.up) > 1e-9 * glm::length(scenario.camera.up))) {
        throw sim::BadInput(scenario.name, "camera.up", "", "must not lie along the view");
    }
    pose.up = glm::normalize(pose.up);
    return pose;
}

} // namespace render
