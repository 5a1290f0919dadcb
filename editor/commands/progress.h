// Progress of long work on a terminal, and a clean stop by Ctrl-C.
#pragma once

#include <string>

namespace lapfx::commands {

/// While an object lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP do not end the process but make step() throw Error
/// (runtime), so that destructors undo everything that was begun.
class Progress {
  public:
    /// `what` as in "rendering". Prints to stderr, and only when that is a terminal.
    Progress(std::string what, int steps);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// How many there are, where that is known only once something has been begun.
    void expect(int steps) { steps_ = steps; }
    /// One step is done.
    void step();
    /// The steps up to a share of all, 0..1; never back. Throws as step() also where there is none to do.
    void to(double share);

  private:
    int percent() const;

    std::string what_;
    int steps_;
    int done_ = 0;
    bool terminal_;
};

}  // namespace lapfx::commands
