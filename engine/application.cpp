#include "engine/application.h"

#include "engine/commands/commands.h"
#include "engine/failure.h"
#include "sim/arithmetic.h"
#include "sim/bad_input.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <exception>
#include <fmt/core.h>

namespace engine {

int run_application(int argc, const char* const* argv) {
    // Before anything is computed: no number of a build with other arithmetic can be trusted, and no recording replays.
    if (const std::string_view trouble = sim::arithmetic_trouble(); !trouble.empty()) {
        fmt::print(stderr, "rapidity: {}\n", trouble);
        return 1;
    }
    CLI::App application("Rapidity: fly near the speed of light and see what a real eye would see", "rapidity");
    application.require_subcommand(1);
    add_version_command(application);
    add_doctor_command(application);
    add_render_command(application);
    add_probe_command(application);
    add_trace_command(application);
    add_simulate_command(application);
    add_plan_command(application);
    add_verify_command(application);
    add_fly_command(application);
    add_bench_command(application);
    add_scenes_command(application);
    add_import_stars_command(application);
    add_replay_command(application);
    add_film_command(application);
    add_recover_command(application);
    add_generate_command(application);
    add_geodesic_command(application);
    add_spacetimes_command(application);

    try {
        application.parse(argc, argv);
        return 0;
    } catch (const CLI::ParseError& error) {
        return application.exit(error) == 0 ? 0 : 2;
    } catch (const sim::BadInput& error) {
        fmt::print(stderr, "rapidity: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "rapidity: {}\n", error.what());
        return 1;
    }
}

} // namespace engine
