#pragma once

#include "content/traced/toml_fields.h"
#include "content/traced/traced_scenario.h"

/// The fields of each table of a traced scenario, for FieldReader and FieldLister alike.
namespace content {

inline constexpr std::string_view length_unit = "length unit";

template <class Fields>
void camera_moment_fields(Fields& f, CameraMoment& moment) {
    f("position", moment.position, length_unit, "where the camera is, chart");
    f("time", moment.time, length_unit, "coordinate time of the picture");
    f("look", moment.look, "", "direction of the view, chart axes; zero: towards the chart's origin");
}

template <class Fields>
void camera_fields(Fields& f, TracedCamera& camera) {
    f("projection",
      OneOf<Projection>{camera.projection,
                        {{"perspective", Projection::perspective},
                         {"fisheye", Projection::fisheye},
                         {"equirectangular", Projection::equirectangular}}},
      "", "a plane screen, an equidistant fisheye, or the whole sky as panoramas are laid out");
    f("field_of_view", Degrees{camera.field_of_view}, "degrees", "width of the picture",
      FieldRange{1e-6, 360.0, true, true});
    f("observer",
      OneOf<ObserverKind>{camera.observer,
                          {{"at_rest", ObserverKind::at_rest},
                           {"zero_angular_momentum", ObserverKind::zero_angular_momentum},
                           {"circular", ObserverKind::circular},
                           {"free_falling", ObserverKind::free_falling}}},
      "", "at rest in the chart, with zero angular momentum, on a circular orbit, or falling from rest far away");
    f("velocity", camera.velocity, "c", "of the camera relative to that observer, chart axes, shorter than 1");
    f("up", NotZero{camera.up}, "", "upwards, chart axes");
    camera_moment_fields(f, camera.moment);
}

template <class Fields>
void sky_fields(Fields& f, TracedSky& sky) {
    f("panorama_scale", sky.panorama_scale, "", "factor on the panorama's radiance", positive_number);
    f("panorama_turn", Degrees{sky.panorama_turn}, "degrees", "turns the panorama about the up axis",
      FieldRange{-360.0, 360.0, true, true});
    f("checkerboard", Degrees{sky.checkerboard}, "degrees", "side of squares of directions; 0: none",
      FieldRange{0.0, 90.0, true, true});
    f("stars", sky.stars, "", "shows the star catalogue as points, in the world's directions");
    f("star_scale", sky.star_scale, "", "factor on the stars' light", positive_number);
    f("colour", sky.colour, "radiance", "light of a sky without panorama and checkerboard", not_negative_number);
}

template <class Fields>
void disk_fields(Fields& f, TracedDisk& disk) {
    f("inner_radius", disk.inner_radius, length_unit, "0: the innermost stable circular orbit", not_negative_number);
    f("outer_radius", disk.outer_radius, length_unit, "where the disk ends", positive_number);
    f("peak_temperature", disk.peak_temperature, "K", "of the hottest ring, as its own matter sees it",
      FieldRange{100.0, 1e9, true, true});
    f("brightness", disk.brightness, "", "factor on the radiance; 1: a black body at 5762 K has radiance 1",
      positive_number);
    f("retrograde", disk.retrograde, "", "turns against the spin");
    f("texture", disk.texture, "", "depth of streaks in its brightness", FieldRange{0.0, 1.0, true, true});
}

template <class Fields>
void sphere_fields(Fields& f, TracedSphere& sphere) {
    f("name", sphere.name, "", "for messages");
    f("centre", sphere.centre, length_unit, "chart; on a world line its place at time 0");
    f("radius", sphere.radius, length_unit, "coordinate radius", positive_number);
    f("velocity", sphere.velocity, "c", "coordinate velocity");
    f("reflectance", sphere.reflectance, "", "linear sRGB", FieldRange{0.0, 1.0, true, true});
    f("emission", sphere.emission, "radiance", "linear sRGB", not_negative_number);
    f("temperature", sphere.temperature, "K", "radiates as a black body; 0: does not",
      FieldRange{0.0, 1e9, true, true});
    f("checkerboard", Degrees{sphere.checkerboard}, "degrees", "squares of latitude and longitude; 0: none",
      FieldRange{0.0, 90.0, true, true});
    f("texture", sphere.texture, "", "generated:planet, or an equirectangular picture");
    f("axis", NotZero{sphere.axis}, "", "north of the texture, chart axes");
    f("turn", Degrees{sphere.turn}, "degrees", "of the texture about its axis");
}

template <class Fields>
void model_fields(Fields& f, TracedModel& model) {
    f("name", model.name, "", "for messages");
    f("scale", model.scale, "", "chart lengths in a metre of the model", positive_number);
    f("position", model.position, length_unit, "of the model's origin, where it has no path");
    f("look", NotZero{model.look}, "", "where the model's -z points, chart axes");
    f("up", NotZero{model.up}, "", "where its +y points, as near as can be");
}

template <class Fields>
void world_line_fields(Fields& f, WorldLinePoint& point) {
    f("time", point.time, length_unit, "coordinate time of passing here");
    f("position", point.position, length_unit, "chart");
}

template <class Fields>
void light_fields(Fields& f, TracedLight& light) {
    f("direction", NotZero{light.direction}, "", "towards the light, chart axes");
    f("irradiance", light.irradiance, "radiance x sr", "pi gives a white surface square to it radiance 1",
      not_negative_number);
    f("ambient", light.ambient, "radiance", "of a white surface under all other light", not_negative_number);
    f("temperature", light.temperature, "K", "black body that lights the scene, for Doppler shifts",
      FieldRange{1000.0, 100000.0, true, true});
}

template <class Fields>
void exposure_fields(Fields& f, TracedScenario& scenario) {
    f("automatic", scenario.automatic_exposure, "", "adapts to the picture");
    f("stops", scenario.exposure_stops, "log2", "manual exposure, or compensation of the automatic one",
      FieldRange{-60.0, 60.0, true, true});
}

} // namespace content
