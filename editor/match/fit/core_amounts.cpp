#include "match/fit/core_amounts.h"

#include <algorithm>

namespace lapfx::match {

namespace {

constexpr std::size_t most_known = 8;

}  // namespace

CoreAmounts::BloodInputs CoreAmounts::inputs_of(const Tuned& tuned, std::span<const double> times) {
    BloodInputs inputs{.bleeding = tuned.preset.bleeding,
                       .vessels = tuned.preset.vessels,
                       .cautery = tuned.preset.cautery,
                       .contacts = tuned.scene.events,
                       .curves = tuned.scene.curves,
                       .gravity = tuned.scene.gravity,
                       .times = {times.begin(), times.end()}};
    inputs.curves.emission.clear();
    return inputs;
}

std::vector<Amounts> CoreAmounts::at(const Tuned& tuned, std::span<const double> times) {
    if (!model_ || gravity_ != tuned.scene.gravity) {
        gravity_ = tuned.scene.gravity;
        model_ = std::make_unique<AmountsModel>(organ_, AmountsOptions{.gravity = gravity_});
    }
    model_->set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    ++evaluations_;
    BloodInputs inputs = inputs_of(tuned, times);
    const auto known = std::find_if(known_.begin(), known_.end(), [&](const Worked& w) { return w.of == inputs; });
    if (known == known_.end()) {
        Worked worked{.of = std::move(inputs), .amounts = {}};
        for (const double time : times) worked.amounts.push_back(model_->at(time));
        known_.push_front(std::move(worked));
        if (known_.size() > most_known) known_.pop_back();
    } else {
        std::rotate(known_.begin(), known, known + 1);
    }
    std::vector<Amounts> amounts = known_.front().amounts;
    for (std::size_t i = 0; i < amounts.size(); ++i) {
        const SmokeAmounts smoke = model_->smoke_at(times[i]);
        amounts[i].haze = smoke.haze, amounts[i].emission = smoke.emission;
    }
    return amounts;
}

}  // namespace lapfx::match
