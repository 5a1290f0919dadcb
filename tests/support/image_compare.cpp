#include "support/image_compare.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

namespace lapfx::tests {
namespace {

std::string describe(const cv::Mat& image) {
    if (image.empty()) return "nothing";
    std::ostringstream text;
    text << image.cols << 'x' << image.rows << " with " << image.channels() << " channel"
         << (image.channels() == 1 ? "" : "s") << " of " << 8 * image.elemSize1() << " bits";
    return text.str();
}

bool comparable(const cv::Mat& a, const cv::Mat& b) {
    return !a.empty() && a.depth() == CV_8U && a.type() == b.type() && a.size() == b.size();
}

/// The error of each pixel: the largest difference of its channels.
cv::Mat1b pixel_differences(const cv::Mat& reference, const cv::Mat& candidate) {
    cv::Mat difference;
    cv::absdiff(reference, candidate, difference);
    const int channels = difference.channels();
    cv::Mat1b largest(difference.rows, difference.cols);
    for (int y = 0; y < difference.rows; ++y) {
        const uchar* row = difference.ptr<uchar>(y);
        for (int x = 0; x < difference.cols; ++x, row += channels) {
            largest(y, x) = *std::max_element(row, row + channels);
        }
    }
    return largest;
}

int pixels_above(const cv::Mat1b& differences, int limit) {
    return static_cast<int>(std::count_if(differences.begin(), differences.end(),
                                          [limit](uchar difference) { return difference > limit; }));
}

std::string pixel_text(const cv::Mat& image, cv::Point at) {
    std::ostringstream text;
    const uchar* pixel = image.ptr<uchar>(at.y) + at.x * image.channels();
    for (int channel = 0; channel < image.channels(); ++channel) {
        text << (channel ? "," : "(") << int{pixel[channel]};
    }
    text << ')';
    return text.str();
}

}  // namespace

Comparison compare(const cv::Mat& reference, const cv::Mat& candidate, const Tolerance& tolerance) {
    Comparison result;
    if (!comparable(reference, candidate)) {
        result.reason = "expected " + describe(reference) + ", got " + describe(candidate);
        if (!reference.empty() && reference.depth() != CV_8U) result.reason += "; only 8 bits are compared";
        return result;
    }
    const cv::Mat1b differences = pixel_differences(reference, candidate);
    const auto worst = std::max_element(differences.begin(), differences.end());
    result.worst = worst.pos();
    result.max_difference = *worst;
    result.pixels = static_cast<int>(differences.total());
    result.failing_pixels = pixels_above(differences, tolerance.max_difference);
    result.mean_difference =
        cv::norm(reference, candidate, cv::NORM_L1) / (static_cast<double>(reference.total()) * reference.channels());
    result.passed = result.failing_pixels <= tolerance.failing_fraction * result.pixels;

    std::ostringstream text;
    if (result.max_difference == 0) {
        text << "equal";
    } else {
        text << result.failing_pixels << " of " << result.pixels << " pixels differ by more than "
             << tolerance.max_difference << " (allowed: " << tolerance.failing_fraction * 100 << " %); max "
             << result.max_difference << " at " << result.worst.x << ',' << result.worst.y << ": expected "
             << pixel_text(reference, result.worst) << ", got " << pixel_text(candidate, result.worst) << "; mean "
             << std::setprecision(3) << result.mean_difference;
    }
    result.reason = text.str();
    return result;
}

cv::Mat difference_image(const cv::Mat& reference, const cv::Mat& candidate, int gain) {
    if (!comparable(reference, candidate)) return {};
    cv::Mat difference;
    cv::absdiff(reference, candidate, difference);
    cv::Mat image(difference.rows, difference.cols, CV_8UC3);
    const int channels = difference.channels();
    for (int y = 0; y < difference.rows; ++y) {
        const uchar* from = difference.ptr<uchar>(y);
        for (int x = 0; x < difference.cols; ++x, from += channels) {
            // Alpha has no colour here: a difference only in alpha shows as grey.
            const int alpha = channels == 4 ? from[3] : 0;
            for (int channel = 0; channel < 3; ++channel) {
                const int value = std::max<int>(from[channels == 1 ? 0 : channel], alpha);
                image.at<cv::Vec3b>(y, x)[channel] = cv::saturate_cast<uchar>(gain * value);
            }
        }
    }
    return image;
}

std::string threshold_sweep(const cv::Mat& reference, const cv::Mat& candidate) {
    if (!comparable(reference, candidate)) return {};
    const cv::Mat1b differences = pixel_differences(reference, candidate);
    std::ostringstream text;
    text << "max difference  failing pixels\n";
    for (const int limit : std::array{0, 1, 2, 4, 8, 16, 32, 64, 128}) {
        const int failing = pixels_above(differences, limit);
        text << std::setw(14) << limit << std::setw(16) << failing << '\n';
        if (failing == 0) break;
    }
    return text.str();
}

}  // namespace lapfx::tests
