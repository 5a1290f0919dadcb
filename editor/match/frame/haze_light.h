// The light of dense smoke: what a frame would show at each place if nothing came through from behind. The endoscope's
// lamp lights it, so it is brightest in the middle and falls off to the rim.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <opencv2/core.hpp>

namespace lapfx::match {

struct HazeLight {
    glm::dvec3 color{0.22, 0.18, 0.22};  ///< linear light, red, green, blue, in the middle of the view
    double fall_off = 0.3;               ///< share of it that is missing at the rim of the view, 0..1

    /// Linear light at a distance from the middle of the view, in its radii.
    glm::dvec3 at(double radius) const;
    /// At each pixel, CV_32FC3 (blue, green, red), for a view that fills `box`.
    cv::Mat over(cv::Size size, const cv::Rect& box) const;
};

/// What frames say about the light: of a grid of fall-offs and brightnesses, that with which the veiled baseline
/// explains the frames best. Where the tissue has contrast, only the right light does; its tint follows for each.
class HazeLightSurvey {
  public:
    explicit HazeLightSurvey(const HazeLight& otherwise = {});
    /// `baseline`, `frame`: linear light, CV_32FC3; `counts`: CV_32F, 0..1; `box`: around the view.
    void add(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Rect& box);
    /// The light, as far as it was seen.
    HazeLight found() const;

  private:
    static constexpr std::array<double, 4> fall_offs{0.0, 0.25, 0.5, 0.75};
    static constexpr std::array<double, 9> factors{0.35, 0.5, 0.65, 0.8, 1.0, 1.25, 1.55, 1.9, 2.4};  ///< of brightness
    struct Tried {
        HazeLight light;
        glm::dvec3 above{0.0};  // sums of the normal equation of each channel
        double below = 0.0;
        double loss = 0.0;  // what stays unexplained
        glm::dvec3 color() const;
    };

    HazeLight otherwise_;
    std::array<Tried, fall_offs.size() * factors.size()> tried_{};
    double seen_ = 0.0;
    int frames_ = 0;
    cv::Mat small_baseline_, small_frame_, small_counts_, rest_;
};

}  // namespace lapfx::match
