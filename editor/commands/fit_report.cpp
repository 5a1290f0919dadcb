#include "commands/fit_report.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "output/files.h"

namespace lapfx::commands {

namespace {

glm::ivec2 picture_size(glm::dvec2 shape) {
    shape = glm::max(shape, 1.0);
    const double scale = std::min(match::report_picture_side / std::max(shape.x, shape.y), 1.0);
    return glm::max(glm::ivec2(glm::round(scale * shape)), glm::ivec2(1));
}

/// JPEG, of at most that size.
std::string jpeg(const Image& image, glm::ivec2 size) {
    constexpr int quality = 85;
    cv::Mat bgr;
    output::to_bgr(image, bgr);
    if (bgr.cols > size.x) cv::resize(bgr, bgr, {size.x, size.y}, 0, 0, cv::INTER_AREA);
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    return {bytes.begin(), bytes.end()};
}

}  // namespace

void add_pictures(match::FitReport& report, VideoReader& reference, const match::Tuned& before,
                  const std::shared_ptr<const PreparedOrgan>& organ, const PreviewOptions& preview) {
    const glm::ivec2 size = picture_size(reference.info().size);
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

}  // namespace lapfx::commands
