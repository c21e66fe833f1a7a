#pragma once

#include "engine/vr/headset.h"
#include "engine/vr/headset_ticks.h"
#include "input/device_pilot.h"
#include "render/gl/egl_context.h"
#include "render/picture_file.h"
#include "tests/render/scene_kit.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

/// Flights in a headset whose pictures are looked at.
namespace xr_kit {

/// Where the small bright things of a picture are: pixels from the upper left corner, weighed by their light.
inline glm::dvec2 centre_of_light(int width, int height, const std::function<double(int, int)>& light) {
    glm::dvec2 sum(0.0);
    double weight = 0.0;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double w = light(column, row);
            sum += w * glm::dvec2(column + 0.5, row + 0.5);
            weight += w;
        }
    }
    return sum / weight;
}

/// A ball that shines in the dark.
inline content::SceneDesc shining_ball(const glm::dvec3& centre, double radius) {
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(0.0f), glm::vec3(0.0f), glm::vec3(0.0f)};
    scene_kit::add(scene, scene_kit::sphere(glm::vec3(centre), static_cast<float>(radius), 64),
                   scene_kit::unlit(glm::vec3(1.0f)));
    return scene;
}

/// A flight at rest in a headset without a window.
class WatchedFlight {
  public:
    explicit WatchedFlight(const content::SceneDesc& scene, const content::Scenario& scenario = {},
                           std::unique_ptr<engine::TickSink> sink = nullptr)
        : renderer(scene, {render::Method::ray}), flight(scenario, std::move(sink)), hands(scenario.vehicle),
          headset(input::XrBase::local), clock(scenario.vehicle.tick_rate) {
        picture.display.dither = false;
    }

    /// The next frame of the headset, flown and drawn. Gives up after ten seconds without one.
    std::optional<engine::HeadsetFrame> next_frame() {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
        while (std::chrono::steady_clock::now() < deadline && !headset.over()) {
            if (const std::optional<engine::HeadsetFrame> frame = headset.begin_frame()) {
                fly(*frame);
                return frame;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return std::nullopt;
    }

    render::EglContext context;
    render::Renderer renderer;
    engine::Flight flight;
    input::DevicePilot hands;
    engine::Headset headset;
    engine::FixedStep clock;
    engine::PictureSettings picture;
    double fraction = 0.0;

  private:
    void fly(const engine::HeadsetFrame& frame) {
        input::DeviceState devices;
        devices.gamepad = frame.controllers.gamepad;
        hands.sample(devices, {}, frame.elapsed_seconds);
        const engine::FixedStep::Steps steps = clock.advance(frame.elapsed_seconds);
        const input::RoomScale scale{flight.metres_per_light_unit(), clock.pace()};
        engine::HeadsetTicks ticks(headset, scale, steps, 1.0 / (clock.pace() * flight.vehicle().tick_rate));
        for (sim::Tick i = 0; i < steps.ticks; ++i) {
            ticks.tick(flight, hands);
        }
        fraction = steps.fraction;
        engine::note_frame(flight, frame, scale, fraction);
        headset.end_frame(renderer, flight, flight.between(fraction), picture, scale, {}, frame.elapsed_seconds);
    }
};

} // namespace xr_kit
