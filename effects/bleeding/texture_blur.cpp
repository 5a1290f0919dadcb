#include "bleeding/texture_blur.h"

#include <opencv2/imgproc.hpp>

namespace lapfx::bleeding {

namespace {

/// A Gaussian wider than twice this many texels is computed on a reduced image.
constexpr double wide = 2.0;

int border_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::clamp:
            return cv::BORDER_REPLICATE;
        case Wrap::mirror:
            return cv::BORDER_REFLECT;
        case Wrap::repeat:
            break;
    }
    return cv::BORDER_WRAP;
}

}  // namespace

TextureBlur::Axis TextureBlur::reduced(int length, double deviation) {
    const int step = static_cast<int>(std::clamp(deviation / wide, 1.0, double(length)));
    if (step == 1) return {length, deviation};
    const int shorter = (length + step - 1) / step;
    const double there = deviation * shorter / length;
    // Averaging and interpolating blur, too: by 1/12 and 1/6 of a square texel.
    return {shorter, std::min(std::sqrt(std::max(there * there - 0.25, 0.01)), 2.0 * shorter)};
}

TextureBlur::TextureBlur(const cv::Mat& weights, glm::dvec2 deviation, const Beyond& beyond)
    : size_(weights.size()),
      beyond_(beyond),
      x_(reduced(weights.cols, std::max(deviation.x, 0.3))),
      y_(reduced(weights.rows, std::max(deviation.y, 0.3))) {
    blurred_ = blur(weights);
    cv::max(blurred_, 1e-5, blurred_);
}

cv::Mat TextureBlur::blur(const cv::Mat& values) const {
    cv::Mat image = values;
    if (x_.length != values.cols || y_.length != values.rows)
        cv::resize(values, image, cv::Size(x_.length, y_.length), 0, 0, cv::INTER_AREA);
    const int right = beyond_.any ? static_cast<int>(std::ceil(4 * x_.deviation)) + 1 : 0;
    const int down = beyond_.any ? static_cast<int>(std::ceil(4 * y_.deviation)) + 1 : 0;
    if (beyond_.any) {
        cv::copyMakeBorder(image, image, 0, 0, right, right, border_of(beyond_.u));
        cv::copyMakeBorder(image, image, down, down, 0, 0, border_of(beyond_.v));
    }
    const auto taps = [](double deviation) { return 2 * static_cast<int>(std::ceil(3.5 * deviation)) + 1; };
    cv::Mat out;
    cv::GaussianBlur(image, out, cv::Size(taps(x_.deviation), taps(y_.deviation)), x_.deviation, y_.deviation,
                     cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    return beyond_.any ? out(cv::Rect(right, down, x_.length, y_.length)) : out;
}

cv::Mat TextureBlur::operator()(const cv::Mat& weighted) const {
    cv::Mat mean = blur(weighted);
    cv::divide(mean, blurred_, mean);
    if (mean.size() == size_) return mean;
    cv::Mat full;
    cv::resize(mean, full, size_, 0, 0, cv::INTER_LINEAR);
    return full;
}

}  // namespace lapfx::bleeding
