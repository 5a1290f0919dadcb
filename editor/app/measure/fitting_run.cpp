#include "app/measure/fitting_run.h"

#include <utility>

#include "app/base/jobs.h"
#include "app/base/render_steps.h"

namespace lapfx::app {

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

FitFound FittingRun::find() {
    FitFound found;
    found.of = wanted_.of;
    match::FittedScene& scene = found;
    if (wanted_.proposal_alone) {
        scene = match::propose_scene(wanted_.fit);
        return found;
    }
    const auto reached = [this](double share) {
        progress_ = share;
        return !cancelled_;
    };
    const auto nearer = [this](const Frames& best) {
        {
            const std::lock_guard lock(mutex_);
            best_ = std::make_shared<const Frames>(best);
        }
        jobs_.wake();
    };
    scene = match::fit_scene(wanted_.fit, *curve_, {.progress = reached, .best = nearer});
    return found;
}

}  // namespace lapfx::app
