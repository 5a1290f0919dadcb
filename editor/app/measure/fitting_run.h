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
#include "match/fit/fit.h"
#include "match/fit/fit_colors.h"
#include "match/fit/preview_curve.h"

namespace lapfx::app {

class Jobs;
class RenderSteps;

/// What a fit is of, as its report has it.
struct FitOf {
    std::string scene = {}, preset = {};  ///< names for people
    std::filesystem::path reference = {};
    double offset = 0.0;                  ///< s; reference time = scene time + offset
    double aspect = 0.0;                  ///< of the reference, SceneReference::aspect
    std::vector<std::string> notes = {};  ///< of measuring it
    std::shared_ptr<const PreparedOrgan> organ = {};
    std::uint32_t seed = 1;
};

/// All that a fit goes by; a copy, so that the document may change meanwhile.
struct FitWanted {
    match::Tuned start;
    FitOf of = {};
    std::vector<std::string> keys = {};
    bool tools = true;            ///< the proposal may move, add and silence them
    bool proposal_alone = false;  ///< nothing is drawn
    match::Weights weights = {};
    std::vector<std::string> color_keys = {};   ///< whose colours are matched once the amounts are fitted
    match::ColorsAtPeak reference_colors = {};  ///< what they are matched with, or only compared
    std::vector<match::FrameAmounts> reference = {};
    double aspect = 1.25;  ///< of the pictures, width over height
};

/// What came of it.
struct FitFound {
    match::Tuned start, tuned;
    FitOf of = {};
    std::vector<std::string> lines = {};   ///< of the proposal, for people
    std::vector<std::string> colors = {};  ///< of how near the colours are, and which were changed, for people
    std::vector<match::FreeParameter> parameters = {};
    std::vector<match::TargetPoint> target = {};
    std::optional<match::FitResult> result = {};  ///< none: a proposal alone
    double seconds = 0.0;                         ///< that it took
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
    bool drawing(double share);
    bool matching(double share);
    bool reached(double share);

    const FitWanted wanted_;
    match::PreviewCurve* curve_;
    RenderSteps& steps_;
    Jobs& jobs_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<double> progress_ = 0.0;
    double share_ = 0.0, next_ = 0.0, amounts_part_ = 1.0;  ///< of the thread that works,
    int curves_ = 0;                                        ///< and the curve that best_ is of
    mutable std::mutex mutex_;
    std::shared_ptr<const Frames> best_;
    bool ended_ = false;
    std::optional<FitFound> found_;
    std::vector<Fault> faults_;
    std::thread thread_;
};

}  // namespace lapfx::app
