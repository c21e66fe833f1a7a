#pragma once

#include "content/csv.h"
#include "tests/paths.h"
#include "tests/render/scene_kit.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <string>

/// Spheres as a moving eye sees them against sphere_outline.csv.
namespace scene_kit {

inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2.0 * std::atan2(glm::length(a - b), glm::length(a + b));
}

/// `object_picture(scene, frame)`: the object layer by the method under test.
template <class ObjectPicture>
void check_sphere_outlines(const ObjectPicture& object_picture) {
    const content::CsvTable table =
        content::read_csv(std::string(tests::source_folder()) + "/tests/reference/sphere_outline.csv");
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const double rapidity = table.number(row, table.column("rapidity"));
        const double centre_angle = table.number(row, table.column("theta_centre_world_rad"));
        const double sine = table.number(row, table.column("sin_half_angle_world"));
        const double axis_angle = table.number(row, table.column("axis_angle_observer_rad"));
        const double half_angle = table.number(row, table.column("half_angle_observer_rad"));
        CAPTURE(rapidity, centre_angle, sine);
        content::SceneDesc scene;
        const glm::dvec3 centre = 10.0 * glm::dvec3(std::sin(centre_angle), 0.0, -std::cos(centre_angle));
        add(scene, sphere(glm::vec3(centre), static_cast<float>(10.0 * sine), 512), unlit(glm::vec3(1.0f)));
        const glm::dvec3 axis(std::sin(axis_angle), 0.0, -std::cos(axis_angle));
        render::RenderFrame view = frame(rapidity, {0.0, 0.0, -1.0}, axis, 160, 160);
        view.eye.horizontal_field_of_view = 2.2 * half_angle;
        view.layer = render::Layer::object;
        const render::Picture objects = object_picture(scene, view);
        // The mesh lies inside the sphere by up to 1 - cos(pi/512) = 2e-5 of its radius; seen nearly edge-on along
        // the outline that moves the outline by as much of its angle, times the aberration's change of scale over it.
        const double tolerance = 1e-4 * half_angle;
        int wrong = 0;
        int inside = 0;
        for (int y = 0; y < 160; ++y) {
            for (int x = 0; x < 160; ++x) {
                const glm::dvec3 direction = render::head_direction_from_pixel(view.eye, x + 0.5, y + 0.5).unit;
                const double off_axis = angle_between(direction, {0.0, 0.0, -1.0});
                const bool hit = value_at(objects, x, y) == 0.0;
                inside += hit ? 1 : 0;
                wrong += std::abs(off_axis - half_angle) > tolerance && hit != (off_axis < half_angle) ? 1 : 0;
            }
        }
        CHECK(wrong == 0);
        CHECK(inside > 10000); // the circle fills pi/4 of a picture 1.1 times as wide, or a little less off the axis
    }
}

} // namespace scene_kit
