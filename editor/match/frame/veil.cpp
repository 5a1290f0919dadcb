#include "match/frame/veil.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace lapfx::match {

namespace {

// A pixel's noise: that of its code value, that of a baseline that lies a little beside, and a floor.
constexpr float code_noise = 0.008F, shift_noise = 0.10F, floor_noise = 0.003F;
constexpr float darkest_tissue = 0.02F;  // linear, mean of the channels: a darker baseline shows no tissue
constexpr float outlier = 3.0F;          // units of noise from which a pixel counts less
constexpr float least_weight = 0.02F;
constexpr int widest = 90, wide = 34, middle = 13, narrow = 5;  // px to each side
constexpr double hold_widest = 1e-4, hold_wide = 0.01, hold_middle = 0.1, hold_narrow = 0.5;
constexpr int wide_passes = 3;
constexpr float first_guess = 0.1F;
// A veil's own light is part of the frame's, so no channel of the frame is below it (the dark channel): where blood
// takes green and blue there is no veil. The light of smoke is known to that factor.
constexpr float light_slack = 1.25F, bound_slack = 0.02F;
constexpr double most_scaled = 3.0;
constexpr int bound_window = 5;  // px

float noise_of(const cv::Vec3f& baseline, const cv::Vec3f& frame) {
    const float b = (baseline[0] + baseline[1] + baseline[2]) / 3.0F, f = (frame[0] + frame[1] + frame[2]) / 3.0F;
    return code_noise * std::sqrt(std::max(f, 0.0F)) + shift_noise * std::min(b, f) + floor_noise;
}

/// `expected`: the frame's linear light at a place, by the baseline's.
template <class Expected>
double misfit_of(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part, const Expected& expected) {
    double all = 0.0;
    for (int y = 0; y < frame.rows; ++y) {
        const auto *b = baseline.ptr<cv::Vec3f>(y), *f = frame.ptr<cv::Vec3f>(y);
        const auto* in = part.ptr<std::uint8_t>(y);
        for (int x = 0; x < frame.cols; ++x) {
            if (in[x] == 0) continue;
            const float noise = noise_of(b[x], f[x]);
            const cv::Vec3f off = f[x] - expected(b[x], y, x);
            all += static_cast<double>(std::min(off.dot(off) / (noise * noise), outlier * outlier));
        }
    }
    return all;
}

}  // namespace

void VeilSolver::weigh(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light,
                       bool robust) {
    weight_.create(frame.size(), CV_32F);
    for (cv::Mat* m : {&normal_, &normal_of_dark_}) m->create(frame.size(), CV_32FC2);
    dark_.create(frame.size(), CV_8U);
    has_dark_ = false;
    for (int y = 0; y < frame.rows; ++y) {
        const auto *b = baseline.ptr<cv::Vec3f>(y), *f = frame.ptr<cv::Vec3f>(y), *h = light.ptr<cv::Vec3f>(y);
        const auto *count = counts.ptr<float>(y), *veil = veil_.ptr<float>(y);
        auto *of_tissue = normal_.ptr<cv::Vec2f>(y), *of_dark = normal_of_dark_.ptr<cv::Vec2f>(y);
        auto* dark = dark_.ptr<std::uint8_t>(y);
        auto* weight = weight_.ptr<float>(y);
        for (int x = 0; x < frame.cols; ++x) {
            const float noise = noise_of(b[x], f[x]);
            const cv::Vec3f up = h[x] - b[x], rise = f[x] - b[x];
            float w = count[x];
            if (robust && w > 0.0F) {
                const cv::Vec3f off = rise - up * veil[x];
                const float r = off.dot(off) / (noise * noise * outlier * outlier);
                w *= std::max(1.0F / (1.0F + r), least_weight);
            }
            w *= floor_noise * floor_noise / (noise * noise);
            weight[x] = w;
            const cv::Vec2f normal(w * up.dot(up), w * rise.dot(up)), none(0.0F, 0.0F);
            const bool is_dark = b[x][0] + b[x][1] + b[x][2] < 3.0F * darkest_tissue;
            of_tissue[x] = is_dark ? none : normal;
            of_dark[x] = is_dark ? normal : none;
            dark[x] = is_dark ? 255 : 0;
            has_dark_ = has_dark_ || is_dark;
        }
    }
}

void VeilSolver::bound(const cv::Mat& frame, const cv::Mat& light) {
    cv::blur(frame, smooth_, {bound_window, bound_window});
    bound_.create(frame.size(), CV_32F);
    for (int y = 0; y < frame.rows; ++y) {
        const auto *f = smooth_.ptr<cv::Vec3f>(y), *h = light.ptr<cv::Vec3f>(y);
        auto* most = bound_.ptr<float>(y);
        for (int x = 0; x < frame.cols; ++x) {
            const float share = std::min({f[x][0] / h[x][0], f[x][1] / h[x][1], f[x][2] / h[x][2]});
            most[x] = std::clamp(light_slack * share + bound_slack, 0.0F, 1.0F);
        }
    }
}

