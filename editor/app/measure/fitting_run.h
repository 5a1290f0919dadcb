// One fit, or the proposal that it begins with, on a thread of its own that asks the render thread for each picture.
//
//     FittingRun run(wanted, curve, steps, jobs, true);
//     each frame:  steps.serve(8e-3); plot(*run.best());
//     if (run.ended()) show(run.take(), run.faults());
//
// UI thread.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/base/thread_work.h"
#include "lapfx/error.h"
#include "match/use/fit_scene.h"

namespace lapfx::app {

class RenderSteps;

/// What a fit is of, as its report has it.
struct FitOf {
    std::string scene = {}, preset = {};  ///< names for people
    std::filesystem::path reference = {};
    double aspect = 0.0;                  ///< of the reference, SceneReference::aspect
    std::vector<std::string> notes = {};  ///< of measuring it
};

/// All that a fit goes by; a copy, so that the document may change meanwhile.
struct FitWanted {
    match::SceneFit fit;
    FitOf of = {};
    bool proposal_alone = false;  ///< nothing is drawn
};

/// What came of it.
struct FitFound : match::FittedScene {
    FitOf of = {};
    double seconds = 0.0;  ///< that it took
};

class FittingRun {
  public:
    using Frames = std::vector<match::FrameAmounts>;

    /// `beside`: else all of it is done here, at once. `curve` draws by way of `steps`; all must outlive it.
    /// Ending it waits for what is being done: a picture, or up to two seconds of a proposal.
    FittingRun(FitWanted wanted, match::PreviewCurve* curve, RenderSteps& steps, Jobs& jobs, bool beside);
    FittingRun(const FittingRun&) = delete;
    FittingRun& operator=(const FittingRun&) = delete;

    const FitWanted& wanted() const { return wanted_; }
    /// It ends soon, with the best so far.
    void cancel() { work_.cancel(); }
    bool cancelled() const { return work_.cancelled(); }
    double progress() const { return work_.progress(); }  ///< 0..1
    /// What the nearest place so far shows; null: nothing was drawn yet.
    std::shared_ptr<const Frames> best() const;
    bool ended() const { return work_.ended(); }
    /// Once it has ended: nothing where it was cancelled before anything was drawn, or faults() say why.
    std::optional<FitFound> take() { return std::exchange(work_.result(), std::nullopt); }
    std::vector<Fault> faults() const { return work_.faults(); }

  private:
    std::optional<FitFound> find(Job& job);

    const FitWanted wanted_;
    match::PreviewCurve* curve_;
    Jobs& jobs_;
    mutable std::mutex mutex_;
    std::shared_ptr<const Frames> best_;
    ThreadWork<FitFound> work_;  // last: it uses all of the others
};

}  // namespace lapfx::app
