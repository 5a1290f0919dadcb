// Finds the values with which the preview shows as much blood and smoke as the reference: the Fit button. It works
// beside the UI on a copy of the document, and what it found is a proposal that a person takes, as one undo step, or
// leaves.
//
//     fitting.start();
//     each frame:  fitting.update(now);
//     if (const FitFound* found = fitting.found()) show(*found);  // fitting.take();
//
// UI thread, context current.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/measure/fitting_run.h"
#include "app/measure/remaining.h"
#include "document/document.h"
#include "document/steps.h"

namespace lapfx::app {

class Measuring;
class Notices;
class PreviewHost;
class Reference;
class ScenePace;
class Tuning;
struct EditorOptions;

/// What a person chooses; no part of the document.
struct FitLook {
    std::vector<std::string> keys{match::usual_parameters.begin(), match::usual_parameters.end()};
    bool tools = true;    ///< they may be moved, added and silenced, so that smoke and blood begin as in the reference
    bool colors = false;  ///< exposure, and colours of blood and smoke, are matched once the amounts are fitted
    match::Weights weights = {};
    std::uint32_t seed = 1;
};

class Fitting {
  public:
    /// All must outlive it.
    struct Parts {
        document::Document& document;
        const PreviewHost& preview;
        const Reference& reference;
        Measuring& measuring;
        const Tuning& tuning;  ///< for its locks
        const ScenePace& pace;
        Jobs& jobs;
        Notices& notices;
        const EditorOptions& options;
    };
    explicit Fitting(const Parts& parts);
    ~Fitting();
    Fitting(const Fitting&) = delete;
    Fitting& operator=(const Fitting&) = delete;

    FitLook look;

    /// Once before each frame. `now`: s, the clock of the UI.
    void update(double now);
    /// s: when update() wants to be called next; infinity: whenever.
    double due() const { return due_; }
    /// Another document has been opened.
    void forget();

    // --- finding -----------------------------------------------------------------------------------------------------
    /// What the curves say without drawing: under two seconds.
    void propose() { begin(true); }
    /// The whole fit. The reference is measured before, if it is not yet.
    void start() { begin(false); }
    void cancel();  ///< with the best so far
    bool busy() const { return asked_.has_value(); }
    bool measures_first() const { return asked_ && !run_; }  ///< the fit waits for the measuring
    bool proposes() const { return asked_ && *asked_; }      ///< busy() with a proposal alone
    double progress() const { return run_ ? run_->progress() : 0.0; }
    double seconds_left() const;  ///< at the pace of the last steps, to the last that there may be; negative: not known
    const std::vector<Fault>& faults() const { return faults_; }
    /// Of faults(): the clip of the preset, by its number, whose file is not there. Once another file is chosen, or
    /// undone what named it, it is no fault any more.
    const std::optional<std::size_t>& lost_clip() const { return lost_clip_; }
    bool locked(const std::string& key) const;  ///< it is no parameter of a fit as long as it is

    // --- found -------------------------------------------------------------------------------------------------------
    /// The last that was found, also once it has been taken, until another has been found; null: nothing. It goes with
    /// its reference.
    const FitFound* found() const { return found_ ? &*found_ : nullptr; }
    bool taken() const { return taken_; }  ///< and that is not undone
    /// Its curve until it is taken, and while it fits the best so far as soon as there is one; empty: none.
    const std::vector<match::FrameAmounts>& frames() const;
    std::uint64_t version() const { return version_; }  ///< changes with frames() and found()
    /// The document is no longer what it started from: its values are taken all the same.
    bool stale() const { return found_ && !taken_ && parts_.document.version() != of_version_; }
    void take();  ///< one undo step
    void leave();

  private:
    void begin(bool proposal_alone);
    void go_on(double now);
    bool measured();
    bool prepare(double now);
    std::vector<Fault> lost_clips();
    void forget_found_clip();
    void follow_document();
    std::vector<std::string> free_keys(std::vector<std::string> keys) const;
    FitOf of_now() const;
    match::SceneFit fit_now(std::shared_ptr<const PreparedOrgan> organ, glm::ivec2 size) const;
    void fail(std::vector<Fault> faults);
    void end_run();

    const Parts parts_;
    std::optional<bool> asked_;  ///< true: a proposal alone is wanted, false: the whole fit; nothing: neither is
    bool measuring_asked_ = false;
    double began_ = 0.0, now_ = 0.0;
    Remaining remaining_;
    double due_ = std::numeric_limits<double>::infinity();
    std::unique_ptr<RenderSteps> steps_;
    std::unique_ptr<match::PreviewCurve> curve_;
    std::unique_ptr<FittingRun> run_;
    std::shared_ptr<const FittingRun::Frames> best_;
    std::optional<FitFound> found_;
    bool taken_ = false;
    document::WatchedStep taken_step_;                ///< none: taking it changed nothing
    std::uint64_t of_version_ = 0, run_version_ = 0;  ///< of the document, that found_ and run_ started from
    std::uint64_t version_ = 1;
    std::vector<Fault> faults_;
    std::optional<std::size_t> lost_clip_;
    std::uint64_t looked_ = 0;  ///< the version of the document whose clips were looked for
};

}  // namespace lapfx::app
