// The amounts that a scene shows over time, measured as a video is: pictures are drawn off-screen and given to the same
// estimator.
//
//     PreviewCurve curve(organ, {.clip_folders = ..., .wait_for_clips = true}, {.size = {256, 144}});
//     std::optional<std::vector<FrameAmounts>> frames = curve.measure(scene, preset, times, progress);
//
// Render thread, context current; a thread beside it measures what has been drawn.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/progress.h"
#include "match/measure.h"

namespace lapfx::match {

inline constexpr int preview_side = 256;  ///< px of the longer side of measured pictures: the estimator's own

/// Of a picture with the shape of a reference's. `aspect`: width over height when it is shown (SceneReference::aspect);
/// 0: as stored.
glm::ivec2 preview_size(glm::dvec2 shape, double aspect = 0.0);

class PreviewCurve {
  public:
    /// `estimator`: as the reference is measured; its survey is made anew for each curve.
    PreviewCurve(std::shared_ptr<const PreparedOrgan> organ, PreviewOptions preview, EstimatorOptions estimator,
                 glm::ivec2 size);

    /// The baseline is the scene before any tool has touched it. `times`: s, ascending. `measured` is called in their
    /// order, on the thread beside. Nothing when `progress` stopped it. Throws Error: bad_input where no tissue is in
    /// view, or what the scene names cannot be loaded.
    std::optional<std::vector<FrameAmounts>> measure(const Scene& scene, const Preset& preset,
                                                     std::span<const double> times, const Progress& progress = {},
                                                     const FrameMeasured& measured = {});
    int curves() const { return curves_; }

  private:
    void show(const Scene& scene, const Preset& preset);

    std::shared_ptr<const PreparedOrgan> organ_;
    PreviewOptions preview_options_;
    EstimatorOptions estimator_options_;
    glm::ivec2 size_;
    std::unique_ptr<Preview> preview_;
    int curves_ = 0;
};

}  // namespace lapfx::match
