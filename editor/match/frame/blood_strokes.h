// Strokes of a brush over frames of a surgery video, by which a person says what is blood there and what is not.
//
//     const match::BloodStrokes strokes = match::read_blood_strokes(text, "strokes.json", {640, 512});
//     cv::Mat marks = match::marks_of(strokes, which, view);   // blood and other of one frame, as pixels
//
// A file of them:
//
//     {"format": "lapfx.blood_strokes", "version": 1, "without_blood": 0.4, "strokes": [
//         {"time": 2.5, "marks": "blood", "radius": 6, "points": [[310, 200], [335, 214]]},
//         {"time": 2.5, "marks": "other", "radius": 12, "points": [[120, 80], [180, 96], [230, 90]]}]}
//
// `time` and `without_blood`: s of the video. `points` and `radius` are px of the picture; where no coordinate of the
// file is above 1 the points are fractions of width and height, and each radius is one of the width. Pure, any thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/scene.h"

namespace lapfx::match {

inline constexpr std::size_t most_points = 20'000;          // of all strokes together
inline constexpr std::uintmax_t longest_strokes = 4 << 20;  // bytes of a file

struct BloodStrokes {
    std::string file;                          ///< stands in messages and results; empty: a scene's own
    std::string place = {};                    ///< of what holds them there, in messages: a JSON pointer
    std::optional<double> without_blood = {};  ///< s of the video: a frame that has no blood, as a person says
    std::vector<BloodStroke> strokes;          ///< as ReferenceMeasure::strokes
};

/// `name`: BloodStrokes::file. `size`: of the video's pictures. Throws Error (bad_input) that names the place, the
/// value and what is allowed, for what is not such a file, a key or value that is not known or not allowed, a point
/// outside the picture, more than most_points together, or strokes of which none marks blood.
BloodStrokes read_blood_strokes(std::string_view json, const std::string& name, glm::ivec2 size);

/// Such a file, which gives the same strokes back; `strokes` are as they are read.
std::string write_blood_strokes(const BloodStrokes& strokes);

/// What a mark is in marks_of(), where 0 is what nothing was painted over.
inline constexpr std::uint8_t value_of(StrokeMark mark) {
    return mark == StrokeMark::blood ? 1 : 2;
}
/// What the strokes of `which` (numbers in `strokes`) mark within `view` (CV_8U, 255 inside): CV_8U of its size. A
/// brush has at least the pixel below each point. Throws Error (bad_input) for a stroke that lies outside of the view.
cv::Mat marks_of(const BloodStrokes& strokes, std::span<const std::size_t> which, const cv::Mat& view);

}  // namespace lapfx::match
