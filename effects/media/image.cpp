#include "media/image.h"

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace lapfx::media {

namespace {

/// 8-bit RGBA out of whatever the codec gave: 8 or 16 bit, grey, BGR or BGRA.
bool to_rgba(cv::Mat pixels, cv::Mat rgba) {
    if (pixels.depth() == CV_16U) pixels.convertTo(pixels, CV_8U, 1.0 / 257.0);
    if (pixels.depth() != CV_8U) return false;
    switch (pixels.channels()) {
        case 1:
            cv::cvtColor(pixels, rgba, cv::COLOR_GRAY2RGBA);
            return true;
        case 3:
            cv::cvtColor(pixels, rgba, cv::COLOR_BGR2RGBA);
            return true;
        case 4:
            cv::cvtColor(pixels, rgba, cv::COLOR_BGRA2RGBA);
            return true;
        default:
            return false;
    }
}

std::string size_fault(const ImageSize& size) {
    const std::string text = std::to_string(size.width) + "x" + std::to_string(size.height);
    if (size.width < 1 || size.height < 1) return "its header says " + text + " pixels";
    const bool large = size.width > maximum_image_side || size.height > maximum_image_side ||
                       size.width * size.height > maximum_image_pixels;
    return large ? text + " pixels are more than the limit of 16384 a side" : "";
}

}  // namespace

std::string decode_image(std::span<const std::uint8_t> file, Image& image) {
    ImageSize size;
    if (!image_size(file, size)) return "not a PNG, JPEG, WebP or BMP image";
    if (std::string fault = size_fault(size); !fault.empty()) return fault;
    if (file.size() > (std::size_t{1} << 30)) return "is larger than 1 GiB";
    // The caller warns about a broken image, so OpenCV need not log it.
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    try {
        // The codecs only read, although imdecode takes a non-const array.
        const cv::Mat encoded(1, static_cast<int>(file.size()), CV_8U, const_cast<std::uint8_t*>(file.data()));
        const cv::Mat pixels = cv::imdecode(encoded, cv::IMREAD_UNCHANGED);
        if (pixels.empty()) return "cannot be decoded";
        // Converts directly into place: copying a large texture takes longer than converting it.
        image.pixels.resize(pixels.total() * 4);
        if (!to_rgba(pixels, cv::Mat(pixels.size(), CV_8UC4, image.pixels.data()))) {
            image.pixels.clear();
            return "has a pixel format that is not read";
        }
        image.width = pixels.cols;
        image.height = pixels.rows;
    } catch (const cv::Exception&) {
        image.pixels.clear();
        return "cannot be decoded";
    }
    return {};
}

}  // namespace lapfx::media
