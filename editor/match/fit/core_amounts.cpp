#include "match/fit/core_amounts.h"

namespace lapfx::match {

std::vector<Amounts> CoreAmounts::at(const Tuned& tuned, std::span<const double> times) {
    if (!model_ || gravity_ != tuned.scene.gravity) {
        gravity_ = tuned.scene.gravity;
        model_ = std::make_unique<AmountsModel>(organ_, AmountsOptions{.gravity = gravity_});
    }
    model_->set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    std::vector<Amounts> amounts;
    for (const double time : times) amounts.push_back(model_->at(time));
    ++evaluations_;
    return amounts;
}

}  // namespace lapfx::match
