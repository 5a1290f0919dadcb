#include "app/measure/fitting_run.h"

#include <utility>

#include "app/base/render_steps.h"

namespace lapfx::app {

FittingRun::FittingRun(FitWanted wanted, match::PreviewCurve* curve, RenderSteps& steps, Jobs& jobs, bool beside)
    : wanted_(std::move(wanted)), curve_(curve), jobs_(jobs) {
    work_.start([this](Job& job) { return find(job); },
                {.ended = [&jobs] { jobs.wake(); }, .given_up = [&steps] { steps.stop(); }}, beside);
}

std::shared_ptr<const FittingRun::Frames> FittingRun::best() const {
    const std::lock_guard lock(mutex_);
    return best_;
}

std::optional<FitFound> FittingRun::find(Job& job) {
    FitFound found;
    found.of = wanted_.of;
    match::FittedScene& scene = found;
    if (wanted_.proposal_alone) {
        scene = match::propose_scene(wanted_.fit);
    } else {
        const auto reached = [&job](double share) {
            job.set_progress(share);
            return !job.cancelled();
        };
        const auto nearer = [this](const Frames& best) {
            {
                const std::lock_guard lock(mutex_);
                best_ = std::make_shared<const Frames>(best);
            }
            jobs_.wake();
        };
        scene = match::fit_scene(wanted_.fit, *curve_, {.progress = reached, .best = nearer});
    }
    const bool drawn = found.result && !found.result->after.empty();
    if (job.cancelled() && !drawn) return std::nullopt;  // before there was anything to show
    return found;
}

}  // namespace lapfx::app
