// The shots of a video, and the clear frame that each is compared with: its baseline.
//
//     for (const match::Shot& shot : match::find_shots(video, 0.0, video.info().duration, {}))
//         if (!shot.baseline) log(match::row_of(shot.why).help);
//
// Any thread. Reads some frames over the video, and all frames only where two of these do not show the same.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/authoring/video.h"
#include "lapfx/progress.h"

namespace lapfx::match {

/// Why a shot has no baseline.
enum class WithoutBaseline : std::uint8_t { has_one, bag, trocar, dark, brief, hazy };
struct WithoutBaselineRow {
    WithoutBaseline why;
    std::string_view key;   ///< in JSON
    std::string_view help;  ///< for people, after "0.00 to 5.00 s: "
};
inline constexpr WithoutBaselineRow without_baseline_rows[] = {
    {WithoutBaseline::bag, "bag", "no tissue is in view"},
    {WithoutBaseline::trocar, "trocar", "the view is that out of a trocar"},
    {WithoutBaseline::dark, "dark", "the picture is black"},
    {WithoutBaseline::brief, "brief",
     "the shot is too short for a baseline of its own, and no other one shows its tissue"},
    {WithoutBaseline::hazy, "hazy",
     "every frame is hazy, or pale all over: course only, no level; give a clear frame as the baseline if there is "
     "one"},
};
/// Its row; the first one for has_one.
const WithoutBaselineRow& row_of(WithoutBaseline why);

/// A stretch of frames without a cut, which either shows tissue or does not.
struct Shot {
    int first = 0, last = 0;              ///< frames
    double from = 0.0, to = 0.0;          ///< s, of these frames
    std::optional<double> baseline = {};  ///< s; it may lie in another shot, which shows the same tissue
    bool suggested = true;                ///< the baseline was found, not given
    /// s: of the shot's own frames the earliest that is nearly as clear as the clearest, also where it is too hazy for
    /// a baseline.
    std::optional<double> clear = {};
    bool hazy = false;  ///< the baseline may be hazy itself: smoke is what is denser than there
    /// Where the baseline lies in the first frame, as far as it can be followed there: Estimator::forget().
    cv::Matx33d start = cv::Matx33d::eye();
    bool cut = false;    ///< it begins with another view than the frame before
    bool other = false;  ///< a baseline was given, whose tissue it does not show
    WithoutBaseline why = WithoutBaseline::has_one;
};

/// Shots from the frame at `from` to that at `to`, s, in their order and without gaps. `baseline`, s, is one that was
/// given: it serves its own shot and any other that shows its tissue. The other shots that show tissue and are not
/// brief get the clearest of their frames, or an earlier one that is nearly as clear, unless every one is hazy; they
/// share it where they show the same tissue. Frames that follow each other by more than 0.2 s are not cut: a camera
/// that moves looks the same. Throws Error: bad_input where no frame shows anything or the file cannot give `baseline`;
/// runtime when `progress` stopped it.
std::vector<Shot> find_shots(VideoReader& video, double from, double to, std::optional<double> baseline,
                             const Progress& progress = {});

/// For people: "12.50 s".
std::string seconds_text(double time);
/// A share 0..1: "3.1 %".
std::string percent_text(double share);

/// The longest of those that have a baseline; else of all. Never null for what find_shots() gave.
const Shot* main_shot(const std::vector<Shot>& shots);

}  // namespace lapfx::match
