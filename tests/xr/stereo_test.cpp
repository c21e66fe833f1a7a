#include "engine/vr/eye_screens.h"
#include "render/offline/reference.h"
#include "sim/look.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <epoxy/gl.h>

namespace {

/// Eyes as a headset has them, 63 mm apart.
input::XrEyes human_eyes() {
    input::XrEyes eyes;
    eyes[0] = {{{-0.0315, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)}, -1.2, 0.9, -1.1, 1.0};
    eyes[1] = {{{0.0315, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)}, -0.9, 1.2, -1.1, 1.0};
    return eyes;
}

/// Where a ball is seen, pixels to the right and up from the eye's axis, by rays of the method under test.
glm::dvec2 seen_at(const content::SceneDesc& scene, const render::EyeView& eye, const engine::EyeScreen& screen) {
    render::RenderFrame frame;
    frame.eye = eye;
    frame.layer = render::Layer::object;
    const render::Picture picture = render::ReferenceRenderer(scene).render(frame, 1);
    const glm::dvec2 centre = xr_kit::centre_of_light(eye.width, eye.height, [&](int column, int row) {
        return picture.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(eye.width) +
                              static_cast<std::size_t>(column)] >= 0.0f
                   ? 1.0
                   : 0.0;
    });
    return {centre.x - screen.axis.x, eye.height - centre.y - screen.axis.y};
}

/// The same in closed form, without the program's frames: aberration about the motion, tan(theta'/2) = e^-xi
/// tan(theta/2). `offset`: from the eye to the ball at the eye's moment, world; `motion`: unit, `ahead`, `right` and
/// `up` the head's axes as they are turned in the boosted frame.
glm::dvec2 closed_form(const glm::dvec3& offset, const glm::dvec3& motion, double rapidity, const glm::dvec3& ahead,
                       const glm::dvec3& right, double focal_pixels) {
    const glm::dvec3 direction = glm::normalize(offset);
    const double along = glm::dot(direction, motion);
    const glm::dvec3 aside = direction - along * motion;
    const double seen_angle = 2.0 * std::atan(std::exp(-rapidity) * std::tan(0.5 * std::acos(along)));
    const glm::dvec3 seen = std::cos(seen_angle) * motion +
                            (glm::length(aside) > 0.0 ? std::sin(seen_angle) * glm::normalize(aside) : glm::dvec3(0.0));
    const glm::dvec3 up = glm::cross(right, ahead);
    return focal_pixels * glm::dvec2(glm::dot(seen, right), glm::dot(seen, up)) / glm::dot(seen, ahead);
}

} // namespace

TEST_CASE("both eyes' screens cover the headset's on one grid of square pixels") {
    const input::XrEyes eyes = human_eyes();
    const std::array<engine::EyeScreen, 2> screens = engine::eye_screens(eyes, 896, 1007);
    for (std::size_t i = 0; i < 2; ++i) {
        const engine::EyeScreen& screen = screens.at(i);
        CHECK(screen.width <= 896);
        CHECK(screen.height <= 1007);
        CHECK(screen.focal_pixels == screens[0].focal_pixels);
        for (const int pixels : {screen.axis.x, screen.axis.y, screen.width, screen.height}) {
            CHECK(pixels % 4 == 0);
        }
        // At least what the headset shows, and at most four pixels more.
        const double most = 4.0 / screen.focal_pixels;
        CHECK(screen.left() <= eyes.at(i).left + 1e-6);
        CHECK(screen.left() >= eyes.at(i).left - most);
        CHECK(screen.right() >= eyes.at(i).right - 1e-6);
        CHECK(screen.right() <= eyes.at(i).right + most);
        CHECK(screen.down() <= eyes.at(i).down + 1e-6);
        CHECK(screen.up() >= eyes.at(i).up - 1e-6);
    }
    CHECK(screens[0].width > 0.98 * 896); // the width is what limits here
}

