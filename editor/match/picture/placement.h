// Where the baseline lies in a frame: the camera of an operation is never quite still.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace lapfx::match {

/// How alike two textures of texture_of are where `counts` (CV_8U) is not 0: 1 the same, 0 as two pictures of other
/// things; below 0 where one is the other's negative.
double likeness_of(const cv::Mat& a, const cv::Mat& b, const cv::Mat& counts);

/// The baseline's own texture (texture_of) and the points in it that can be found again.
class Placement {
  public:
    Placement() = default;
    /// `texture`: CV_8U of texture_of. `counts`: CV_8U, where there is tissue.
    Placement(cv::Mat texture, const cv::Mat& counts);

    /// Looks for the baseline in a frame's texture, near where it was last; where it is little alike there, the place
    /// goes on as the frame moved against the one before. Gives whether that moved by more than a few pixels.
    bool follow(const cv::Mat& texture);
    /// Begins again, with the baseline at that place.
    void forget(const cv::Matx33d& place = cv::Matx33d::eye());

    /// From the baseline's pixels to the frame's, 3x3.
    const cv::Matx33d& place() const { return place_; }
    bool still() const { return still_; }  ///< the place is where the baseline was taken
    /// How alike the textures are, mean of both signs: 1 the same, 0 as two pictures of other things.
    double likeness() const { return likeness_; }

  private:
    double likeness_at(const cv::Matx33d& place, const cv::Mat& texture);
    /// The baseline lies there if it is more alike there than `least`.
    void take(const cv::Matx33d& place, const cv::Mat& texture, double least);
    /// Looks for points of a picture in now_, near moved_: from_ and to_. Gives whether they are enough for a motion.
    bool find_points(const std::vector<cv::Mat>& before, const std::vector<cv::Point2f>& points);
    cv::Matx33d found_from(const cv::Matx33d& start);
    /// The motion from the last frame to this one, where the baseline lay in it; none: most points there do not agree.
    std::optional<cv::Matx33d> step();

    cv::Mat texture_, counts_, warped_, warped_counts_;
    std::vector<cv::Mat> pyramid_, last_, now_;  // of the baseline; of frames, the last one empty: not known
    std::vector<cv::Point2f> points_, at_, moved_, from_, to_;
    std::vector<unsigned char> found_;
    std::vector<float> errors_;
    cv::Matx33d place_ = cv::Matx33d::eye();
    bool still_ = true;
    double likeness_ = 1.0;
    int lost_ = 0;  // frames
};

/// Whether two frames, one right after the other, show different views: `last` is found nowhere in `now`. A plain
/// picture (black, white, dense smoke) shows no view. Textures of texture_of; `view`: CV_8U, of both.
bool another_view(const cv::Mat& last, const cv::Mat& now, const cv::Mat& view);

}  // namespace lapfx::match
