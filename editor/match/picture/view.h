// Which pixels of a frame are looked at: the endoscope's picture without its black surround and the parts that
// a user left out.
#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <vector>

namespace lapfx::match {

/// For cv::dilate and its kind: all within so many px.
cv::Mat disc(int radius);

/// The picture of the endoscope, CV_8U 255 inside: round, or cut off at the sides. `code`: CV_8UC3 BGR. Dark hollows
/// inside belong to it. All 0 for a black picture.
cv::Mat view_of(const cv::Mat& code);

/// A part of the picture that is not measured: corners as fractions of the picture, from its upper left corner.
using MaskPolygon = std::vector<glm::dvec2>;

/// The region and the parts that are left out, as pixels: CV_8U 255 where it may be measured.
cv::Mat wanted_part(cv::Size size, const glm::dvec4& region, std::span<const MaskPolygon> masks);

/// A round view that is known: its middle, fractions of width and height, and radius, of the height. CV_8U 255 inside.
/// `aspect`: width over height of the picture in which it is round; 0: that of `size`.
cv::Mat disc_of(const glm::dvec3& round, cv::Size size, double aspect = 0.0);

/// What is looked at of each picture of a video; all as fractions of the picture.
struct LookedAt {
    glm::dvec4 region{0.0, 0.0, 1.0, 1.0};      ///< x, y, width, height
    std::vector<MaskPolygon> masks = {};        ///< left out
    std::optional<glm::dvec3> round_view = {};  ///< as disc_of() has it; none: view_of() is looked for
};
/// CV_8U 255 inside. `code`: CV_8UC3 BGR.
cv::Mat view_in(const cv::Mat& code, const LookedAt& part);

}  // namespace lapfx::match