void VeilSolver::solve_window(int of_estimator, double hold) {
    const int reach = static_cast<int>(std::lround(of_estimator * scale_));
    const cv::Size window(2 * reach + 1, 2 * reach + 1);
    // What one pixel of clear difference, seen without noise, would say.
    const auto held = static_cast<float>(hold * 1e-3);
    cv::boxFilter(normal_, sums_, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
    solve_places(sums_, held, false);
    if (!has_dark_) return;
    cv::boxFilter(normal_of_dark_, sums_, CV_32F, window, {-1, -1}, true, cv::BORDER_CONSTANT);
    solve_places(sums_, held, true);
}

void VeilSolver::solve_places(const cv::Mat& sums, float held, bool dark) {
    for (int y = 0; y < veil_.rows; ++y) {
        const auto* sum = sums.ptr<cv::Vec2f>(y);
        const auto* most = bound_.ptr<float>(y);
        const auto* is_dark = dark_.ptr<std::uint8_t>(y);
        auto* veil = veil_.ptr<float>(y);
        for (int x = 0; x < veil_.cols; ++x)
            if ((is_dark[x] != 0) == dark)
                veil[x] = std::clamp((sum[x][1] + held * veil[x]) / (sum[x][0] + held), 0.0F, most[x]);
    }
}

void VeilSolver::solve_widest() {
    solve_window(widest, hold_widest);  // for places with nothing near by that counts
    solve_window(wide, hold_wide);
}

void VeilSolver::solve_wide(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light,
                            int passes) {
    veil_.create(frame.size(), CV_32F);
    veil_ = first_guess;
    bound(frame, light);
    for (int pass = 0; pass < passes; ++pass) {
        weigh(baseline, frame, counts, light, pass > 0);
        solve_widest();
    }
}

void VeilSolver::solve(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light) {
    solve_wide(baseline, frame, counts, light, wide_passes - 1);
    refine(baseline, frame, counts, light);
}

void VeilSolver::refine(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts, const cv::Mat& light) {
    weigh(baseline, frame, counts, light, true);
    solve_widest();
    weigh(baseline, frame, counts, light, true);
    solve_window(middle, hold_middle);
    solve_window(narrow, hold_narrow);
}

void VeilSolver::solve_narrow(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& counts,
                              const cv::Mat& light, const cv::Mat& start) {
    start.copyTo(veil_);
    bound(frame, light);
    weigh(baseline, frame, counts, light, false);
    solve_window(narrow, hold_middle);
}

void VeilSolver::scale_to(double mean, const cv::Mat& part) {
    const double was = cv::mean(veil_, part)[0];
    const double factor = was > 0.0 ? std::min(mean / was, most_scaled) : 1.0;
    cv::min(veil_ * factor, 1.0, veil_);
    cv::min(cv::max(veil_ + (mean - cv::mean(veil_, part)[0]), 0.0), 1.0, veil_);
}

void VeilSolver::residual(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& light, double light_error,
                          cv::Mat& into) const {
    into.create(frame.size(), CV_32F);
    const auto of_light = static_cast<float>(light_error);
    for (int y = 0; y < frame.rows; ++y) {
        const auto *b = baseline.ptr<cv::Vec3f>(y), *f = frame.ptr<cv::Vec3f>(y), *h = light.ptr<cv::Vec3f>(y);
        const auto* veil = veil_.ptr<float>(y);
        auto* to = into.ptr<float>(y);
        for (int x = 0; x < frame.cols; ++x) {
            const cv::Vec3f off = f[x] - b[x] - (h[x] - b[x]) * veil[x], doubt = h[x] * (of_light * veil[x]);
            const float noise = noise_of(b[x], f[x]);
            to[x] = std::sqrt(off.dot(off) / (noise * noise + doubt.dot(doubt)));
        }
    }
}

double VeilSolver::misfit(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part,
                          const cv::Mat& light) const {
    return misfit_of(baseline, frame, part, [&](const cv::Vec3f& b, int y, int x) {
        return b + (light.at<cv::Vec3f>(y, x) - b) * veil_.at<float>(y, x);
    });
}

double standing_out(const cv::Mat& veil, const cv::Mat& part, std::vector<float>& sorted) {
    sorted.clear();
    for (int y = 0; y < veil.rows; ++y)
        for (int x = 0; x < veil.cols; ++x)
            if (part.at<std::uint8_t>(y, x) != 0) sorted.push_back(veil.at<float>(y, x));
    if (sorted.empty()) return 0.0;
    const auto middle = sorted.begin() + std::ssize(sorted) / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    double above = 0.0;
    for (auto value = middle; value != sorted.end(); ++value) above += static_cast<double>(*value - *middle);
    return above / static_cast<double>(sorted.size());
}

double misfit_of_gains(const cv::Mat& baseline, const cv::Vec3f& gains, const cv::Mat& frame, const cv::Mat& part) {
    return misfit_of(baseline, frame, part, [&](const cv::Vec3f& b, int, int) { return b.mul(gains); });
}

}  // namespace lapfx::match
