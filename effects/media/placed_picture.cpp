#include "lapfx/authoring/placed_picture.h"

#include <cmath>

#include "media/opencv.h"

namespace lapfx {

namespace {

/// Counter-clockwise as it is seen.
glm::dvec2 turned(glm::dvec2 arm, double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    return {c * arm.x + s * arm.y, c * arm.y - s * arm.x};
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
    cv::Mat4b target = media::pixels_of(made);
    cv::warpAffine(media::pixels_of(image), target, cv::getAffineTransform(from, to), target.size(), cv::INTER_LINEAR,
                   cv::BORDER_CONSTANT, cv::Scalar(0, 0, 0, 0));
    return made;
}

}  // namespace lapfx
