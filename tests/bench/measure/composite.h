// Known veils and known blood laid over a clear picture, in linear light, as the core draws them.
//
//     composite::lay_blood(linear, composite::thickness_of(composite::blood_shape(random, size), view, 0.1, 0.4));
//     const cv::Mat veil = composite::veil_of(composite::veil_shape(random, size, plume), view, 0.3);
//     composite::lay_veil(linear, veil, composite::draw_light(random, size));
//
// Pure functions; pictures are CV_32FC3, BGR, linear light.
#pragma once

#include <opencv2/core.hpp>

#include "bench/measure/random.h"

namespace lapfx::bench::composite {

/// Of a film at its edge, as there: it can just be seen.
inline constexpr float least_thickness = 0.06F;

/// Uneven smoke, CV_32F, 0 and more: even in a fifth of the cases, else of low frequencies, and mostly with `plume`
/// (CV_32F, 0..1), a picture of smoke, somewhere in it.
cv::Mat veil_shape(Random& random, cv::Size size, const cv::Mat& plume);
/// 1 - transmission of smoke whose optical thickness has this shape: CV_32F, 0..1, with this mean over `view` (CV_8U),
/// 0 <= mean < 1. Where the shape is 0 in too much of the view for that mean, less.
cv::Mat veil_of(const cv::Mat& shape, const cv::Mat& view, double mean);
/// Light of dense smoke: a brightness of .55 to .95 (sRGB, 0..1), with less red and green (by up to .22 and .08),
/// dimmed to .7 at the rim.
cv::Mat draw_light(Random& random, cv::Size size);
/// (1 - veil) * picture + veil * light.
void lay_veil(cv::Mat& picture, const cv::Mat& veil, const cv::Mat& light);

/// Lobes around a place, or streaks: CV_32F, more where there is blood first.
cv::Mat blood_shape(Random& random, cv::Size size);
/// The part of the shape that is highest, with this share of the view: CV_32F, 0 where there is no film, at its edges
/// least_thickness, `deepest` at most.
cv::Mat thickness_of(const cv::Mat& shape, const cv::Mat& view, double area, double deepest);
/// What passes the film by the law of Beer and Lambert. Gives where that changes the light by more than a tenth
/// (CV_8U, 255), which is how the core says what is blood (Layers).
cv::Mat lay_blood(cv::Mat& picture, const cv::Mat& thickness);

}  // namespace lapfx::bench::composite
