// Long work: progress on a terminal, and a way out by Ctrl-C.
#pragma once

#include <string>

namespace lapfx::commands {

/// While one lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP do not end the process but make step() throw Error (runtime),
/// so that everything that was begun is undone on the way out.
class Progress {
  public:
    /// `what` as in "rendering". Prints to stderr, and only when that is a terminal.
    Progress(std::string what, int steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One step is done.
    void step();

  private:
    std::string what_;
    int steps_;
    int done_ = 0;
    bool terminal_;
};

}  // namespace lapfx::commands