TEST_CASE("the disparity of a near ball is the closed form's, at rest and at 0.9 c") {
    const input::XrEyes eyes = human_eyes();
    const std::array<engine::EyeScreen, 2> screens = engine::eye_screens(eyes, 896, 1007);
    struct Case {
        double beta;
        glm::dvec3 motion;
        glm::dvec3 look; // the nose, in the boosted frame's axes
    };
    for (const Case& c :
         {Case{0.0, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}}, Case{0.9, {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0}},
          Case{0.9, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}, Case{0.9, {-1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}}}) {
        CAPTURE(c.beta, c.motion.x, c.motion.z);
        const double rapidity = std::atanh(c.beta);
        const double gamma = std::cosh(rapidity);
        const glm::dvec3 right = glm::normalize(glm::cross(c.look, glm::dvec3(0.0, 1.0, 0.0)));
        sim::VehicleState ship;
        ship.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(rapidity), c.motion);
        // Half a metre away as seen at rest; moving, straight ahead on the screen to within a few degrees.
        const double seen_behind =
            2.0 * std::atan(std::exp(rapidity) * std::tan(0.5 * std::acos(glm::dot(c.look, c.motion))));
        const glm::dvec3 aside = c.look - glm::dot(c.look, c.motion) * c.motion;
        const glm::dvec3 towards =
            std::cos(seen_behind) * c.motion +
            (glm::length(aside) > 0.0 ? std::sin(seen_behind) * glm::normalize(aside) : glm::dvec3(0.0));
        const glm::dvec3 ball = 0.5 * towards + glm::dvec3(0.0, 0.01, 0.0);
        const content::SceneDesc scene = xr_kit::shining_ball(ball, 0.005);
        const std::array<render::EyeView, 2> views =
            engine::eye_views(ship, sim::ControlFrame(), 299792458.0, eyes, screens);
        std::array<glm::dvec2, 2> seen;
        std::array<glm::dvec2, 2> expected;
        for (std::size_t i = 0; i < 2; ++i) {
            // An eye at rest in the ship, simultaneous there: in the world it is gamma times as far along the motion.
            const glm::dvec3 in_ship = eyes.at(i).head_from_eye.position.x * right;
            const double along = glm::dot(in_ship, c.motion);
            const glm::dvec3 eye = in_ship + (gamma - 1.0) * along * c.motion;
            expected.at(i) = closed_form(ball - eye, c.motion, rapidity, c.look, right, screens[0].focal_pixels);
            seen.at(i) = seen_at(scene, views.at(i), screens.at(i));
            CHECK(glm::length(views.at(i).position - eye) < 1e-9);
            CHECK(glm::distance(seen.at(i), expected.at(i)) < 0.5);
        }
        const double disparity = seen[0].x - seen[1].x;
        CHECK(std::abs(disparity - (expected[0].x - expected[1].x)) < 0.5);
        // A wrong event of the eye (no gamma, or 1 / gamma) would be seen: it changes this by tens of pixels.
        CHECK(std::abs(disparity) > 5.0);
    }
}

TEST_CASE("what both eyes share of the sky is what each eye sees of it") {
    const render::EglContext context;
    content::SceneDesc scene = xr_kit::shining_ball({0.0, 0.1, -1.0}, 0.1);
    scene.gradient_sky = content::GradientSky();
    for (int i = 0; i < 400; ++i) { // light-years away, around where the eyes look
        scene.stars.push_back({{20.0 * std::sin(1.0 * i), 20.0 * std::sin(2.3 * i), -20.0}, 0.0f, 6000.0f});
    }
    const input::XrEyes eyes = human_eyes();
    const std::array<engine::EyeScreen, 2> screens = engine::eye_screens(eyes, 320, 240);
    sim::VehicleState ship;
    ship.world_from_vehicle =
        sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(0.5)), glm::dvec3(0.6, 0.0, -0.8));
    const std::array<render::EyeView, 2> views = engine::eye_views(ship, {}, 299792458.0, eyes, screens);
    render::Renderer renderer(scene, {render::Method::ray});
    const auto pictures = [&](bool sharing, render::StereoShare& share) {
        share.begin(sharing ? engine::whole_view(eyes, views[0], screens) : std::nullopt);
        std::array<content::Image, 2> images;
        for (std::size_t i = 0; i < 2; ++i) {
            const engine::Offscreen target(views.at(i).width, views.at(i).height);
            render::RenderFrame frame;
            frame.eye = views.at(i);
            frame.display.dither = false;
            renderer.draw(frame, target.framebuffer(), {0, 0, frame.eye.width, frame.eye.height}, &share);
            images.at(i) = target.read();
        }
        return images;
    };
    render::StereoShare share;
    render::StereoShare nothing;
    const std::array<content::Image, 2> shared = pictures(true, share);
    const std::array<content::Image, 2> alone = pictures(false, nothing);
    CHECK(nothing.sky_reused == 0);
    // Both screens reach from the nose's side to 0.9: six sevenths of the width, less the ball.
    const auto pixels = static_cast<double>(views[1].width) * views[1].height;
    CHECK(static_cast<double>(share.sky_reused) > 0.75 * pixels);
    int stars = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        int largest = 0;
        for (std::size_t k = 0; k < shared.at(i).rgba.size(); ++k) {
            largest = std::max(largest, std::abs(shared.at(i).rgba[k] - alone.at(i).rgba[k]));
            stars += alone.at(i).rgba[k] == 255 && k % 4 == 1 ? 1 : 0;
        }
        CHECK(largest <= 1); // one level of 8 bits: colours' tables that are sampled elsewhere
    }
    CHECK(stars > 50);
}

