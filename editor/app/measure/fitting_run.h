// One fit, or the proposal that it begins with, on a thread of its own that asks the render thread for each picture.
//
//     FittingRun run(wanted, curve, steps, jobs, true);
//     each frame:  steps.serve(8e-3); plot(*run.best());
//     if (run.ended()) show(run.found(), run.faults());
//
// UI thread.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "lapfx/error.h"
#include "match/use/fit_scene.h"

namespace lapfx::app {

class Jobs;
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
    FittingRun(FitWanted wanted, match::PreviewCurve* curve, RenderSteps& steps, Jobs& jobs, bool beside);
    ~FittingRun();  ///< waits for what is being done: a picture, or up to two seconds of a proposal
    FittingRun(const FittingRun&) = delete;
    FittingRun& operator=(const FittingRun&) = delete;

    const FitWanted& wanted() const { return wanted_; }
    /// It ends soon, with the best so far.
    void cancel() { cancelled_ = true; }
    bool cancelled() const { return cancelled_; }
    double progress() const { return progress_; }  ///< 0..1
    /// What the nearest place so far shows; null: nothing was drawn yet.
    std::shared_ptr<const Frames> best() const;
    bool ended() const;
    /// Once it has ended: nothing where it was cancelled before anything was drawn, or faults() say why.
    std::optional<FitFound> take();
    std::vector<Fault> faults() const;

  private:
    void work();
    FitFound find();

    const FitWanted wanted_;
    match::PreviewCurve* curve_;
    RenderSteps& steps_;
    Jobs& jobs_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<double> progress_ = 0.0;
    mutable std::mutex mutex_;
    std::shared_ptr<const Frames> best_;
    bool ended_ = false;
    std::optional<FitFound> found_;
    std::vector<Fault> faults_;
    std::thread thread_;
};

}  // namespace lapfx::app
