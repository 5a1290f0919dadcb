#include "commands/fit_report.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "commands/file_kind.h"
#include "commands/options.h"
#include "lapfx/authoring/file.h"
#include "output/files.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

/// Also of a file that does not exist yet; empty where it cannot be told.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(path, error), error);
}

bool will_be_same_file(const fs::path& a, const fs::path& b) {
    return is_same_file(a, b) || (!real_path(a).empty() && real_path(a) == real_path(b));
}

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

std::vector<fs::path> files_of(const Scene& scene, std::vector<fs::path> more) {
    for (const std::string& file : {scene.organ.file, scene.organ.texture, scene.tool.file, scene.preset})
        if (!file.empty()) more.push_back(named_path(scene.folder, file, Reach::anywhere));
    std::erase_if(more, [](const fs::path& file) { return file.empty(); });
    return more;
}

void check_report(const fs::path& report, std::span<const fs::path> taken) {
    if (report.extension() != ".html")
        throw wrong_option("--report", "\"" + report.string() + "\" does not end in .html");
    for (const fs::path& file : taken)
        if (will_be_same_file(report, file))
            throw wrong_option("--report", "\"" + report.string() + "\" is another file of this fit, " + file.string());
    output::require_replaceable(report);
}

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
