#include "app/preview/scene_pace.h"

#include <algorithm>
#include <cmath>

namespace lapfx::app {

void ScenePace::expect(double seconds) {
    if (known_) return;
    step_ = 0;
    while (step_ + 1 < steps.size() && seconds * steps[step_] * steps[step_] > budget) ++step_;
}

bool ScenePace::due(double now) const {
    if (!touched(now)) return true;
    return now >= ended_ + (touched_ == now ? 2 : 1) * cost_;
}

double ScenePace::due_at(double now) const {
    return due(now) ? now : std::min(ended_ + cost_, touched_ + rest);
}

void ScenePace::drawn(double begin, double end) {
    coarse_ = touched(begin) && step_ > 0;
    if (!touched(begin)) return;
    known_ = true;
    cost_ = end - begin;
    ended_ = end;
    // A step to more pixels costs about twice as much; to fewer pixels it takes as many steps at once as the cost asks
    // for.
    if (cost_ < 0.4 * budget && step_ > 0) {
        --step_;
        return;
    }
    for (double cost = cost_; cost > budget && step_ + 1 < steps.size(); ++step_)
        cost *= std::pow(steps[step_ + 1] / steps[step_], 2);
}

}  // namespace lapfx::app
