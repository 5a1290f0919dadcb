// The blood of a video, learned from a person's strokes over some of its frames.
//
//     const match::PaintedVideo painted = match::learn_blood(video, strokes, 0.0, options);
//     options.painted_blood = painted.blood;
//
// Any thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lapfx/authoring/video.h"
#include "match/frame/blood_strokes.h"
#include "match/frame/estimator.h"
#include "match/frame/painted_blood.h"

namespace lapfx::match {

struct PaintedVideo {
    std::string file;                           ///< of the strokes; empty: they are a scene's own
    std::shared_ptr<const PaintedBlood> blood;  ///< never null
    std::optional<double> without_blood;        ///< s: the frame that counts as without blood; none: none is known
};

inline constexpr std::size_t most_painted_frames = 20;

/// `baseline`, s: a frame without smoke; where the strokes name no frame without blood it may be one, which is tried
/// unless they mark blood in it. Throws Error (bad_input) as check_times() and PaintedBlood, for more
/// frames than most_painted_frames, for a frame that the video cannot give, and for strokes of blood in the frame that
/// is said to have none.
PaintedVideo learn_blood(VideoReader& video, const BloodStrokes& strokes, std::optional<double> baseline,
                         const EstimatorOptions& options);

/// Throws Error (bad_input) for strokes over a time outside of the video.
void check_times(const VideoReader& video, const BloodStrokes& strokes);

}  // namespace lapfx::match
