#include "engine/commands/commands.h"

#include "content/spacetime_file.h"
#include "engine/option_values.h"
#include "sim/bad_input.h"
#include "sim/spacetime/bundle.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/world_line.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>
#include <memory>
#include <optional>

namespace engine {
namespace {

struct Options {
    std::string spacetime;
    std::vector<std::string> parameters;
    std::string position;
    std::string time = "0";
    std::string observer = "static";
    std::string velocity = "0,0,0";
    std::string look;
    std::string up = "0,0,1";
    std::string direction = "0,0,-1";
    std::string error = "1e-8";
    std::string kernel = "automatic";
    std::string fly;
    std::string thrust = "0,0,0";
    std::string turn = "0,0,0";
    bool magnification = false;
    bool json = false;
};

constexpr NamedValues<sim::ObserverKind, 4> observers{{{"static", sim::ObserverKind::at_rest},
                                                       {"zamo", sim::ObserverKind::zero_angular_momentum},
                                                       {"circular", sim::ObserverKind::circular_orbit},
                                                       {"falling", sim::ObserverKind::free_fall}}};
constexpr NamedValues<sim::RayKernel, 3> kernels{
    {{"automatic", sim::RayKernel::automatic}, {"generic", sim::RayKernel::generic}, {"mino", sim::RayKernel::mino}}};

glm::dvec3 vector_option(const std::string& option, const std::string& text) {
    const std::vector<double> parts = numbers_option(option, text, 3);
    return {parts[0], parts[1], parts[2]};
}

sim::ParameterValues parameter_values(const std::vector<std::string>& texts) {
    sim::ParameterValues values;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) {
            throw sim::BadInput("--param", "", text, "must be NAME=NUMBER");
        }
        const std::string name = text.substr(0, equals);
        values[name] = number_option("--param " + name, text.substr(equals + 1));
    }
    return values;
}

/// One line of output: a JSON key and value, and the words for people.
struct Line {
    std::string key;
    std::string json;
    std::string words;
};

void print_lines(const std::vector<Line>& lines, bool json) {
    if (!json) {
        for (const Line& line : lines) {
            fmt::print("{:<22} {}\n", line.key, line.words);
        }
        return;
    }
    fmt::print("{{");
    for (std::size_t i = 0; i < lines.size(); ++i) {
        fmt::print("{}\n  \"{}\": {}", i == 0 ? "" : ",", lines[i].key, lines[i].json);
    }
    fmt::print("\n}}\n");
}

/// A number as JSON has it: null for none.
std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

Line number_line(const std::string& key, double value, const std::string& unit) {
    return {key, json_number(value), std::isfinite(value) ? fmt::format("{:.15g}{}", value, unit) : "none"};
}

Line text_line(const std::string& key, std::string_view text) {
    return {key, fmt::format("\"{}\"", text), std::string(text)};
}

Line vector_line(const std::string& key, std::initializer_list<double> values, const std::string& words) {
    std::string json, text;
    for (const double value : values) {
        json += (json.empty() ? "[" : ", ") + json_number(value);
        text += (text.empty() ? "" : ", ") + fmt::format("{:.15g}", value);
    }
    return {key, json + "]", text + words};
}

template <class Spacetime>
sim::Tetrad tetrad_of(const Spacetime& spacetime, const sim::Components<double>& event, const Options& options) {
    if (spacetime.region(event) == sim::Region::singular) {
        throw sim::BadInput("--position", "", options.position,
                            "lies in a singularity or outside the chart of this spacetime");
    }
    const auto kind = named_option("--observer", options.observer, observers);
    const auto velocity = sim::observer_velocity(spacetime, event, kind);
    if (!velocity) {
        throw sim::BadInput("--observer", "", options.observer,
                            "there is no such observer at this position (within a horizon, an ergosphere or the orbit "
                            "of light, or off the plane z = 0)");
    }
    const glm::dvec3 place = sim::space(event);
    const double r = glm::length(place);
    const glm::dvec3 look = options.look.empty() ? (r > 0.0 ? -place / r : glm::dvec3(1.0, 0.0, 0.0))
                                                 : direction_option("--look", options.look);
    glm::dvec3 up = direction_option("--up", options.up);
    if (glm::length(glm::cross(look, up)) < 1e-6) {
        if (options.up != Options().up) {
            throw sim::BadInput("--up", "", options.up, "must not lie along the look");
        }
        up = {1.0, 0.0, 0.0};
    }
    const glm::dvec3 beta = vector_option("--velocity", options.velocity);
    if (!(glm::length(beta) < 1.0)) {
        throw sim::BadInput("--velocity", "", options.velocity, "must be slower than light");
    }
    return sim::boosted(sim::camera_tetrad(spacetime, event, *velocity, look, up), beta);
}

