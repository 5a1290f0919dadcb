// How much blood and smoke the preview shows over the scene's time, measured as the reference is: pictures of the scene
// are drawn off-screen and given to the same estimator, so like is compared with like. Worked out whenever what it
// depends on has settled, and only while somebody looks.
//
//     measured.want();                                 // in each build that shows them
//     each frame:  measured.update(now);               // draws a picture or two
//     plot(measured.frames());
//
// Pictures are drawn by the render thread, some milliseconds of each frame; a thread beside it measures them. UI
// thread, context current.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "app/base/editor_options.h"
#include "app/base/settling.h"
#include "document/document.h"
#include "lapfx/error.h"
#include "match/frame/estimator.h"
#include "match/scene/preview_curve.h"
#include "match/video/peak_colors.h"

namespace lapfx {
class VideoReader;
}  // namespace lapfx

namespace lapfx::match {
class PreviewCurve;
}

namespace lapfx::app {

class Jobs;
class Measuring;
class PreviewHost;
class Reference;
class RenderSteps;
class ScenePace;

/// What is in a picture of ours, exactly: means over its view without what the scene leaves out.
struct TrueAmounts {
    double time = 0;             ///< s of the scene
    double blood = 0, veil = 0;  ///< 0..1, as match::FrameAmounts
};

class PreviewMeasuring {
  public:
    static constexpr double step = 0.2;  ///< s between them, in scenes of up to `most` of them
    static constexpr std::size_t most = 300;

    /// While a person works, a program without a GPU draws no pictures for this. It does not begin where
    /// EditorOptions::measures_preview says so. All must outlive it.
    PreviewMeasuring(const document::Document& document, const PreviewHost& preview, const Reference& reference,
                     const Measuring& measuring, const ScenePace& pace, Jobs& jobs, const EditorOptions& options);
    ~PreviewMeasuring();
    PreviewMeasuring(const PreviewMeasuring&) = delete;
    PreviewMeasuring& operator=(const PreviewMeasuring&) = delete;

    bool truth = false;  ///< the core's own truth is wanted, too: each picture then costs about five

    /// They are looked at in this frame.
    void want() { wanted_ = true; }
    /// Once a frame, by the editor. `now`: s, the clock of the UI.
    void update(double now);
    /// Another document has been opened: nothing of its preview has been measured.
    void forget();

    /// In the order of time; while nothing complete is known, those that have been measured so far. While stale(),
    /// those of an older state of the document.
    const std::vector<match::FrameAmounts>& frames() const { return frames_; }
    const std::vector<TrueAmounts>& truths() const { return truths_; }  ///< empty where they were not asked for
    /// Those of the whole scene; null until it is complete().
    const match::ColorsOverTime* colors() const { return complete() ? colors_.get() : nullptr; }
    bool stale() const { return !known_ || followed_ != document_.version(); }
    bool complete() const {
        return complete_of_ != nullptr;
    }  ///< frames() are of the whole scene, else of its beginning
    bool busy() const { return run_ != nullptr; }
    double progress() const;                   ///< 0..1, while busy()
    bool stopped() const { return stopped_; }  ///< a person has stopped it; again() or a change goes on
    void stop();
    void again() { known_ = stopped_ = false, known_of_.reset(); }
    const std::vector<Fault>& faults() const { return faults_; }  ///< why it cannot be measured
    std::uint64_t version() const { return version_; }            ///< changes with frames() and truths()

    std::size_t memory() const;  ///< bytes of what draws the pictures

    /// A panel that shows them wants another frame, at due(): nothing else would bring it.
    bool wants_frame() const;
    double due() const { return due_; }  ///< s

  private:
    class Run;
    /// What is measured. It is copied once the document has settled, and shared.
    struct Subject {
        document::Content content;
        glm::ivec2 size{0}, measured{0};  ///< match::PreviewCurve::Options
        std::uint64_t organ = 0;          ///< version of the host's
        bool truth = false;
        std::shared_ptr<const match::PaintedBlood> plate_blood;  ///< by which a plate's own counts; null: it does not
    };
    std::shared_ptr<const match::PaintedBlood> plate_blood() const;
    void follow(double now);
    void take_change(double now, bool other_truth);
    bool other_reference() const;
    void drop_known();
    match::PreviewCurve::Options shape() const;
    std::shared_ptr<const Subject> subject() const;
    bool holds(const std::shared_ptr<const Subject>& of) const;
    void start(double now);
    bool prepare();
    void draw(double now);
    void take();
    void drop_run();
    void fail(const std::vector<Fault>& faults);

    const document::Document& document_;
    const PreviewHost& host_;
    const Reference& reference_;
    const Measuring& measuring_;
    const ScenePace& pace_;
    Jobs& jobs_;
    std::vector<std::filesystem::path> clip_folders_;
    bool exact_, software_, begins_;
    int measured_side_;
    bool wanted_ = false, stopped_ = false;
    std::uint64_t followed_ = 0, organ_ = 0;                  ///< versions of the document and of the host's organ
    std::weak_ptr<const VideoReader> of_opened_;              ///< of the reference
    bool truth_ = false;                                      ///< the true amounts were wanted then
    std::shared_ptr<const match::PaintedBlood> plate_blood_;  ///< and this was known of the plate
    bool known_ = false;                                      ///< nothing is to be measured:
    std::shared_ptr<const Subject> known_of_;                 ///< that is known, or was stopped, or cannot be measured
    Settling settling_{0.4};
    double due_ = Settling::never;
    std::unique_ptr<RenderSteps> steps_;          ///< of one run
    std::unique_ptr<match::PreviewCurve> curve_;  ///< while somebody looks
    std::unique_ptr<Run> run_;
    std::vector<match::FrameAmounts> frames_;
    std::vector<TrueAmounts> truths_;
    std::shared_ptr<const match::ColorsOverTime> colors_;
    std::shared_ptr<const Subject> complete_of_;  ///< frames_ are of all of it; null: of the beginning of a run
    std::vector<Fault> faults_;
    std::uint64_t version_ = 1;
};

}  // namespace lapfx::app
