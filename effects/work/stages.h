// Progress of work that has parts, and how to stop it.
//
//     const Stages stages(progress);
//     load(path, stages.part(0.0, 0.4));
//     stages.reach(0.4);                  // throws Stopped when progress says so
#pragma once

#include "lapfx/progress.h"

namespace lapfx::work {

/// Thrown when the work has to stop. It never leaves the core.
struct Stopped {};

class Stages {
  public:
    Stages() = default;
    /// Keeps a reference to `progress`.
    explicit Stages(const Progress& progress) : progress_(progress ? &progress : nullptr) {}

    /// Reports that `share` of this work is done.
    void reach(double share) const {
        if (progress_ != nullptr && !(*progress_)(from_ + (to_ - from_) * share)) throw Stopped{};
    }
    /// A part of the work with its own shares.
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