template <class Spacetime>
void trace(const Spacetime& spacetime, const sim::Components<double>& event, const Options& options) {
    const sim::Tetrad tetrad = tetrad_of(spacetime, event, options);
    const glm::dvec3 seen = direction_option("--direction", options.direction);
    const double error = number_option("--error", options.error, 1e-14, 1.0);
    const auto kernel = named_option("--kernel", options.kernel, kernels);
    const auto hole = sim::mino_hole(spacetime);
    if (kernel == sim::RayKernel::mino && !(hole && sim::fits_mino(*hole, event))) {
        throw sim::BadInput("--kernel", "", options.kernel, "serves eyes outside a black hole only");
    }
    const sim::MeasuredRay measured = sim::measure_ray(spacetime, event, tetrad, seen, error, {}, kernel);
    const sim::RayResult& ray = measured.ray;
    const bool escaped = ray.outcome == sim::RayOutcome::escaped;
    std::vector<Line> lines{text_line("outcome", name_of(ray.outcome)),
                            text_line("kernel", sim::RayKernel::mino == measured.kernel ? "mino" : "generic")};
    if (escaped) {
        const glm::dvec3& n = ray.infinity.direction;
        lines.push_back(vector_line("comes_from", {n.x, n.y, n.z}, "  (direction at infinity, chart's axes)"));
        if (ray.infinity.side != 1) {
            lines.push_back(text_line("side", "far side of the wormhole"));
        }
        lines.push_back(number_line("frequency_ratio", ray.frequency_ratio(), "  (nu here/nu at infinity)"));
    }
    lines.push_back(number_line("swept_angle", measured.swept_angle, " rad"));
    lines.push_back({"steps", fmt::format("{}", ray.steps), fmt::format("{}", ray.steps)});
    lines.push_back(number_line("error_estimate", ray.error, " rad"));
    lines.push_back(number_line("hamiltonian_drift", ray.hamiltonian_drift, ""));
    if (measured.kernel == sim::RayKernel::generic) {
        for (std::size_t i = 0; i < Spacetime::conserved_names.size(); ++i) {
            lines.push_back(number_line(fmt::format("drift of {}", Spacetime::conserved_names[i]), ray.drifts[i], ""));
        }
    }
    if (options.magnification && escaped) {
        sim::RaySettings settings;
        settings.step = 0.02;
        const sim::RayBundle bundle = sim::trace_bundle(spacetime, event, tetrad, seen, settings);
        lines.push_back(number_line("magnification", bundle.magnification(), bundle.mirrored() ? "  (mirrored)" : ""));
    }
    print_lines(lines, options.json);
}

