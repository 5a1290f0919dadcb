// How long work still takes whose steps do not all take as long: at the pace of the last ones.
//
//     remaining.reached(now, share);   // whenever one looks
//     show(remaining.seconds(now));
//
// Any thread, one at a time.
#pragma once

#include <deque>

namespace lapfx::app {

class Remaining {
  public:
    static constexpr double window = 20.0;  ///< s that tell the pace
    static constexpr double least = 2.0;    ///< s of them before anything is said

    /// `now`: s, ascending; `share`: 0..1 of all that may have to be done.
    void reached(double now, double share);
    /// s until all of it is done; negative: not known yet.
    double seconds(double now) const;

  private:
    struct Step {
        double time = 0.0, share = 0.0;
    };
    std::deque<Step> steps_;  ///< the first one is the last before the window, or where it began
};

}  // namespace lapfx::app
