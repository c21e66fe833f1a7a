#include "engine/trace/interruption.h"

#include <csignal>

namespace engine {
namespace {

// The one thing that a signal handler may touch.
volatile std::sig_atomic_t interrupted = 0;

void note_signal(int signal) {
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interruption::Interruption() {
    interrupted = 0;
    std::signal(SIGINT, &note_signal);
    std::signal(SIGTERM, &note_signal);
}
Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}
bool Interruption::wanted() {
    return interrupted != 0;
}

} // namespace engine
