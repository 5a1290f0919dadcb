#include "match/frame/seen_through.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/frame/smoke_tint.h"

namespace lapfx::match {

namespace {

constexpr int reach = 3;                    // px to each side: a window
constexpr float least_transmission = 0.3F;  // less is denser than smoke gets, or an instrument that reflects tissue
constexpr float most_transmission = 0.97F;  // smoke that adds light hides something
constexpr float least_light = 0.03F;        // linear
constexpr float least_color = 0.015F;       // linear: of the tissue's colour that is left
constexpr float alike = 0.955F;             // share of the colour across the tint that the tissue's own explains
// What may be left of that colour, as a share of the light: the tint of smoke is known to that. Grey metal leaves .145.
constexpr float tint_doubt = 0.115F;

/// What is left of a colour without its part along the tint.
cv::Vec3f across_tint(const cv::Vec3f& color) {
    return color - usual_smoke_tint * (color.dot(usual_smoke_tint) / usual_smoke_tint.dot(usual_smoke_tint));
}

}  // namespace

void SeenThrough::add_up(const cv::Mat& baseline, const cv::Mat& frame, const cv::Rect& box) {
    products_.create(box.size(), CV_32FC3);
    for (int y = 0; y < box.height; ++y)
        for (int x = 0; x < box.width; ++x) {
            const cv::Point at(box.x + x, box.y + y);
            const cv::Vec3f tissue = across_tint(baseline.at<cv::Vec3f>(at)),
                            seen = across_tint(frame.at<cv::Vec3f>(at));
            products_.at<cv::Vec3f>(y, x) = {tissue.dot(tissue), seen.dot(tissue), seen.dot(seen)};
        }
    cv::blur(products_, sums_, {2 * reach + 1, 2 * reach + 1}, {-1, -1}, cv::BORDER_REPLICATE);
}

void SeenThrough::find(const cv::Mat& baseline, const cv::Mat& frame, const cv::Mat& part) {
    smoke_.create(frame.size(), CV_8U);
    veil_.create(frame.size(), CV_32F);
    smoke_.setTo(0);
    const cv::Rect looked_at = cv::boundingRect(part);
    if (looked_at.empty()) return;
    const cv::Rect box =
        (looked_at + cv::Size(2 * reach, 2 * reach) - cv::Point(reach, reach)) & cv::Rect({}, frame.size());
    add_up(baseline, frame, box);
    for (int y = looked_at.y; y < looked_at.br().y; ++y)
        for (int x = looked_at.x; x < looked_at.br().x; ++x) {
            if (part.at<std::uint8_t>(y, x) == 0) continue;
            const auto& [of_tissue, of_both, of_seen] = sums_.at<cv::Vec3f>(y - box.y, x - box.x).val;
            const float transmission = of_both / std::max(of_tissue, 1e-8F);
            if (transmission < least_transmission || transmission > most_transmission ||
                of_both < least_color * std::sqrt(of_tissue))
                continue;
            const cv::Vec3f added = frame.at<cv::Vec3f>(y, x) - transmission * baseline.at<cv::Vec3f>(y, x);
            const float light = added.dot(usual_smoke_tint) / usual_smoke_tint.dot(usual_smoke_tint);
            const float left = of_seen - transmission * of_both, doubt = tint_doubt * light;
            if (light < least_light || left > std::max((1.0F - alike) * of_seen, doubt * doubt)) continue;
            smoke_.at<std::uint8_t>(y, x) = 255;
            veil_.at<float>(y, x) = 1.0F - transmission;
        }
    cv::morphologyEx(smoke_, smoke_, cv::MORPH_OPEN, cv::Mat());  // rims of highlights that moved are one pixel wide
}

}  // namespace lapfx::match
