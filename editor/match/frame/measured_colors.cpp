#include "match/frame/measured_colors.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "match/frame/smoke_tint.h"
#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

/// Sum of colours that are given as blue, green and red.
class MeanColor {
  public:
    void add(const cv::Vec3f& color) {
        sum_ += glm::dvec3(color[2], color[1], color[0]);
        ++count_;
    }
    std::optional<glm::dvec3> found() const {
        if (count_ < least_pixels) return {};
        return sum_ / static_cast<double>(count_);
    }

  private:
    glm::dvec3 sum_{0.0};
    int count_ = 0;
};

/// Of each channel the mean of its middle half, so that places that were taken for it do not count, or those of which
/// more was taken away than there was.
class MiddleColor {
  public:
    void add(const cv::Vec3f& color) {
        for (int c = 0; c < 3; ++c) channels_[c].push_back(color[2 - c]);
    }
    std::optional<glm::dvec3> found() {
        if (channels_[0].size() < static_cast<std::size_t>(least_pixels)) return {};
        return glm::max(glm::dvec3(middle(channels_[0]), middle(channels_[1]), middle(channels_[2])), 0.0);
    }

  private:
    static double middle(std::vector<float>& values) {
        std::sort(values.begin(), values.end());
        const auto quarter = static_cast<std::ptrdiff_t>(values.size() / 4);
        const double sum = std::accumulate(values.begin() + quarter, values.end() - quarter, 0.0);
        return sum / static_cast<double>(std::ssize(values) - 2 * quarter);
    }

    std::array<std::vector<float>, 3> channels_;
};

/// The light of dense smoke, by what the veil put before the tissue: frame = baseline * (1 - veil) + light * veil, over
/// all pixels together. The light that was assumed to find the veil has little to say in it.
class SmokeLight {
  public:
    void add(const cv::Vec3f& seen, const cv::Vec3f& clear, const cv::Vec3f& assumed, float veil) {
        if (std::max({seen[0], seen[1], seen[2], clear[0], clear[1], clear[2]}) >= white) return;
        sum_ += seen - (1.0F - veil) * clear;
        assumed_ += assumed * veil;
        veil_ += veil;
        if (veil >= colored_veil) ++count_;
    }
    std::optional<glm::dvec3> found() const {
        if (count_ < least_pixels) return {};
        return glm::clamp(glm::dvec3(sum_[2], sum_[1], sum_[0]) / veil_, least_light, 1.0);
    }
    /// By what the assumed light has to be multiplied, blue, green, red.
    cv::Vec3f over_assumed() const {
        if (count_ < least_pixels) return cv::Vec3f::all(1.0F);
        cv::Vec3f factor;
        for (int c = 0; c < 3; ++c)
            factor[c] = static_cast<float>(std::clamp(sum_[c] / std::max(assumed_[c], 1e-9), 1.0 / most, most));
        return factor;
    }

  private:
    static constexpr float white = 0.9F;          // highlights say nothing
    static constexpr double least_light = 0.002;  // what the camera took away may look as if there were none
    static constexpr double most = 4.0;
    cv::Vec3d sum_, assumed_;
    double veil_ = 0.0;
    int count_ = 0;
};

/// Whether two colours have about the same tint.
bool agree(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double most = 1.25;
    const glm::dvec3 ratio = (a / light_of(a)) / glm::max(b / light_of(b), 1e-6);
    return std::max({ratio.r, ratio.g, ratio.b}) <= most && std::min({ratio.r, ratio.g, ratio.b}) >= 1.0 / most;
}

}  // namespace

double light_of(const glm::dvec3& color) {
    return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
}

MeasuredColors colors_of(const Image& frame, const ColorLayers& layers) {
    cv::Mat code, seen, clear;
    shrink(frame, layers.valid.size(), code);
    to_linear(code, seen);
    to_linear(layers.baseline, clear);
    MeanColor tissue;
    MiddleColor blood;
    SmokeLight smoke;
    const auto each = [&](const auto& take) {
        for (int y = 0; y < seen.rows; ++y)
            for (int x = 0; x < seen.cols; ++x)
                if (layers.valid.at<std::uint8_t>(y, x) != 0)
                    take(seen.at<cv::Vec3f>(y, x), clear.at<cv::Vec3f>(y, x), layers.light.at<cv::Vec3f>(y, x),
                         layers.veil.at<float>(y, x), layers.blood.at<std::uint8_t>(y, x) != 0);
    };
    each([&](const cv::Vec3f& shown, const cv::Vec3f& behind, const cv::Vec3f& assumed, float veil, bool is_blood) {
        tissue.add(behind);
        if (!is_blood) smoke.add(shown, behind, assumed, veil);
    });
    const cv::Vec3f factor = smoke.over_assumed();
    each([&](const cv::Vec3f& shown, const cv::Vec3f&, const cv::Vec3f& assumed, float veil, bool is_blood) {
        if (is_blood && veil <= dense_veil) blood.add((shown - assumed.mul(factor) * veil) * (1.0F / (1.0F - veil)));
    });
    return {.blood = blood.found(), .smoke = smoke.found(), .tissue = tissue.found(), .tinted = false};
}

MeasuredColors colors_of(const Image& frame, const Estimator& estimator) {
    MeasuredColors found = colors_of(frame, {.blood = estimator.blood(),
                                             .veil = estimator.veil(),
                                             .valid = estimator.valid(),
                                             .light = estimator.light(),
                                             .baseline = estimator.baseline()});
    if (!found.smoke) return found;
    cv::Mat code, seen, clear;
    shrink(frame, estimator.working_size(), code);
    to_linear(code, seen);
    to_linear(estimator.baseline(), clear);
    const auto tint = smoke_tint({seen, clear, estimator.veil(), estimator.light(), estimator.valid()});
    found.tinted = tint && agree(*tint, *found.smoke);
    return found;
}

}  // namespace lapfx::match
