// Measures how much blood and how much smoke one frame of a surgery video shows, against a clear frame of the same
// view, its baseline.
//
//     match::Estimator estimator(clear_frame, {.blood = scene.reference.measure.blood});
//     match::FrameAmounts amounts = estimator.measure(frame, 12.5);
//     draw(estimator.blood(), estimator.veil());  // the layers of the frame measured last
//
// Blood: share of the valid view where a film of it explains what changed, with the veil removed; where the baseline
// does not lie well, whose colour became redder than the qualifier asks.
// What the camera changed, exposure and white balance, is no amount: where that explains the frame better than smoke,
// both are looked for over the baseline as it would be now (camera_gains.h). Veil: 1 - transmission of the smoke, mean
// over the valid view. The model is that of scattering: a frame is baseline * (1 - veil) + light * veil, where `light`
// is the colour of dense smoke at each place (haze_light.h). The mean is told by a model that was learned
// (veil_model.h), which also knows frames over which the baseline does not lie exactly; the map has its mean. The valid
// view has no black surround, no instruments, no masked parts and no burnt-in text. One thread at a time, any thread;
// no OpenGL. Pictures are measured at working_size(), whatever their own size.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/scene.h"
#include "match/haze_light.h"
#include "match/veil_model.h"

namespace lapfx::match {

/// A measured share, 0..1, and its interval: it holds the true one in about nine of ten pictures whose amounts are
/// known, renders and known smoke and blood over real frames, to which it was fitted (interval.cpp). How often it does
/// for smoke and blood of real videos, which nobody knows, is not known.
struct Amount {
    double value = 0.0, low = 0.0, high = 0.0;
};

/// What is told about a frame besides its amounts: bits of FrameAmounts::flags.
namespace told {
enum : unsigned {
    cut = 1U << 0,             ///< another view than in the frame before, which showed one
    motion = 1U << 1,          ///< the camera moved strongly since the frame before
    not_measurable = 1U << 2,  ///< the tissue of the baseline is not in view: amounts mean nothing
    dark = 1U << 3,            ///< the picture is black: amounts mean nothing
    missing = 1U << 4,         ///< the file could not give this frame: it has no amounts
    bleached = 1U << 5,        ///< large parts are at full white: nothing can be read there
    tinted = 1U << 6,          ///< the white balance differs from the baseline's
    dense = 1U << 7,           ///< the veil is denser than dense_veil: blood behind it means nothing
    bag = 1U << 8,             ///< no tissue, but something plain fills the view: amounts mean nothing
    trocar = 1U << 9,          ///< the inside of a trocar is around what is seen: amounts mean nothing
    no_baseline = 1U << 10,    ///< no clear frame shows this shot's tissue: there is nothing to measure against
    unregistered = 1U << 11,   ///< tissue, but that of the baseline is not found in its place: blood means nothing
    /// Any of those without which both amounts are found.
    unmeasured = not_measurable | dark | missing | bag | trocar | no_baseline,
    bloodless = unmeasured | dense | unregistered,  ///< any of those without which blood is found
};
}

/// Mean veil beyond which blood is hidden: of a veil of one half nine tenths of the blood were missed.
inline constexpr double dense_veil = 0.4;

/// One row for each bit, in their order.
struct ToldRow {
    unsigned bit;
    std::string_view key;   ///< in the flags of CSV and JSON: "not_measurable"
    std::string_view help;  ///< for people, as the end of "12 frames: ..."
};
inline constexpr ToldRow told_rows[] = {
    {told::cut, "cut", "another view than in the frame before"},
    {told::motion, "motion", "the camera moves strongly; the baseline is laid over the new place"},
    {told::not_measurable, "not_measurable",
     "not measurable, because the tissue of the baseline is not in view: another view, something before it, or liquid "
     "on the lens"},
    {told::dark, "dark", "not measurable, because the picture is black"},
    {told::missing, "missing", "not measurable, because the file cannot give them"},
    {told::bleached, "bleached", "a quarter or more of the view is at full white, where nothing can be read"},
    {told::tinted, "tinted",
     "the white balance differs from that of the baseline, which may be taken for smoke or blood"},
    {told::dense, "dense", "blood is not measurable, because the veil before it is denser than 40 %"},
    {told::bag, "bag",
     "not measurable, because no tissue is in view: a bag, a cloth, a title card or another plain thing fills it"},
    {told::trocar, "trocar", "not measurable, because the view is that out of a trocar"},
    {told::no_baseline, "no_baseline", "not measurable, because no clear frame of the same view is known"},
    {told::unregistered, "unregistered",
     "blood is not measurable, because the tissue of the baseline is not found in its place: the camera or the tissue "
     "moved far"},
};

struct FrameAmounts {
    double time = 0.0;      ///< s of the video
    Amount blood = {};      ///< area fraction of the valid view
    Amount veil = {};       ///< mean over the valid view of 1 - transmission of the smoke
    double valid = 0.0;     ///< share of the picture that is the valid view, 0..1
    double likeness = 0.0;  ///< how much of the baseline's texture is there, also where it moved; 0 none .. 1 all
    double rest = 0.0;      ///< share of the frame's light that neither tissue, smoke nor blood explain
    double hidden = 0.0;    ///< share of the valid view where smoke or the dark hides the colour
    unsigned flags = 0;     ///< bits of told::
    /// Without a baseline: how hazy the frame looks by itself, 0 the least and 1 the most of its shot, and how far that
    /// differs from frame to frame. Only order and course mean something: pale tissue looks as thick smoke does.
    std::optional<Amount> course = {};
    bool measurable() const { return (flags & told::unmeasured) == 0; }
    bool blood_measurable() const { return (flags & told::bloodless) == 0; }
};

/// A part of the picture that is not measured: corners as fractions of the picture, from its upper left corner.
using Part = std::vector<glm::dvec2>;

/// What several frames of a video say about its view; found by Estimator::survey.
struct Survey {
    HazeLight light;    ///< of dense smoke
    cv::Mat brightest;  ///< CV_8UC3, BGR: the most that each pixel showed, which has the widest view; empty: not seen
    cv::Mat overlay;    ///< CV_8U, 255: burnt-in text and logos; empty: none
};

struct EstimatorOptions {
    BloodQualifier blood = {};
    /// The part that is measured: x, y, width, height as fractions of the picture.
    glm::dvec4 region{0.0, 0.0, 1.0, 1.0};
    std::vector<Part> masks = {};  ///< drawn by the user: left out
    /// The round view: its middle, fractions of width and height, and radius, of the height; none: it is looked for.
    std::optional<glm::dvec3> round_view = {};
    std::shared_ptr<const Survey> survey = {};         ///< of the same baseline, when it is known already
    std::shared_ptr<const VeilModel> veil_model = {};  ///< of the mean veil; none: the shipped one
};

class Estimator {
  public:
    /// `baseline`: a frame without smoke and blood. Throws Error (bad_input) when it is black or the region is empty.
    Estimator(const Image& baseline, const EstimatorOptions& options);
    Estimator(Estimator&&) noexcept;
    Estimator& operator=(Estimator&&) noexcept;
    ~Estimator();

