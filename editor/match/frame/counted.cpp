#include "match/frame/counted.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace lapfx::match {

namespace {

constexpr float hatch_light = 150;
constexpr int hatch_period = 10, hatch_width = 3;  // px of 500 rows

cv::Mat as_large_as(const cv::Mat& layer, const Image& frame, int how) {
    cv::Mat large;
    if (!layer.empty()) cv::resize(layer, large, {frame.width, frame.height}, 0, 0, how);
    return large;
}

}  // namespace

void draw_counted(Image& frame, const Estimator& estimator, const FrameAmounts& amounts, const CountedLayers& drawn) {
    if ((amounts.flags & told::missing) != 0) return;  // the layers are those of another frame
    MeasuredLayers layers;
    if (drawn.left_out) layers.valid = estimator.valid();
    if (drawn.blood && amounts.blood_measurable()) layers.blood = estimator.blood();
    if (drawn.veil && amounts.measurable()) layers.veil = estimator.veil();
    draw_layers(frame, layers);
}

void draw_layers(Image& frame, const MeasuredLayers& layers) {
    const cv::Mat all_valid = as_large_as(layers.valid, frame, cv::INTER_NEAREST);
    const cv::Mat all_blood = as_large_as(layers.blood, frame, cv::INTER_NEAREST);
    const cv::Mat all_veil = as_large_as(layers.veil, frame, cv::INTER_LINEAR);
    const int unit = std::max(1, frame.height / 500);
    for (int y = 0; y < frame.height; ++y) {
        const auto* const valid = all_valid.empty() ? nullptr : all_valid.ptr<std::uint8_t>(y);
        const auto* const blood = all_blood.empty() ? nullptr : all_blood.ptr<std::uint8_t>(y);
        const auto* const veil = all_veil.empty() ? nullptr : all_veil.ptr<float>(y);
        std::uint8_t* to =
            frame.pixels.data() + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width);
        for (int x = 0; x < frame.width; ++x, to += 4) {
            glm::vec3 color(to[0], to[1], to[2]);
            if (valid != nullptr && valid[x] == 0) {
                const bool hatched = (x + y) % (hatch_period * unit) < hatch_width * unit;
                color = left_out_light * color;
                if (hatched) color = 0.5F * color + 0.5F * glm::vec3(hatch_light);
            } else {
                const float tint = veil == nullptr ? 0 : veil_share * std::clamp(veil[x], 0.0F, 1.0F);
                color = (1 - tint) * color + tint * veil_color;
                if (blood != nullptr && blood[x] != 0) color = (1 - blood_share) * color + blood_share * blood_color;
            }
            for (int c = 0; c < 3; ++c) to[c] = cv::saturate_cast<std::uint8_t>(color[c]);
        }
    }
}

}  // namespace lapfx::match
