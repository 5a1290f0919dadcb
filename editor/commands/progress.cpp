#include "commands/progress.h"

#include <unistd.h>

#include <csignal>
#include <iostream>

#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int) {
    interrupted = 1;
}

}  // namespace

Progress::Progress(std::string what, int steps)
    : what_(std::move(what)), steps_(steps), terminal_(::isatty(STDERR_FILENO) == 1) {
    interrupted = 0;
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    std::signal(SIGHUP, interrupt);
}

Progress::~Progress() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    if (terminal_) std::cerr << "\r\033[K" << std::flush;
}

void Progress::step() {
    if (interrupted != 0)
        throw Error(
            Failure::runtime,
            Fault{.file = "", .place = what_, .reason = "interrupted after " + std::to_string(percent()) + " %"});
    ++done_;
    if (terminal_) {
        std::cerr << '\r' << what_ << ' ' << done_ << " of " << steps_ << " (" << percent() << " %)\033[K"
                  << std::flush;
    }
}

int Progress::percent() const {
    return steps_ > 0 ? 100 * done_ / steps_ : 100;
}

void Progress::to(double share) {
    if (interrupted != 0) step();
    while (done_ < static_cast<int>(share * steps_)) step();
}

}  // namespace lapfx::commands
