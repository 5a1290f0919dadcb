#include "match/scene/core_amounts.h"

#include <algorithm>
#include <future>
#include <utility>

namespace lapfx::match {

namespace {

constexpr std::size_t most_known = 40;  // more than one search asks for at once

std::vector<Amounts> amounts_of(AmountsModel& model, std::span<const double> times) {
    std::vector<Amounts> amounts;
    for (const double time : times) amounts.push_back(model.at(time));
    return amounts;
}

}  // namespace

CoreAmounts::BloodInputs CoreAmounts::inputs_of(const document::Content& tuned, std::span<const double> times) {
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

/// As the latest.
const CoreAmounts::BloodWorkedOut* CoreAmounts::known(const BloodInputs& inputs) {
    const auto found =
        std::find_if(known_.begin(), known_.end(), [&](const BloodWorkedOut& w) { return w.of == inputs; });
    if (found == known_.end()) return nullptr;
    std::rotate(known_.begin(), found, found + 1);
    return &known_.front();
}

void CoreAmounts::keep(BloodWorkedOut worked) {
    ++worked_out_;
    known_.push_front(std::move(worked));
    if (known_.size() > most_known) known_.pop_back();
}

AmountsModel& CoreAmounts::set(Model& model, const document::Content& tuned) const {
    if (!model.model || model.gravity != tuned.scene.gravity) {
        model.gravity = tuned.scene.gravity;
        model.model = std::make_unique<AmountsModel>(organ_, AmountsOptions{.gravity = model.gravity});
    }
    model.model->set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    return *model.model;
}

std::vector<Amounts> CoreAmounts::at(const document::Content& tuned, std::span<const double> times) {
    AmountsModel& model = set(models_[0], tuned);
    ++evaluations_;
    BloodInputs inputs = inputs_of(tuned, times);
    if (!known(inputs)) keep({.of = std::move(inputs), .amounts = amounts_of(model, times)});
    std::vector<Amounts> amounts = known_.front().amounts;
    for (std::size_t i = 0; i < amounts.size(); ++i) model.smoke_at(times[i]).put_into(amounts[i]);
    return amounts;
}

void CoreAmounts::expect(std::span<const document::Content> scenes, std::span<const double> times) {
    std::vector<std::pair<const document::Content*, BloodWorkedOut>> wanted;
    for (const document::Content& tuned : scenes) {
        BloodInputs inputs = inputs_of(tuned, times);
        const auto same = [&](const auto& other) { return other.second.of == inputs; };
        if (wanted.size() < most_known && !known(inputs) && std::none_of(wanted.begin(), wanted.end(), same))
            wanted.emplace_back(&tuned, BloodWorkedOut{.of = std::move(inputs), .amounts = {}});
    }
    if (wanted.size() < 2) return;
    const auto work = [&](std::size_t of) {
        for (std::size_t i = of; i < wanted.size(); i += models_.size()) {
            try {
                wanted[i].second.amounts = amounts_of(set(models_[of], *wanted[i].first), times);
            } catch (const Error&) {  // at() throws it again
                wanted[i].first = nullptr;
            }
        }
    };
    std::future<void> beside = std::async(std::launch::async, work, std::size_t{1});
    work(0);
    beside.get();
    for (auto& [tuned, worked] : wanted)
        if (tuned != nullptr) keep(std::move(worked));
}

}  // namespace lapfx::match
