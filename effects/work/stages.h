// Progress through work that has parts, and the way out of it.
//
//     const Stages stages(progress);
//     load(path, stages.part(0.0, 0.4));
//     stages.reach(0.4);                  // throws Stopped when progress says so
#pragma once

#include "lapfx/progress.h"

namespace lapfx::work {

/// Thrown when the work is to stop. Never leaves the core.
struct Stopped {};

class Stages {
  public:
    Stages() = default;
    /// Keeps a reference to `progress`.
    explicit Stages(const Progress& progress) : progress_(progress ? &progress : nullptr) {}

    /// Tells that `share` of this work is done.
    void reach(double share) const {
        if (progress_ != nullptr && !(*progress_)(from_ + (to_ - from_) * share)) throw Stopped{};
    }
    /// A part of it that has shares of its own.
    Stages part(double from, double to) const {
        Stages inner = *this;
        inner.from_ = from_ + (to_ - from_) * from;
        inner.to_ = from_ + (to_ - from_) * to;
        return inner;
    }

  private:
    const Progress* progress_ = nullptr;
    double from_ = 0.0, to_ = 1.0;
};

}  // namespace lapfx::work
