#include "app/reference/placed_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/picture/round_view.h"

namespace lapfx::app {

namespace {

// Heights: where the rim that shaders/post.frag draws is half as bright as inside, in code values.
constexpr double vignette_radius = 0.562;

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

}  // namespace

std::optional<ReferencePlacement> on_the_vignette(const Image& image, const ReferencePlacement& now) {
    cv::Mat bgr;
    cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data())), bgr,
                 cv::COLOR_RGBA2BGR);
    const auto disc = match::round_view(bgr);
    if (!disc) return std::nullopt;
    const double height = image.height, aspect = image.width / height;
    ReferencePlacement found{.scale = rounded(vignette_radius * height / disc->radius), .rotation = now.rotation};
    const glm::dvec2 shift = glm::dvec2(aspect / 2, 0.5) - placed(found, aspect, (disc->center + 0.5) / height);
    found.right = rounded(shift.x), found.up = rounded(-shift.y);
    return found;
}

}  // namespace lapfx::app
