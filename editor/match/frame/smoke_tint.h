// The tint of smoke, told by the darkest places of a picture: what is seen there is nearly the smoke's own light. On
// lit tissue the tissue's red hides it, and the light that HazeLightSurvey finds in real frames is too red: tissue
// moves, and any red explains some of that. Pure function, any thread.
#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <optional>

namespace lapfx::match {

/// Light of smoke over its luminance, before 13 puffs of two operations; blue, green, red.
inline const cv::Vec3f usual_smoke_tint(1.2725366F, 0.96712784F, 1.0180293F);

/// Of one frame, all at one size. Light is linear, CV_32FC3 (blue, green, red).
struct SmokeLayers {
    cv::Mat seen, clear;  ///< the frame, and its baseline
    cv::Mat veil;         ///< CV_32F, 0..1
    cv::Mat light;        ///< of dense smoke, as it was assumed: only how bright it is counts
    cv::Mat valid;        ///< CV_8U
};

/// Red, green and blue of the smoke's light over their mean. The darkest places of the frame are held against the
/// darkest of the baseline, so neither has to lie over the other. Nothing where there is too little smoke, where darker
/// and less dark places disagree, and where it is more of a tint than smoke has.
std::optional<glm::dvec3> smoke_tint(const SmokeLayers& layers);

}  // namespace lapfx::match
