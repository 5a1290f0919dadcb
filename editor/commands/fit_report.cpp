#include "commands/fit_report.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "output/files.h"

namespace lapfx::commands {

namespace {

constexpr int quality = 85, small_side = 160;  // of JPEG; px

/// `side`: px, of the longer one, at most.
glm::ivec2 picture_size(glm::dvec2 shape, int side) {
    shape = glm::max(shape, 1.0);
    const double scale = std::min(side / std::max(shape.x, shape.y), 1.0);
    return glm::max(glm::ivec2(glm::round(scale * shape)), glm::ivec2(1));
}

/// Of at most that size.
std::string jpeg(cv::Mat bgr, glm::ivec2 size) {
    if (bgr.cols > size.x) cv::resize(bgr, bgr, {size.x, size.y}, 0, 0, cv::INTER_AREA);
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    return {bytes.begin(), bytes.end()};
}

std::string jpeg(const Image& image, glm::ivec2 size) {
    cv::Mat bgr;
    output::to_bgr(image, bgr);
    return jpeg(bgr, size);
}

}  // namespace

void add_pictures(match::FitReport& report, VideoReader& reference, const match::Tuned& before,
                  const std::shared_ptr<const PreparedOrgan>& organ, const PreviewOptions& preview) {
    const glm::ivec2 size = picture_size(reference.info().size, match::report_picture_side);
    report.moments = match::report_moments(report.target);
    Image frame;
    for (match::ReportMoment& moment : report.moments)
        if (reference.read(reference.frame_at(moment.time + report.offset), frame))
            moment.reference = jpeg(frame, size);
    const auto draw = [&](const match::Tuned& tuned, std::string match::ReportMoment::*picture) {
        Preview shown(tuned.scene, tuned.preset, organ, preview);
        for (match::ReportMoment& moment : report.moments) moment.*picture = jpeg(shown.image(moment.time, size), size);
    };
    draw(before, &match::ReportMoment::before);
    draw(report.result.tuned, &match::ReportMoment::after);
}

std::string small_jpeg(const Image& image) {
    return jpeg(image, picture_size({image.width, image.height}, small_side));
}

std::string small_jpeg(const std::string& bytes) {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    const cv::Mat bgr = cv::imdecode(raw, cv::IMREAD_COLOR);
    return bgr.empty() ? std::string{} : jpeg(bgr, picture_size({bgr.cols, bgr.rows}, small_side));
}

}  // namespace lapfx::commands
