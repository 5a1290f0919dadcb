#include "app/reference/placed_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "match/round_view.h"

namespace lapfx::app {

namespace {

// Heights: where the rim that shaders/post.frag draws is half as bright as inside, in code values.
constexpr double vignette_radius = 0.562;

/// Counter-clockwise as it is seen.
glm::dvec2 turned(glm::dvec2 arm, double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    return {c * arm.x + s * arm.y, c * arm.y - s * arm.x};
}

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

}  // namespace

glm::dvec2 placed(const ReferencePlacement& placement, double aspect, glm::dvec2 place) {
    const glm::dvec2 middle(aspect / 2, 0.5);
    return middle + glm::dvec2(placement.right, -placement.up) +
           placement.scale * turned(place - middle, placement.rotation);
}

Image placed(const Image& image, const ReferencePlacement& placement, double aspect) {
    Image made{.width = image.width, .height = image.height, .pixels = {}, .name = image.name};
    made.pixels.resize(image.pixels.size());
    const glm::dvec2 size(image.width, image.height), heights(aspect / size.x, 1 / size.y);
    cv::Point2f from[3], to[3];
    const glm::dvec2 corners[] = {{0, 0}, {size.x, 0}, {0, size.y}};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 shown = placed(placement, aspect, corners[i] * heights) / heights;
        from[i] = cv::Point2f(float(corners[i].x - 0.5), float(corners[i].y - 0.5));  // of middles of pixels
        to[i] = cv::Point2f(float(shown.x - 0.5), float(shown.y - 0.5));
    }
    const cv::Mat source(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::Mat target(image.height, image.width, CV_8UC4, made.pixels.data());
    cv::warpAffine(source, target, cv::getAffineTransform(from, to), target.size(), cv::INTER_LINEAR,
                   cv::BORDER_CONSTANT, cv::Scalar(0, 0, 0, 0));
    return made;
}

std::optional<ReferencePlacement> on_the_vignette(const Image& image, const ReferencePlacement& now) {
    cv::Mat bgr;
    cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data())), bgr,
                 cv::COLOR_RGBA2BGR);
    const auto disc = match::round_view(bgr);
    if (!disc) return std::nullopt;
    const double height = image.height, aspect = image.width / height;
    const glm::dvec2 off = (disc->center + 0.5) / height - glm::dvec2(aspect / 2, 0.5);
    ReferencePlacement found = now;
    found.scale = rounded(vignette_radius * height / disc->radius);
    const glm::dvec2 shift = -found.scale * turned(off, now.rotation);
    found.right = rounded(shift.x), found.up = rounded(-shift.y);
    return found;
}

}  // namespace lapfx::app
