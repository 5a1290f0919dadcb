#include "match/frame/haze_light.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/frame/veil.h"

namespace lapfx::match {

namespace {

constexpr int turns = 2;
constexpr double prior = 0.5;         // weight of the tint that is assumed
constexpr double least_light = 0.01;  // linear
constexpr double most_tint = 1.35;    // of a channel over the mean of the three
constexpr double outlier = 3.0;       // units of noise
// What explains the frames hardly better than the light that is assumed is not taken: real frames differ from the
// baseline in more than smoke, and any light explains some of that. The gain is that of the logarithm of the loss.
constexpr double plain = 0.4;   // of it for a factor of e in brightness
constexpr double lonely = 0.5;  // more where there is only one frame
constexpr double loss_of_noise = 0.05;

double radius_in(const cv::Rect& box, double x, double y) {
    const double dx = (x - box.x) / std::max(box.width, 1) * 2.0 - 1.0;
    const double dy = (y - box.y) / std::max(box.height, 1) * 2.0 - 1.0;
    return std::hypot(dx, dy);
}

}  // namespace

glm::dvec3 HazeLight::at(double radius) const {
    return color * std::max(1.0 - fall_off * radius * radius, 0.05);
}

cv::Mat HazeLight::over(cv::Size size, const cv::Rect& box) const {
    cv::Mat light(size, CV_32FC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const glm::dvec3 here = at(std::min(radius_in(box, x + 0.5, y + 0.5), 1.1));
            light.at<cv::Vec3f>(y, x) = {static_cast<float>(here.b), static_cast<float>(here.g),
                                         static_cast<float>(here.r)};
        }
    return light;
}

HazeLightSurvey::HazeLightSurvey(const HazeLight& otherwise) : otherwise_(otherwise) {
    for (std::size_t i = 0; i < tried_.size(); ++i)
        tried_[i].light = {.color = otherwise.color * factors[i % factors.size()],
                           .fall_off = fall_offs[i / factors.size()]};
}

/// The tint that explains the frames best, as bright as was tried.
glm::dvec3 HazeLightSurvey::Tried::color() const {
    glm::dvec3 found = glm::max((above + prior * light.color) / (below + prior), least_light);
    const double middle = glm::dot(found, glm::dvec3(1.0 / 3.0));  // smoke is nearly grey
    found = glm::clamp(found, middle / most_tint, middle * most_tint);
    return found * (glm::dot(light.color, glm::dvec3(1.0)) / glm::dot(found, glm::dvec3(1.0)));
}

void HazeLightSurvey::add(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Rect& box) {
    const cv::Size half(frame.cols / 2, frame.rows / 2);
    cv::resize(baseline, small_baseline_, half, 0, 0, cv::INTER_AREA);
    cv::resize(frame, small_frame_, half, 0, 0, cv::INTER_AREA);
    cv::resize(counts, small_counts_, half, 0, 0, cv::INTER_AREA);
    const cv::Rect small_box(box.x / 2, box.y / 2, box.width / 2, box.height / 2);
    VeilSolver solver(0.5);
    for (Tried& tried : tried_) {
        for (int turn = 0; turn < turns; ++turn) {
            const HazeLight shape{.color = tried.color(), .fall_off = tried.light.fall_off};
            const cv::Mat light = shape.over(half, small_box);
            solver.solve_wide(small_baseline_, small_frame_, small_counts_, light, 2);
            const bool last = turn + 1 == turns;
            Tried here;
            for (int y = 0; y < half.height; ++y) {
                const auto *b = small_baseline_.ptr<cv::Vec3f>(y), *f = small_frame_.ptr<cv::Vec3f>(y);
                const auto* h = light.ptr<cv::Vec3f>(y);
                const auto *veil = solver.veil().ptr<float>(y), *weight = solver.weight().ptr<float>(y);
                for (int x = 0; x < half.width; ++x) {
                    const double share = h[x][2] / shape.color.r, vs = veil[x] * share, w = weight[x];
                    const cv::Vec3f left = f[x] - b[x] * (1.0F - veil[x]);
                    here.above += w * vs * glm::dvec3(left[2], left[1], left[0]);
                    here.below += w * vs * vs;
                }
            }
            if (!last) {
                tried.above += here.above;
                tried.below += here.below;
                continue;
            }
            solver.residual(small_baseline_, small_frame_, light, 0.0, rest_);
            for (int y = 0; y < half.height; ++y)
                for (int x = 0; x < half.width; ++x) {
                    const double r = rest_.at<float>(y, x), r2 = r * r / (outlier * outlier);
                    tried.loss += small_counts_.at<float>(y, x) * r2 / (1.0 + r2);
                }
        }
    }
    seen_ += cv::sum(small_counts_)[0];
    ++frames_;
}

/// Where the parabola through three points is lowest; the middle one is the lowest of them.
double lowest_of(const std::array<double, 3>& x, const std::array<double, 3>& y) {
    const double falls = (y[1] - y[0]) / (x[1] - x[0]), rises = (y[2] - y[1]) / (x[2] - x[1]);
    const double bend = (rises - falls) / (x[2] - x[0]);
    return bend > 0.0 ? 0.5 * (x[0] + x[1] - falls / bend) : x[1];
}

HazeLight HazeLightSurvey::found() const {
    if (seen_ <= 0.0) return otherwise_;
    std::array<double, fall_offs.size() * factors.size()> losses;
    const double held = plain * (1.0 + lonely / frames_);
    for (std::size_t i = 0; i < tried_.size(); ++i) {
        const double apart =
            std::abs(std::log(factors[i % factors.size()])) + std::abs(tried_[i].light.fall_off - otherwise_.fall_off);
        losses[i] = std::log(tried_[i].loss / seen_ + loss_of_noise) + held * apart;
    }
    const auto best = static_cast<std::size_t>(std::min_element(losses.begin(), losses.end()) - losses.begin());
    HazeLight light{.color = tried_[best].color(), .fall_off = tried_[best].light.fall_off};
    const std::size_t factor = best % factors.size();
    if (factor == 0 || factor + 1 == factors.size()) return light;
    const std::array<double, 3> bright = {std::log(factors[factor - 1]), std::log(factors[factor]),
                                          std::log(factors[factor + 1])};
    light.color *= std::exp(lowest_of(bright, {losses[best - 1], losses[best], losses[best + 1]}) - bright[1]);
    return light;
}

}  // namespace lapfx::match