TEST_CASE("depths are nearest_depth / z at rest, and there are none for an eye that moves") {
    const render::EglContext context;
    const content::SceneDesc scene = xr_kit::shining_ball({0.0, 0.0, -2.0}, 0.5);
    for (const render::Method method : {render::Method::ray, render::Method::plain}) {
        render::Renderer renderer(scene, {method});
        render::RenderFrame frame;
        frame.eye.width = frame.eye.height = 64;
        frame.keep_depth = true;
        const engine::Offscreen target(64, 64);
        const render::Texture depths = render::Texture::create(GLenum{GL_TEXTURE_2D});
        glTextureStorage2D(depths.name(), 1, GL_DEPTH_COMPONENT32F, 80, 80);
        renderer.draw(frame, target.framebuffer(), {0, 0, 64, 64});
        REQUIRE(renderer.copy_depth(depths.name()));
        std::vector<float> values(80 * 80);
        glGetTextureImage(depths.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(4 * values.size()),
                          values.data());
        // The ball's nearest point is 1.5 m ahead; its facets and the pixel's half make millimetres of it.
        CHECK(values[32 * 80 + 32] == Catch::Approx(render::nearest_depth / 1.5).epsilon(0.005));
        CHECK(values[32 * 80 + 2] == 0.0f);
        frame.eye.world_from_head =
            sim::world_from_looking<sim::Head>(sim::Rapidity(0.1), {0.0, 0.0, -1.0}, {0.0, 0.0, -1.0});
        if (method == render::Method::ray) { // plain draws nothing but eyes at rest
            renderer.draw(frame, target.framebuffer(), {0, 0, 64, 64});
            CHECK_FALSE(renderer.copy_depth(depths.name()));
        }
    }
}

TEST_CASE("eyes of a moving head are simultaneous in the head's own frame") {
    // Light goes 2 m/s here, and the head moves sideways at half of that, along its eyes.
    constexpr double metres_per_light_unit = 2.0;
    const input::XrEyes eyes = human_eyes();
    const std::array<engine::EyeScreen, 2> screens = engine::eye_screens(eyes, 896, 1007);
    input::XrMotion head;
    head.place.position = {0.2, 0.0, 0.0};
    head.velocity = {1.0, 0.0, 0.0};
    head.tracked = true;
    const sim::ControlFrame demand = input::with_head({}, head, {metres_per_light_unit, 1.0});
    CHECK(demand.head_position.x == Catch::Approx(0.1));
    CHECK(demand.head_velocity.x == Catch::Approx(0.5));
    const std::array<render::EyeView, 2> views =
        engine::eye_views(sim::VehicleState(), demand, metres_per_light_unit, eyes, screens);
    const double gamma = 1.0 / std::sqrt(1.0 - 0.25);
    // Seen from the ship's frame the eyes' simultaneous events are gamma times as far apart.
    CHECK(views[1].position.x - views[0].position.x == Catch::Approx(gamma * 0.063).epsilon(1e-12));
    CHECK(0.5 * (views[0].position.x + views[1].position.x) == Catch::Approx(0.2).epsilon(1e-12));
    // And each eye moves with the head: rapidity atanh(0.5).
    CHECK(sim::rapidity(views[0].world_from_head).value == Catch::Approx(std::atanh(0.5)).epsilon(1e-12));
}

TEST_CASE("a slow pace makes the head's velocity no smaller than it is, and nobody's head outruns light") {
    input::XrMotion head;
    head.velocity = {3.0, 0.0, 4.0};
    // Half a second of ship time a second: what moves 5 m in the pilot's second moves 10 m in the ship's.
    CHECK(glm::length(input::with_head({}, head, {100.0, 0.5}).head_velocity) == Catch::Approx(0.1));
    const sim::ControlFrame fast = input::with_head({}, head, {1.0, 1.0});
    CHECK(glm::length(fast.head_velocity) == Catch::Approx(input::fastest_head));
    CHECK(fast.head_velocity.x / fast.head_velocity.z == Catch::Approx(0.75));
}
