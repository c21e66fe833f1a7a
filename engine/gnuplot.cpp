#include "engine/gnuplot.h"

#include "engine/failure.h"
#include "engine/film.h"

#include <csignal>
#include <cstdio>
#include <memory>
#include <sys/wait.h>

namespace engine {

bool has_gnuplot() {
    return !program_on_path("gnuplot").empty();
}

void run_gnuplot(const std::string& script) {
    if (!has_gnuplot()) {
        throw Failure("no plot: gnuplot is not installed (Debian: apt-get install gnuplot-nox)");
    }
    struct Close {
        void operator()(std::FILE* pipe) const { pclose(pipe); }
    };
    std::unique_ptr<std::FILE, Close> pipe(popen("gnuplot", "w"));
    if (!pipe) {
        throw Failure("no plot: gnuplot does not start");
    }
    // gnuplot ends at the first error: that is a trouble to tell, not a signal to die of.
    auto* const handler_before = std::signal(SIGPIPE, SIG_IGN);
    std::fwrite(script.data(), 1, script.size(), pipe.get());
    const int status = pclose(pipe.release());
    std::signal(SIGPIPE, handler_before);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw Failure("no plot: gnuplot failed; what it said is above");
    }
}

std::string gnuplot_text(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? "''" : std::string(1, c);
    }
    return quoted + "'";
}

} // namespace engine
