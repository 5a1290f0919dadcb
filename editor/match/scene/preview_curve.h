// The amounts that a scene shows over time, measured as a video is: pictures are drawn off-screen and given to the same
// estimator.
//
//     PreviewCurve curve(organ, {.clip_folders = ..., .wait_for_clips = true}, {.size = {256, 144}});
//     std::optional<std::vector<FrameAmounts>> frames = curve.measure(scene, preset, times, {.progress = progress});
//
// Render thread, context current; or any thread that hands each picture to that one (RenderThread). A thread beside it
// measures what has been drawn.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/progress.h"
#include "match/video/measure.h"

namespace lapfx::match {

inline constexpr int preview_side = 256;  ///< px of the longer side of measured pictures: the estimator's own

/// Of a picture with the shape of a reference's, with so many px on its longer `side`. `aspect`: width over height when
/// it is shown (SceneReference::aspect); 0: as stored.
glm::ivec2 preview_size(glm::dvec2 shape, double aspect = 0.0, int side = preview_side);

/// Carries out a step of drawing, about one picture, where the context is current, and waits for it; what it throws is
/// thrown here. False: it was not carried out, nor will be any other.
using RenderThread = std::function<bool(const std::function<void()>& step)>;

/// What is called while a curve is measured.
struct CurveCalls {
    Progress progress = {};       ///< false ends it
    FrameMeasured measured = {};  ///< in the order of the times, on the thread beside
    /// Render thread, after each picture in the order of the times: the preview, which may show another moment.
    std::function<void(Preview&, double time)> drawn = {};
};

class PreviewCurve {
  public:
    struct Options {
        glm::ivec2 size{preview_side};  ///< px, as pictures are drawn
        /// As they are measured: where a reference is stored in another shape than it is shown in, what looks like
        /// blood or smoke is learned and found in pictures as they are stored. 0: as drawn.
        glm::ivec2 measured{0};
        EstimatorOptions estimator = {};  ///< as the reference is measured; the survey is made anew for each curve
    };

    /// Of what is held against a video that is stored in that shape and shown with that aspect, as preview_size().
    static Options options_for(glm::dvec2 stored, double aspect, EstimatorOptions estimator, int side = preview_side);

    /// Without `render` this thread draws. It is destroyed where the context is current.
    PreviewCurve(std::shared_ptr<const PreparedOrgan> organ, PreviewOptions preview, Options options,
                 RenderThread render = {});

    /// The baseline is the scene before any tool has touched it. `times`: s, ascending. Nothing when progress or
    /// RenderThread stopped it. Throws Error: bad_input where no tissue is in view, or what the scene names cannot be
    /// loaded.
    std::optional<std::vector<FrameAmounts>> measure(const Scene& scene, const Preset& preset,
                                                     std::span<const double> times, const CurveCalls& calls = {});
    /// One picture of a scene with all that its tools do, at `time` s; nothing: RenderThread stopped it. Throws Error
    /// (bad_input) where what the scene names cannot be loaded, (runtime) where the driver cannot make the picture.
    std::optional<Image> picture(const Scene& scene, const Preset& preset, double time, glm::ivec2 size);
    /// From the next curve on.
    void set_options(Options options) { options_ = std::move(options); }
    /// From the next curve on: blood that a plate shows by itself counts as in its video, where that is measured by
    /// strokes (EstimatorOptions::held_blood). Null: it does not.
    void count_plate_by(std::shared_ptr<const PaintedBlood> blood) { plate_blood_ = std::move(blood); }
    const std::shared_ptr<const PreparedOrgan>& organ() const { return organ_; }
    int curves() const { return curves_; }
    std::size_t memory() const;  ///< bytes of what draws the pictures; render thread, or while none are drawn

  private:
    class Pictures;
    bool survey(Pictures& pictures, Estimator& estimator, const std::function<bool(std::size_t surveyed)>& goes_on);
    void take(const Scene& scene, const Preset& preset);
    void show(const Scene& scene, const Preset& preset);
    Image to_measure(double time) const;
    bool draw(const std::function<void()>& step) const { return render_ ? render_(step) : (step(), true); }

    std::shared_ptr<const PreparedOrgan> organ_;
    PreviewOptions preview_options_;
    Options options_;
    std::shared_ptr<const PaintedBlood> plate_blood_;
    RenderThread render_;
    std::unique_ptr<Preview> preview_;
    int curves_ = 0;
};

}  // namespace lapfx::match