    /// Another qualifier, from the next frame on; cheap.
    void set_blood(const BloodQualifier& blood);
    /// Takes in what another frame of the video, with smoke for one, says about the view. Gives whether it did: not
    /// from a frame that is black, white or does not show the tissue of the baseline, nor when the options gave the
    /// survey.
    bool survey(const Image& frame);
    std::shared_ptr<const Survey> surveyed() const;

    /// `frame` has the shape of the baseline, at any size. Frames follow each other in time: cuts and strong motion are
    /// found from one to the next; forget() begins again. `place`: where the baseline lies in the next frame, from its
    /// pixels to those of the frame, both as fractions of the width.
    FrameAmounts measure(const Image& frame, double time);
    void forget(const cv::Matx33d& place = cv::Matx33d::eye());

    // --- the layers of the frame measured last, at working_size() ---------------------------------------------------
    cv::Size working_size() const;
    const cv::Mat& blood() const;     ///< CV_8U, 255 where there is blood
    const cv::Mat& veil() const;      ///< CV_32F, veil density 0..1
    const cv::Mat& valid() const;     ///< CV_8U, 255 in the valid view
    const cv::Mat& light() const;     ///< CV_32FC3, BGR, linear light of dense smoke at each place
    const cv::Mat& baseline() const;  ///< CV_8UC3, BGR, as it was laid over the frame
    /// What the mean veil was told from; a model is learned from these.
    const VeilFigures& veil_figures() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::match
