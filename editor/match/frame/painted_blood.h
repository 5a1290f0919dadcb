// The blood of one video, learned from strokes that a person painted over one or two of its frames, and found in any
// other: all that is in view, whatever a baseline held.
//
//     const match::PaintedBlood blood(strokes, pictures, {.picture = &baseline}, {});
//     match::Estimator estimator(baseline, {.painted_blood = std::make_shared<const match::PaintedBlood>(blood)});
//
// A logistic regression on colour and texture (blood_features.h). Blood is where its chance, blurred, is above a
// threshold: the lowest of .5, .6 ... .9 by which hardly anything of a frame without blood is taken for it; the highest
// where no such frame is known, since at .5 far too much is. The same strokes give the same blood. After it was made,
// any thread; no OpenGL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/organ.h"
#include "match/frame/blood_features.h"
#include "match/frame/blood_strokes.h"
#include "match/frame/logistic.h"
#include "match/picture/view.h"

namespace lapfx::match {

/// A frame that was painted over.
struct PaintedPicture {
    Image picture;
    std::vector<std::size_t> strokes;  ///< which of BloodStrokes::strokes, in their order
};

/// Whether a frame has no blood: then it is learned from, too, and says which threshold is needed.
enum class WithoutBlood : std::uint8_t {
    no,
    maybe,  ///< it counts as without where strokes of both kinds are there and hardly anything in it looks as they say
    yes
};
/// Of the view of a frame without blood: so much may be taken for it.
inline constexpr double most_found_without = 0.005;

/// A frame without smoke.
struct ClearPicture {
    const Image* picture = nullptr;  ///< null: none is known
    WithoutBlood without_blood = WithoutBlood::maybe;
};

class PaintedBlood {
  public:
    /// `part`: of the pictures, what is looked at. Blood in a frame that is said to have none, as a baseline may, would
    /// be learned as none. Throws Error (bad_input), naming the file and the place, where no stroke marks blood, where
    /// nothing says what is none (neither a stroke nor a frame without blood), and for a stroke outside of the view.
    PaintedBlood(const BloodStrokes& strokes, std::span<const PaintedPicture> pictures, const ClearPicture& clear,
                 const LookedAt& part);

    /// haze_of() a frame without smoke at working_size_of(), for find().
    cv::Mat haze_of(const cv::Mat& code) const;
    /// `code`: CV_8UC3, BGR, a frame at working_size_of(); `clear_haze`: haze_of() the clear frame of its view, or
    /// empty. `blood`: CV_8U, 255 where there is blood.
    void find(const cv::Mat& code, const cv::Mat& clear_haze, cv::Mat& blood) const;
    /// Of the chance, 0.5 to 0.9.
    double threshold() const { return threshold_; }
    /// Whether the clear picture counted as without blood.
    bool without_blood() const { return without_blood_; }
    /// Share of the view of the clear picture that find() takes for blood though it counts as without, 0..1: more than
    /// most_found_without where no threshold spares it.
    double found_without() const { return found_without_; }
    /// Share of what the strokes mark as blood that find() gives in the frames that were painted, 0..1: where it is
    /// little, they marked what does not look like blood, or not like one blood.
    double found_again() const { return found_again_; }

  private:
    struct Examples;
    struct Lesson;
    Lesson lesson_of(const PaintedPicture& painted, const cv::Mat& clear_haze, const BloodStrokes& strokes) const;
    double found_in(std::span<const Lesson> lessons, const cv::Mat& clear_haze) const;
    void add_some(Examples& examples, const cv::Mat& code, const cv::Mat& clear_haze) const;
    cv::Mat chance_in(const cv::Mat& code, const cv::Mat& view, const cv::Mat& clear_haze) const;
    double choose_threshold(const cv::Mat& code, const cv::Mat& clear_haze);

    LookedAt part_;
    Logistic learned_;
    double threshold_ = 0.0;
    bool without_blood_ = false;
    double found_without_ = 0.0, found_again_ = 0.0;
};

}  // namespace lapfx::match
