// What was counted in a frame, drawn over it: blood yellow, veil blue, and what is left out dark and hatched.
//
//     const match::FrameAmounts amounts = estimator.measure(frame, time);
//     match::draw_counted(frame, estimator, amounts);  // the layers of the frame measured last
//
// Any thread; no OpenGL.
#pragma once

#include <glm/glm.hpp>

#include "match/frame/estimator.h"

namespace lapfx::match {

/// RGB, 0..255.
inline constexpr glm::vec3 blood_color{240, 228, 66}, veil_color{86, 180, 233};
/// Of the colour in the picture, where it is strongest: blood is there or not, veil by its density.
inline constexpr float blood_share = 0.65F, veil_share = 0.8F;
/// Of the light of what is left out, between the lines of the hatch.
inline constexpr float left_out_light = 0.45F;

struct CountedLayers {
    bool blood = true, veil = true, left_out = true;
};

/// What is drawn of a measured frame, at the estimator's size or another; those that are empty are not drawn.
struct MeasuredLayers {
    cv::Mat blood;  ///< CV_8U, 255 where there is blood
    cv::Mat veil;   ///< CV_32F, 0..1
    cv::Mat valid;  ///< CV_8U, 255 in the valid view
};
void draw_layers(Image& frame, const MeasuredLayers& layers);

/// `frame` is the one that was measured last, at its own size, and `amounts` what was found. What is not measurable is
/// not drawn, and nothing at all on a frame that the file could not give.
void draw_counted(Image& frame, const Estimator& estimator, const FrameAmounts& amounts,
                  const CountedLayers& drawn = {});

}  // namespace lapfx::match
