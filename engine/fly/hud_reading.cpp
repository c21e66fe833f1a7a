#include "engine/fly/hud_reading.h"

#include "engine/hud/readouts.h"
#include "engine/panes.h"

#include <glm/gtc/quaternion.hpp>

#include <fmt/format.h>
#include <utility>

namespace engine {
namespace {

std::vector<HudPane> hud_panes(const PictureSettings& picture) {
    const std::vector<Pane> panes = panes_of(picture);
    const std::vector<PaneArea> areas = pane_areas(panes.size(), picture.width, picture.height);
    render::RenderFrame whole;
    whole.eye.width = picture.width;
    whole.eye.height = picture.height;
    whole.eye.horizontal_field_of_view = picture.horizontal_field_of_view;
    whole.display = picture.display;
    std::vector<HudPane> shown;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const render::RenderFrame frame = pane_frame(whole, panes[i], i, areas[i]);
        const auto share = [](int part, int all) { return static_cast<double>(part) / all; };
        shown.push_back({pane_name(panes[i]), share(areas[i].left, picture.width), share(areas[i].top, picture.height),
                         share(areas[i].width, picture.width), share(areas[i].height, picture.height),
                         frame.eye.horizontal_field_of_view, frame.display, 0.0});
    }
    return shown;
}

} // namespace

HudModel read_instruments(const content::Scenario& scenario, const Flight& flight, const sim::VehicleState& moment,
                          const glm::dquat& vehicle_from_head, const PictureSettings& picture,
                          const Navigation& navigation) {
    const glm::dquat head_from_vehicle = glm::conjugate(vehicle_from_head);
    HudModel model;
    model.title = scenario.name;
    model.readings = sim::readings(moment);
    model.ship_clock = moment.ship_clock.value;
    model.world_clock = moment.event.t;
    model.clock_unit = scenario.clock_unit_name;
    model.felt_g =
        g_from_acceleration(model.readings.felt_acceleration, flight.speed_of_light(), scenario.clock_unit_seconds);
    model.nose_in_head = head_from_vehicle * glm::dvec3(0.0, 0.0, -1.0);
    model.motion_in_head = head_from_vehicle * model.readings.motion_in_vehicle;
    model.horizontal_field_of_view = picture.horizontal_field_of_view;
    model.panes = hud_panes(picture);
    model.mode = picture.mode;
    model.exposure = picture.exposure;
    model.recording = flight.has_sink();
    model.recording_trouble = flight.trouble();
    model.navigation = navigation.read(flight, moment, vehicle_from_head);
    return model;
}

void add_cameras(const Cameras& cameras, const Flight& flight, const sim::VehicleState& moment,
                 const render::RenderFrame& frame, HudModel& model) {
    if (cameras.idle()) {
        return;
    }
    if (!cameras.is_pilots()) {
        const CameraReading reading = cameras.reading(flight, moment);
        model.camera =
            fmt::format("camera: {}, its clock {}", reading.name, clock_text(reading.clock, model.clock_unit));
        model.navigation.clocks.clear();
        model.navigation.target = {};
        const glm::dvec3 not_ahead(0.0, 0.0, 1.0);
        model.nose_in_head = not_ahead;
        model.motion_in_head = glm::dvec3(0.0);
    }
    for (ClockReading& clock : cameras.clocks(flight, frame)) {
        model.navigation.clocks.push_back(std::move(clock));
    }
}

} // namespace engine
