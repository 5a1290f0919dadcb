#include "match/report/report_pictures.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int quality = 85, small_side = 160;  // of JPEG; px

/// `side`: px, of the longer one, at most.
glm::ivec2 size_within(glm::dvec2 shape, int side) {
    shape = glm::max(shape, 1.0);
    const double scale = std::min(side / std::max(shape.x, shape.y), 1.0);
    return glm::max(glm::ivec2(glm::round(scale * shape)), glm::ivec2(1));
}

std::string jpeg(const cv::Mat& bgr) {
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    return {bytes.begin(), bytes.end()};
}

std::string jpeg(const Image& image, glm::ivec2 size) {
    cv::Mat bgr;
    shrink(image, {size.x, size.y}, bgr);
    return jpeg(bgr);
}

}  // namespace

glm::ivec2 report_picture_size(glm::dvec2 frame, double aspect) {
    frame = glm::max(frame, 1.0);
    if (aspect > 0.0) frame.x = aspect * frame.y;
    return size_within(frame, report_picture_side);
}

bool add_pictures(FitReport& report, VideoReader& reference, double aspect, const DrawPicture& draw,
                  const Progress& progress, const std::atomic<bool>* stop) {
    const glm::ivec2 size = report_picture_size(reference.info().size, aspect);
    report.moments = report_moments(report.found.target);
    const auto count = static_cast<double>(3 * report.moments.size());
    int made = 0;
    const auto goes_on = [&] { return !progress || progress(made++ / count); };
    Image frame;
    for (ReportMoment& moment : report.moments) {
        if (!goes_on()) return false;
        if (reference.read(reference.frame_at(moment.time + report.found.fit.offset), frame, stop))
            moment.reference = jpeg(frame, size);
        if (stop != nullptr && *stop) return false;
    }
    for (const auto& [tuned, picture] : {std::pair{&std::as_const(report.found.fit.start), &ReportMoment::before},
                                         std::pair{&std::as_const(report.found.result->tuned), &ReportMoment::after}})
        for (ReportMoment& moment : report.moments) {
            if (!goes_on()) return false;
            const std::optional<Image> drawn = draw(*tuned, moment.time, size);
            if (!drawn) return false;
            moment.*picture = jpeg(*drawn, size);
        }
    return true;
}

std::string small_jpeg(const Image& image) {
    return jpeg(image, size_within({image.width, image.height}, small_side));
}

std::string small_jpeg(const std::string& bytes) {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    cv::Mat bgr = cv::imdecode(raw, cv::IMREAD_COLOR);
    if (bgr.empty()) return {};
    const glm::ivec2 size = size_within({bgr.cols, bgr.rows}, small_side);
    cv::resize(bgr, bgr, {size.x, size.y}, 0, 0, cv::INTER_AREA);
    return jpeg(bgr);
}

}  // namespace lapfx::match