template <class Spacetime>
void fly(const Spacetime& spacetime, const sim::Components<double>& event, const Options& options) {
    const sim::WorldLineState start{event, tetrad_of(spacetime, event, options)};
    const double proper_time = number_option("--fly", options.fly, 1e-12, 1e9);
    const glm::dvec3 thrust = vector_option("--thrust", options.thrust);
    const glm::dvec3 turn = vector_option("--turn", options.turn);
    const double error = number_option("--error", options.error, 1e-14, 1.0);
    // The step halves until two flights end as close as asked.
    std::optional<sim::WorldLineState> before;
    double difference = std::numeric_limits<double>::infinity();
    int steps = 0;
    bool ended_early = false;
    for (int count = 64; count <= (1 << 20) && !(difference <= error) && !ended_early; count *= 2) {
        sim::WorldLineState state = start;
        for (steps = 0; steps < count && !ended_early; ++steps) {
            state = sim::advance_observer(spacetime, state, thrust, turn, proper_time / count);
            ended_early = spacetime.region(state.event) == sim::Region::singular ||
                          !std::isfinite(sim::chart_radius(state.event));
        }
        if (before && !ended_early) {
            const auto apart = state.event - before->event;
            difference = 2.0 / 15.0 * std::max(std::abs(apart.t), sim::chart_radius(apart));
        }
        before = state;
    }
    const sim::WorldLineState& end = *before;
    const sim::GeodesicState<double> body{end.event, spacetime.metric(end.event) * end.tetrad.legs[0]};
    const auto& u = end.tetrad.legs[0];
    std::vector<Line> lines{
        text_line("outcome", ended_early ? "left-chart" : "arrived"),
        vector_line("event", {end.event.t, end.event.x, end.event.y, end.event.z}, "  (t, x, y, z)"),
        vector_line("four_velocity", {u.t, u.x, u.y, u.z}, ""),
        {"steps", fmt::format("{}", steps), fmt::format("{}", steps)},
        number_line("error_estimate", difference, "  (of the event)"),
        number_line("orthonormality_drift", sim::orthonormality_drift(spacetime, end), "")};
    const auto conserved = spacetime.conserved(body);
    for (std::size_t i = 0; i < conserved.size(); ++i) {
        lines.push_back(number_line(Spacetime::conserved_names[i], conserved[i], ""));
    }
    print_lines(lines, options.json);
}

void run(const Options& options) {
    const sim::AnySpacetime spacetime =
        content::spacetime_of("--spacetime", options.spacetime, parameter_values(options.parameters));
    const glm::dvec3 place = vector_option("--position", options.position);
    const sim::Components<double> event{number_option("--time", options.time), place.x, place.y, place.z};
    std::visit(
        [&](const auto& chosen) {
            if (options.fly.empty()) {
                trace(chosen, event, options);
            } else {
                fly(chosen, event, options);
            }
        },
        spacetime);
}

} // namespace

void add_geodesic_command(CLI::App& application) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = application.add_subcommand(
        "geodesic", "follow one ray of light from an eye to where it comes from, or one ship, with its error");
    command->group("Curved spacetime");
    command->add_option("--spacetime", options->spacetime, "name (rapidity spacetimes lists them) or FILE.toml")
        ->required();
    command->add_option("--param", options->parameters, "NAME=NUMBER, a parameter of the spacetime; repeat for more");
    command->add_option("--position", options->position, "x,y,z of the eye in the chart")->required();
    command->add_option("--time", options->time, "t of the eye")->capture_default_str();
    command->add_option("--observer", options->observer, "static, zamo, circular or falling")->capture_default_str();
    command
        ->add_option("--velocity", options->velocity,
                     "right,up,back in c: the eye's own, against that observer; axes carried over by the boost")
        ->capture_default_str();
    command->add_option("--look", options->look, "x,y,z along which the eye looks; default towards the origin");
    command->add_option("--up", options->up, "x,y,z that the eye holds upwards")->capture_default_str();
    command->add_option("--direction", options->direction, "right,up,back: where the light is seen")
        ->capture_default_str();
    command->add_option("--error", options->error, "the step is halved until the estimated error is below this, rad")
        ->capture_default_str();
    command->add_option("--kernel", options->kernel, "automatic, generic or mino")->capture_default_str();
    command->add_flag("--magnification", options->magnification, "with the ray bundle's magnification");
    command->add_option("--fly", options->fly, "instead of light, the observer's own world line for this proper time");
    command->add_option("--thrust", options->thrust, "right,up,back: proper acceleration of --fly")
        ->capture_default_str();
    command->add_option("--turn", options->turn, "right,up,back: angular velocity of --fly")->capture_default_str();
    command->add_flag("--json", options->json, "print JSON");
    command->callback([options] { run(*options); });
}

} // namespace engine
