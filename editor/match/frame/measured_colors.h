// The colours of blood, smoke and tissue in one measured picture.
//
//     estimator.measure(frame, 0);
//     const match::MeasuredColors colors = match::colors_of(frame, estimator);
//
// Pure functions over the layers of an estimator; one thread at a time for each estimator.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "match/frame/estimator.h"

namespace lapfx::match {

/// Pixels at the estimator's working size below which a mean colour says nothing.
inline constexpr int least_pixels = 100;
/// A veil in which the colour of smoke shows.
inline constexpr double colored_veil = 0.1;

/// Mean colours, linear light, 0..1, red, green, blue; nothing of what has too few pixels. Blood: of the middle half.
struct MeasuredColors {
    std::optional<glm::dvec3> blood;  ///< where there is blood, with the veil removed; not behind dense_veil
    /// Light of dense smoke, by what the veil put before the tissue; blood does not count. Nothing where too few pixels
    /// have a veil of colored_veil.
    std::optional<glm::dvec3> smoke;
    std::optional<glm::dvec3> tissue;  ///< of the baseline, in the valid view
    /// The tint of the smoke is that which dark places tell (smoke_tint.h), which is not so where tissue moved; else
    /// only how bright it is counts.
    bool tinted = false;
};

/// How bright linear light is: its luminance.
double light_of(const glm::dvec3& color);

/// Of one frame, all at one size; types and meaning are those of the estimator's layers.
struct ColorLayers {
    cv::Mat blood, veil, valid, light, baseline;
};
/// `frame`: that of the layers, at any size.
MeasuredColors colors_of(const Image& frame, const ColorLayers& layers);
/// `frame`: the one that `estimator` measured last, at any size, and that was measurable.
MeasuredColors colors_of(const Image& frame, const Estimator& estimator);

}  // namespace lapfx::match
