// Pictures as measuring needs them: linear light, redness, and local contrast that haze does not change.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "lapfx/organ.h"

namespace lapfx::match {

/// The size at which an image is measured: at most 256 px on its longer side, at least 16 on each.
cv::Size working_size_of(const Image& image);

/// An image at `size`, CV_8UC3 BGR; each pixel is the mean of those that it stands for.
void shrink(const Image& image, cv::Size size, cv::Mat& into);

/// sRGB code values (CV_8UC3) as linear light (CV_32FC3), 0..1.
void to_linear(const cv::Mat& code, cv::Mat& linear);
/// One code value, 0..255, as linear light, and back; values between and beyond are allowed.
float linear_of(float code);
float code_of(float linear);
/// code_of from a table, to a tenth of a code value; one for a whole picture.
class QuickCode {
  public:
    QuickCode();
    float operator()(float linear) const {
        return table_[static_cast<int>(std::sqrt(std::clamp(linear, 0.0F, 1.0F)) * static_cast<float>(steps))];
    }
    static constexpr int steps = 4096;

  private:
    const float* table_;  // steps + 1, even in the root of the light: dark values need them most
};

/// Redness (lapfx/scene.h) of one colour in code values, 0..255. The offset keeps the noise of black from being red.
template <typename Number>
constexpr Number redness_of_code(Number red, Number green, Number blue) {
    constexpr Number offset = 8;
    return (red + offset) / (static_cast<Number>(0.5) * (green + blue) + offset);
}
/// Redness of linear light, CV_32FC3 to CV_32F.
void redness_of(const cv::Mat& linear, cv::Mat& redness);

/// What a plain picture has.
inline constexpr int plain_texture = 128;
/// Luma without what is wider than some pixels, divided by its own strength near by: CV_8U around
/// plain_texture. A veil takes contrast away and adds light; both cancel out here.
void texture_of(const cv::Mat& code, cv::Mat& texture);

}  // namespace lapfx::match
