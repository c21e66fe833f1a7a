#include "engine/commands/bench.h"

#include "engine/commands/commands.h"

namespace engine {

void add_bench_command(CLI::App& application) {
    CLI::App* bench = application.add_subcommand("bench", "measure speed and accuracy; prints numbers");
    bench->group("Proof");
    bench->require_subcommand(1);
    add_bench_tick(*bench);
    add_bench_observer(*bench);
    add_bench_hard_cases(*bench);
    add_bench_pictures(*bench);
    add_bench_recording(*bench);
    add_bench_white(*bench);
    add_bench_frame(*bench);
    add_bench_cockpit(*bench);
    add_bench_warp(*bench);
    add_bench_geodesics(*bench);
    add_bench_colour(*bench);
    add_bench_light(*bench);
    add_bench_vr(*bench);
}

} // namespace engine
