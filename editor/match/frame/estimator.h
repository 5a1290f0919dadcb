// Measures how much blood and how much smoke one frame of a surgery video shows, against a clear frame of the same
// view, its baseline.
//
//     match::Estimator estimator(clear_frame, {.blood = scene.reference.measure.blood});
//     match::FrameAmounts amounts = estimator.measure(frame, 12.5);
//     draw(estimator.blood(), estimator.veil());  // the layers of the frame measured last
//
// Blood: share of the valid view where a film of it explains what changed, with the veil removed; where the baseline
// does not lie well, what is redder than all of its tissue near by. Where a person painted blood and what is none
// (painted_blood.h), it is all that looks like it, and the veil stays as it is.
// What the camera changed, exposure and white balance, is no amount: where that explains the frame better than smoke,
// both are looked for over the baseline as it would be now (camera_gains.h). Veil: 1 - transmission of the smoke, mean
// over the valid view. Beside both, the light that smoke adds and the camera's gain are told (added_light.h).
// The model is that of scattering: a frame is baseline * (1 - veil) + light * veil, where `light`
// is the colour of dense smoke at each place (haze_light.h). The mean is told by a model that was learned
// (veil_model.h), which also knows frames over which the baseline does not lie exactly; the map has its mean, but where
// tissue is seen through bright smoke (seen_through.h). The valid view has no black surround, no instruments, no masked
// parts and no burnt-in text. One thread at a time, any thread; no OpenGL. Pictures are measured at working_size(),
// whatever their own size.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/scene.h"
#include "match/frame/frame_amounts.h"
#include "match/frame/haze_light.h"
#include "match/frame/veil_model.h"
#include "match/picture/view.h"

namespace lapfx::match {

class PaintedBlood;  // match/frame/painted_blood.h

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
    std::vector<MaskPolygon> masks = {};  ///< drawn by the user: left out
    /// The round view: its middle, fractions of width and height, and radius, of the height; none: it is looked for.
    std::optional<glm::dvec3> round_view = {};
    double round_aspect = 0.0;  ///< width over height with which it is round; 0: that of the pictures
    /// Nothing moves, as in a preview without a plate: tissue that is little alike is covered, and not elsewhere.
    bool still = false;
    std::shared_ptr<const Survey> survey = {};         ///< of the same baseline, when it is known already
    std::shared_ptr<const VeilModel> veil_model = {};  ///< of the mean veil; none: the shipped one
    /// What a person's strokes say of this video's blood; none: what is new since the baseline is looked for.
    std::shared_ptr<const PaintedBlood> painted_blood = {};
    /// By what the baseline's own blood is told, which then counts in each frame beside what is new: a preview over a
    /// plate that bleeds already is measured as the video is by strokes. None: the baseline has none.
    std::shared_ptr<const PaintedBlood> held_blood = {};
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
    /// How much of the baseline's tissue is as red as blood by the qualifier, 0..1: it may hold as much blood, which no
    /// frame is told to have, since only what is new is measured.
    double as_red_as_blood() const;

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
