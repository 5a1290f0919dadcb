#include "app/measure/fitting_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/jobs.h"
#include "app/base/render_steps.h"
#include "match/fit/proposal.h"

namespace lapfx::app {

namespace {

// Of the progress: the amounts, where the colours are matched, too, and where they are only compared.
constexpr double amounts_beside_matching = 0.7, amounts_beside_comparing = 0.9;

}  // namespace

FittingRun::FittingRun(FitWanted wanted, match::PreviewCurve* curve, RenderSteps& steps, Jobs& jobs, bool beside)
    : wanted_(std::move(wanted)), curve_(curve), steps_(steps), jobs_(jobs) {
    if (beside)
        thread_ = std::thread([this] { work(); });
    else
        work();
}

FittingRun::~FittingRun() {
    cancelled_ = true;
    steps_.stop();
    if (thread_.joinable()) thread_.join();
}

std::shared_ptr<const FittingRun::Frames> FittingRun::best() const {
    const std::lock_guard lock(mutex_);
    return best_;
}

bool FittingRun::ended() const {
    const std::lock_guard lock(mutex_);
    return ended_;
}

std::optional<FitFound> FittingRun::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(found_, {});
}

std::vector<Fault> FittingRun::faults() const {
    const std::lock_guard lock(mutex_);
    return faults_;
}

void FittingRun::work() {
    std::vector<Fault> faults;
    std::optional<FitFound> found;
    try {
        found = find();
        const bool drawn = found->result && !found->result->after.empty();
        if (cancelled_ && !drawn) found.reset();  // before there was anything to show
    } catch (const Error& error) {
        faults = error.faults();
    } catch (const std::exception& error) {
        faults = {{.file = "", .place = "", .reason = error.what()}};
    }
    {
        const std::lock_guard lock(mutex_);
        found_ = std::move(found), faults_ = std::move(faults);
        ended_ = true;
    }
    jobs_.wake();
}

/// `share`: 0..1 of the curve that is being drawn.
bool FittingRun::drawing(double share) {
    return reached(share_ + share * (next_ - share_));
}

/// `share`: 0..1 of matching the colours, or comparing them.
bool FittingRun::matching(double share) {
    return reached(std::lerp(amounts_part_, 1.0, share));
}

/// A picture that is drawn once more does not take it back.
bool FittingRun::reached(double share) {
    progress_ = std::max(progress_.load(), share);
    return !cancelled_;
}

FitFound FittingRun::find() {
    FitFound found{.start = wanted_.start, .tuned = wanted_.start, .of = wanted_.of};
    found.parameters = match::free_parameters(found.start, wanted_.keys);
    found.target = match::target_of(wanted_.reference, {.offset = wanted_.of.offset, .to = found.start.scene.duration});
    match::FitInput input{.start = found.start,
                          .parameters = found.parameters,
                          .target = found.target,
                          .organ = wanted_.of.organ,
                          .aspect = wanted_.aspect,
                          .weights = wanted_.weights,
                          .seed = wanted_.of.seed};
    std::vector<std::string> lines = match::begin_with_proposal(input, wanted_.tools);
    if (wanted_.tools || wanted_.proposal_alone) found.lines = std::move(lines);
    found.tuned = input.proposed.value_or(input.start);
    if (wanted_.proposal_alone) return found;
    const bool with_colors = !wanted_.color_keys.empty();
    amounts_part_ = with_colors ? amounts_beside_matching : amounts_beside_comparing;
    input.draw = [this](const match::Tuned& tuned, std::span<const double> times) {
        return curve_->measure(tuned.scene, tuned.preset, times,
                               {.progress = [this](double share) { return drawing(share); }});
    };
    input.progress = [this](const match::FitProgress& progress) {
        share_ = amounts_part_ * progress.share, next_ = amounts_part_ * progress.next;
        if (progress.best != nullptr && std::exchange(curves_, progress.curves) != progress.curves) {
            {
                const std::lock_guard lock(mutex_);
                best_ = std::make_shared<const Frames>(*progress.best);
            }
            jobs_.wake();
        }
        return drawing(0.0);
    };
    match::FitColors colors({.reference = wanted_.reference_colors,
                             .target = found.target,
                             .keys = wanted_.color_keys,
                             .amidst = [this](double) { return drawing(0.0); },
                             .finish = [this](double share) { return matching(share); }},
                            *curve_);
    if (with_colors) input.match_colors = [&colors](const match::Tuned& tuned) { return colors.amidst(tuned); };
    found.result = match::fit(input);
    if (found.result->proposal_left) found.lines = {match::scene_was_nearer(wanted_.start.scene)};
    if (with_colors && !found.result->after.empty())
        found.colors = colors.finish(*found.result);
    else if (!found.result->ended_early)
        colors.compare(*found.result, wanted_.start);
    found.tuned = found.result->tuned;
    return found;
}

}  // namespace lapfx::app
