#include "render/colour/scene_colour.h"
#include "render/moving/seen_ships.h"
#include "render/offline/reference.h"
#include "render/raycast/ray_caster.h"
#include "tests/render/ship_kit.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace ship_kit;

namespace {

render::Picture reference(const content::SceneDesc& scene, render::RenderFrame frame,
                          render::Layer layer = render::Layer::light) {
    frame.layer = layer;
    return render::ReferenceRenderer(scene).render(frame, 1);
}

render::Picture cast(const content::SceneDesc& scene, render::RenderFrame frame,
                     render::Layer layer = render::Layer::light) {
    frame.layer = layer;
    const render::SceneColour colour(scene);
    return render::RayCaster(scene, colour).picture(frame, 1);
}

double mean_difference(const render::Picture& a, const render::Picture& b) {
    double difference = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        difference += std::abs(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i]));
        all += std::abs(static_cast<double>(a.values[i]));
    }
    return difference / all;
}

/// Where a lamp on a ship is seen, pixels, and its D, in closed form.
struct LampSeen {
    double x;
    double wavelength_ratio;
};
LampSeen lamp_seen(const sim::VehicleState& ship, double z, const render::RenderFrame& frame) {
    const double metres = frame.moving.metres_per_light_unit;
    const sim::FourVector<sim::World> u = sim::four_velocity(ship.world_from_vehicle);
    const sim::Event lamp =
        ship.event + ship.world_from_vehicle * sim::FourVector<sim::Vehicle>{0.0, {0, 0, z / metres}};
    const glm::dvec3 velocity = u.space / u.t;
    const sim::Emission seen = sim::retarded_emission({lamp.space - lamp.t * velocity, velocity},
                                                      {frame.moving.world_time, frame.eye.position / metres});
    // The eye looks along +x with z to its right.
    return {0.5 * frame.eye.width + 0.5 * frame.eye.width * seen.from.unit.z / seen.from.unit.x, seen.wavelength_ratio};
}

} // namespace

TEST_CASE("a ship that passes looks as it does at rest to an eye that passes it") {
    const content::SceneDesc model = glowing_ship();
    const content::SceneDesc nothing = empty_scene();
    content::SceneDesc standing = model;
    standing.gradient_sky = nothing.gradient_sky;
    for (const double beta : {0.5, 0.9}) {
        sim::VehicleState ship;
        render::RenderFrame frame = passing_frame(beta, model, ship);
        frame.mode = render::Mode::full;
        const render::RenderFrame other = in_ships_frame(frame, ship);
        const render::Picture expected = reference(standing, other);
        // Two routes in double precision: they part only where a ray grazes an edge by roundings.
        CHECK(mean_difference(expected, reference(nothing, frame)) < 1e-3);
        // Between its vertices the seen shape and its D are linear: pieces of 0.4 m at 12 m.
        CHECK(mean_difference(expected, cast(nothing, frame)) < 0.02);
        const render::Picture objects = reference(standing, other, render::Layer::object);
        CHECK(disagreement(objects, reference(nothing, frame, render::Layer::object), 0, 0) < 1e-3);
        CHECK(disagreement(objects, cast(nothing, frame, render::Layer::object), 0, 0) < 0.005);
        const render::Picture ratios = reference(standing, other, render::Layer::doppler);
        const render::Picture cast_ratios = cast(nothing, frame, render::Layer::doppler);
        double off = 0.0;
        double all = 0.0;
        for (std::size_t i = 0; i < objects.values.size(); ++i) {
            if (objects.values[i] >= 0.0f && cast_ratios.values[i] != 1.0f) {
                off += std::abs(double{cast_ratios.values[i]} / double{ratios.values[i]} - 1.0) > 0.01 ? 1.0 : 0.0;
                all += 1.0;
            }
        }
        // D varies by 0.9/12 a metre, quadratically between vertices; at its inner edges (some hundredths
        // of its pixels) a ray may meet another part of the ship.
        CHECK(off < 0.03 * all);
    }
}

TEST_CASE("lamps on a passing ship are seen apart, and shifted, as closed forms say") {
    const content::SceneDesc model = two_lamps();
    const content::SceneDesc nothing = empty_scene();
    for (const double beta : {0.0, 0.5, 0.9}) {
        sim::VehicleState ship;
        render::RenderFrame frame = passing_frame(beta, model, ship);
        const LampSeen front = lamp_seen(ship, -4.0, frame);
        const LampSeen back = lamp_seen(ship, 4.0, frame);
        const auto middle = static_cast<int>(0.5 * (front.x + back.x));
        for (const bool truth : {true, false}) {
            const render::Picture picture = truth ? reference(nothing, frame) : cast(nothing, frame);
            const Spot left = spot_in(picture, 0, middle);
            const Spot right = spot_in(picture, middle, frame.eye.width);
            REQUIRE(left.pixels > 5);
            REQUIRE(right.pixels > 5);
            // A lamp of a dozen pixels: its middle rounds by a few tenths, and a circle's is not its centre's.
            CHECK_THAT(left.x, WithinAbs(front.x, 0.4));
            CHECK_THAT(right.x, WithinAbs(back.x, 0.4));
            frame.layer = render::Layer::doppler;
            const render::Picture ratios = truth ? reference(nothing, frame, render::Layer::doppler)
                                                 : cast(nothing, frame, render::Layer::doppler);
            // D changes by 3 % over the lamp's own width at the most.
            CHECK_THAT(scene_kit::value_at(ratios, static_cast<int>(left.x), 90),
                       WithinRel(front.wavelength_ratio, 0.03));
            CHECK_THAT(scene_kit::value_at(ratios, static_cast<int>(right.x), 90),
                       WithinRel(back.wavelength_ratio, 0.03));
        }
        // Seen when its light from abeam arrives, the ship's length is contracted, and it is turned by asin(beta): to
        // first order in 4 m / 12 m the lamps are 8/gamma m apart.
        const double apart_metres = (back.x - front.x) / 160.0 * 12.0;
        CHECK_THAT(apart_metres, WithinRel(8.0 * std::sqrt(1.0 - beta * beta), 0.15));
    }
}

