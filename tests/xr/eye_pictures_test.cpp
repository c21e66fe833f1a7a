#include "render/offline/reference.h"
#include "tests/xr/monado.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>

namespace {

glm::dvec2 ball_in_headset(const engine::EyePictures& pictures, std::size_t eye) {
    const content::Image image = pictures.picture(eye).read();
    const engine::EyeScreen& screen = pictures.screen(eye);
    const auto below = image.height - screen.height; // the picture is in the lower left corner, rows are from the top
    return xr_kit::centre_of_light(screen.width, screen.height, [&](int column, int row) {
        return static_cast<double>(
            image.rgba[4 * (static_cast<std::size_t>(row + below) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(column))]);
    });
}

glm::dvec2 ball_of_reference(const render::ReferenceRenderer& reference, const render::EyeView& eye) {
    render::RenderFrame frame;
    frame.eye = eye;
    const render::Picture picture = reference.render(frame, 1);
    return xr_kit::centre_of_light(eye.width, eye.height, [&](int column, int row) {
        return static_cast<double>(
            picture.values[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(eye.width) +
                                static_cast<std::size_t>(column))]);
    });
}

} // namespace

TEST_CASE("a wobbling head shows each eye what the reference renderer predicts, 120 frames long, without a screen") {
    xr_kit::use_simulated_headset();
    const glm::dvec3 ball(0.1, -0.05, -1.0);
    const content::SceneDesc scene = xr_kit::shining_ball(ball, 0.05);
    xr_kit::WatchedFlight flight(scene);
    const render::ReferenceRenderer reference(scene);
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-low);
    int shown = 0;
    double largest_error = 0.0;
    for (int i = 0; i < 120; ++i) {
        const std::optional<engine::HeadsetFrame> frame = flight.next_frame();
        REQUIRE(frame);
        if (!frame->shown) {
            continue;
        }
        ++shown;
        std::array<glm::dvec2, 2> seen;
        for (std::size_t eye = 0; eye < 2; ++eye) {
            const engine::EyePictures& pictures = flight.headset.pictures();
            seen.at(eye) = ball_in_headset(pictures, eye);
            if (i % 8 == 0) {
                largest_error = std::max(largest_error,
                                         glm::distance(seen.at(eye), ball_of_reference(reference, pictures.view(eye))));
            }
        }
        CHECK(flight.headset.pictures().depth_shown()); // Monado takes depths, and the ship is at rest
        low = glm::min(low, seen[0]);
        high = glm::max(high, seen[0]);
        // The right eye sees a near thing further to the left, measured from its axis, by the distance of the eyes.
        const engine::EyePictures& pictures = flight.headset.pictures();
        const double disparity = (seen[0].x - pictures.screen(0).axis.x) - (seen[1].x - pictures.screen(1).axis.x);
        const double focal_pixels = pictures.screen(0).focal_pixels;
        const glm::dvec3 apart = pictures.view(1).position - pictures.view(0).position;
        CHECK(glm::length(apart) > 0.05); // Monado's simulated eyes are 63 mm apart
        CHECK(glm::length(apart) < 0.075);
        // At 1 m, give or take the 5 cm of the wobble and its slant.
        CHECK(disparity > 0.85 * focal_pixels * glm::length(apart));
        CHECK(disparity < 1.2 * focal_pixels * glm::length(apart));
    }
    CHECK(shown > 110); // the first frames of a session are not shown
    // A ball of about 8 pixels' radius: its edge of one sample a pixel moves the centre by less than a tenth.
    CHECK(largest_error < 0.5);
    CHECK(glm::length(high - low) > 10.0); // 5 cm and 7.5 degrees
    flight.headset.close();
    CHECK(flight.headset.over());
}
