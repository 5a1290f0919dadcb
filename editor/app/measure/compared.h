// Scene and reference held against each other over the scene's time: what the page of both pictures is made of
// (side_by_side.h).
#pragma once

#include <string>
#include <vector>

#include "lapfx/authoring/video.h"
#include "lapfx/preset.h"
#include "lapfx/progress.h"
#include "lapfx/scene.h"
#include "match/scene/preview_curve.h"
#include "match/video/measure.h"

namespace lapfx::app {

struct Compared {
    glm::ivec2 frame{0};                                 ///< px of the preview's picture
    double duration = 0.0;                               ///< s, of the scene: what the curves span
    std::string preview = {}, video = {};                ///< names for people
    SceneReference reference = {};                       ///< offset, aspect and placement are used
    std::vector<match::FrameAmounts> of_preview = {};    ///< at times of the scene; may be empty
    std::vector<match::FrameAmounts> of_reference = {};  ///< at times of the video; may be empty
    std::string words = {};                              ///< how near both are, in one line, or why that is not known
};

/// What is measured. All must outlive measure_both().
struct BothWanted {
    const Scene& scene;
    const Preset& preset;
    VideoReader& video;
    const match::MeasureOptions& options;  ///< of the reference
    const match::Measurement* found;       ///< the reference's, where it is measured already; else null
    match::PreviewCurve& curve;            ///< draws the scene as PreviewCurve says
};

/// Measures both alike, as `lapfx compare` does, and fills the amounts and the words of `compared`. What cannot be
/// measured is said in the words. Gives whether it came to its end: `progress`, of shares 0..1, may stop it. Throws
/// what is no fault of the video or the scene. Any thread, as the curve allows.
bool measure_both(Compared& compared, const BothWanted& wanted, const Progress& progress);

}  // namespace lapfx::app
