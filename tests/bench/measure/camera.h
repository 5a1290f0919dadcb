// What a camera and an encoder make of a picture whose amounts are known, and the picture as it is measured then. All
// of it is drawn from random numbers; moves act on the picture and on what is known of it alike.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/measure/random.h"
#include "lapfx/organ.h"

namespace lapfx::bench {

/// A picture and what is in each of its pixels.
struct Shown {
    cv::Mat code;   ///< CV_8UC3, BGR
    cv::Mat view;   ///< CV_8U, 255 of the valid view: no surround, no instrument
    cv::Mat blood;  ///< CV_8U, 255
    cv::Mat veil;   ///< CV_32F, 0..1, 1 - transmission
};

struct KnownPicture {
    Image picture;       ///< as it is measured
    double blood = 0.0;  ///< share of the view, 0..1
    double veil = 0.0;   ///< mean over the view, 0..1
    cv::Mat blood_area;  ///< CV_8U, 255 where there is blood in the view
    cv::Mat view;        ///< CV_8U
    bool shifted = false;
    bool counted =
        true;  ///< else it only leads to those that are: the estimator follows the baseline from one to the next
};

/// Pictures that are measured with one baseline.
struct KnownView {
    Image baseline;
    std::vector<KnownPicture> pictures;
    std::map<std::string, std::string> labels;  ///< organ, light and camera of renders; operation of real frames
    std::optional<glm::dvec3> round_view = {};  ///< EstimatorOptions::round_view, where it is known
    bool real = false;
    bool labelled = false;  ///< by a person, who says where the blood is; the veil is not known
    bool moves = false;     ///< the baseline is 1 to 4 s older, and the scene moved since
    bool in_order = false;  ///< each picture follows the one before it
};

/// How a picture lies against the baseline.
struct Move {
    double right = 0.0, down = 0.0;  ///< shares of the picture's width
    double degrees = 0.0;
    double scale = 1.0;
    bool any() const { return right != 0.0 || down != 0.0 || degrees != 0.0 || scale != 1.0; }
};
/// In `share` of the cases 5 to 20 of 256 px, up to 2 degrees and 3 %.
Move draw_move(Random& random, double share);
/// The part of `size` in the middle, moved. What lies beyond the picture is its mirror image.
Shown moved(const Shown& shown, const Move& move, cv::Size size);

/// Factors on the code values of blue, green and red: gain in 70 % of the cases (standard deviation 5 %), white balance
/// in 60 % (3 % a channel).
cv::Scalar draw_gains(Random& random);
/// Those of a camera that drifts from none to `gains`, at a share of the way.
cv::Scalar drifted(const cv::Scalar& gains, double share);

/// Code values of noise, standard deviation.
double draw_noise(Random& random);
/// Gain, and noise of the sensor.
Image filmed(Random& random, const cv::Mat& code, const cv::Scalar& gains, double noise);
/// JPEG of a quality of 45 to 90, and back.
void compress(Random& random, Image& image);

/// Its amounts; the picture is still to be filmed.
KnownPicture known(const Shown& shown);

}  // namespace lapfx::bench
