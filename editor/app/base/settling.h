// When something is to be done about changes: once they have rested for a while, or have gone on for long enough.
//
//     Settling settling{0.4};                                    // s
//     if (differs) settling.change(now);
//     if (settling.due_at(now)) begin();  else wake_at(settling.due());
//
// Time is an argument: s of any clock that goes forwards.
#pragma once

#include <algorithm>
#include <limits>

namespace lapfx::app {

class Settling {
  public:
    static constexpr double never = std::numeric_limits<double>::infinity();

    /// `rest`: s without a change before it is due. `at_most`: s after the first change, however they go on.
    explicit Settling(double rest, double at_most = never) : rest_(rest), at_most_(at_most) {}

    void change(double now) {
        if (due_ == never) latest_ = now + at_most_;
        due_ = std::min(now + rest_, latest_);
    }
    /// It is due then, and no change defers it.
    void set(double time) { due_ = latest_ = time; }
    /// It was done, or is not to be done any more.
    void clear() { due_ = never; }
    bool due_at(double now) const { return now >= due_; }
    /// s; `never`: nothing has changed since clear().
    double due() const { return due_; }

  private:
    double rest_, at_most_;
    double due_ = never, latest_ = never;
};

}  // namespace lapfx::app
