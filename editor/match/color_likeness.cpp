#include "match/color_likeness.h"

#include "match/color_difference.h"
#include "match/colors.h"
#include "match/smoke_tint.h"

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

std::optional<double> difference(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
    if (!a || !b) return {};
    return delta_e_2000(lab_of_linear(*a), lab_of_linear(*b));
}

/// Without a tint only how bright it is.
std::optional<glm::dvec3> smoke_of(const MeasuredColors& colors, bool tinted) {
    if (!colors.smoke || tinted) return colors.smoke;
    return glm::dvec3(light_of(*colors.smoke));
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
    MeanColor blood, smoke, tissue;
    for (int y = 0; y < seen.rows; ++y) {
        const auto* valid = layers.valid.ptr<std::uint8_t>(y);
        const auto* is_blood = layers.blood.ptr<std::uint8_t>(y);
        const auto* veil = layers.veil.ptr<float>(y);
        const auto* light = layers.light.ptr<cv::Vec3f>(y);
        for (int x = 0; x < seen.cols; ++x) {
            if (valid[x] == 0) continue;
            tissue.add(clear.at<cv::Vec3f>(y, x));
            if (veil[x] >= colored_veil) smoke.add(light[x]);
            if (is_blood[x] == 0 || veil[x] > dense_veil) continue;
            blood.add((seen.at<cv::Vec3f>(y, x) - light[x] * veil[x]) * (1.0F / (1.0F - veil[x])));
        }
    }
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
    if (const auto tint = smoke_tint({seen, clear, estimator.veil(), estimator.light(), estimator.valid()})) {
        found.smoke = *tint * (light_of(*found.smoke) / light_of(*tint));
        found.tinted = true;
    }
    return found;
}

ColorLikeness likeness_of(const MeasuredColors& preview, const MeasuredColors& reference) {
    const bool tinted = preview.tinted && reference.tinted;
    return {.blood = difference(preview.blood, reference.blood),
            .smoke = difference(smoke_of(preview, tinted), smoke_of(reference, tinted)),
            .tissue = difference(preview.tissue, reference.tissue)};
}

}  // namespace lapfx::match