TEST_CASE("a ship under thrust and turn is painted by vertices as rays into its rest frame find it") {
    const content::SceneDesc model = content::generator::generate_model("ship");
    content::SceneDesc scene = empty_scene();
    scene.ambient = glm::vec3(0.5f, 0.6f, 0.7f);
    scene.sun.emplace();
    constexpr double metres = 20.0;
    sim::VehicleState state = coasting({14.0, 0.0, 40.0}, 0.3, {0.0, 0.0, -1.0}, metres);
    auto line = std::make_shared<sim::ShipWorldLine>(state);
    for (int i = 0; i < 720; ++i) {
        state = sim::step(state, sim::ProperTime(1.0 / 240.0), {{0.1, 0.0, -0.6}, {0.0, 0.3, 0.9}});
        line->extend(state);
    }
    const glm::dvec3 heading(0.6, 0.0, -0.8);
    for (const double time : {2.6, 3.0}) {
        const glm::dvec3 seen_from = sim::where_seen(sim::boosted_eye(std::tanh(0.6) * heading),
                                                     line->seen(glm::dvec3(0.0), {time, glm::dvec3(0.0)}).from)
                                         .head_direction;
        render::RenderFrame frame = scene_kit::frame(0.6, heading, seen_from, 320, 180);
        frame.mode = render::Mode::full;
        frame.eye.horizontal_field_of_view = 0.8;
        add_ship(frame, model, line, time, metres);
        const render::Picture objects = reference(scene, frame, render::Layer::object);
        CHECK(std::count_if(objects.values.begin(), objects.values.end(), [](float v) { return v >= 0.0f; }) > 200);
        // A ship of some 50 pixels' length has an outline of a fifth of its pixels; a hundredth is a 20th of a pixel.
        CHECK(disagreement(objects, cast(scene, frame, render::Layer::object), 0, 0) < 0.02);
        CHECK(mean_difference(reference(scene, frame), cast(scene, frame)) < 0.05);
    }
}

TEST_CASE("scenery hides ships, and ships hide scenery") {
    content::SceneDesc scene = empty_scene();
    scene_kit::add(scene, scene_kit::rectangle({6.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, {0.0f, 1.0f, 0.0f}),
                   scene_kit::unlit({0.0f, 1.0f, 0.0f}));
    scene_kit::add(scene, scene_kit::rectangle({30.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 50.0f}, {0.0f, 50.0f, 0.0f}),
                   scene_kit::unlit({0.0f, 0.0f, 1.0f}));
    sim::VehicleState ship;
    render::RenderFrame frame = passing_frame(0.5, glowing_ship(), ship);
    const render::Picture truth = reference(scene, frame, render::Layer::object);
    const render::Picture live = cast(scene, frame, render::Layer::object);
    CHECK(scene_kit::value_at(truth, 160, 90) == 0.0); // the near board
    CHECK(scene_kit::value_at(live, 160, 90) == 0.0);
    CHECK(disagreement(truth, live, 2, 2) < 0.01);
    CHECK(std::count(truth.values.begin(), truth.values.end(), 2.0f) > 300); // the ship, before the wall
}

TEST_CASE("a ship's flames burn by its thrust") {
    const render::ShipBody body = render::make_ship_body(content::generator::generate_model("ship"));
    const auto stern = [&](double thrust) {
        const render::BodyShape shape = render::shape_under_thrust(body, thrust);
        double z = 0.0;
        for (const auto& triangle : shape.triangles) {
            for (const std::uint32_t vertex : triangle) {
                z = std::max(z, shape.points[body.vertices[vertex].point].z);
            }
        }
        return z;
    };
    CHECK_THAT(stern(0.0), WithinAbs(5.75, 0.1)); // the nozzles' rim
    CHECK_THAT(stern(0.5), WithinAbs(5.75 + 2.5, 1e-3));
    CHECK_THAT(stern(1.0), WithinAbs(5.75 + 5.0, 1e-3));
    CHECK(render::shape_under_thrust(body, -1.0).triangles.size() >
          render::shape_under_thrust(body, 0.0).triangles.size());
}
