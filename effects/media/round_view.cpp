#include "lapfx/authoring/round_view.h"

#include <algorithm>
#include <cmath>

#include "media/opencv.h"
#include "media/valid_view.h"

namespace lapfx {

namespace {

constexpr int looked_at_height = 360;  // px: a rim is found as exactly, and much sooner, than in a large picture

}  // namespace

std::optional<double> aspect_of_round_view(const Image& picture) {
    if (picture.width < 1 || picture.height < 1 || picture.pixels.empty()) return std::nullopt;
    const double scale = std::min(1.0, static_cast<double>(looked_at_height) / picture.height);
    Image small{.width = std::max(1, static_cast<int>(std::lround(picture.width * scale))),
                .height = std::max(1, static_cast<int>(std::lround(picture.height * scale))),
                .pixels = {},
                .name = {}};
    small.pixels.resize(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    cv::Mat4b pixels = media::pixels_of(small);
    cv::resize(media::pixels_of(picture), pixels, pixels.size(), 0, 0, cv::INTER_AREA);
    const std::optional<media::ViewDisc> disc = media::valid_view(small).disc;
    if (!disc) return std::nullopt;
    const glm::dvec2 radius = disc->radius / glm::dvec2(pixels.cols, pixels.rows);  // shares of the picture
    return radius.y / radius.x;
}

}  // namespace lapfx
