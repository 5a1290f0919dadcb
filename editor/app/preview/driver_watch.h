// Whether the graphics driver still works.
#pragma once

#include <optional>

#include "lapfx/error.h"

namespace lapfx::app {

class DriverWatch {
  public:
    /// Something was drawn: the next check() looks.
    void drawn() { unchecked_ = true; }
    /// Looks, at most once a second and only when there was something to draw. Gives a fault the first time that
    /// something is wrong. `now`: s. Render thread, context current.
    std::optional<Fault> check(double now);
    bool lost() const { return lost_; }  ///< the driver is lost for good: nothing can be drawn any more

  private:
    bool unchecked_ = false, lost_ = false;  // it has been drawn since the last check; the context is lost
    double checked_ = 0;                     // s
    unsigned told_error_ = 0;
};

}  // namespace lapfx::app
