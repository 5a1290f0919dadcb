// Images, through OpenCV, and videos, through the core's decoder.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include "commands/inspect.h"
#include "commands/progress.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

/// Silences OpenCV on stderr, because the fault says it.
void silence_opencv() {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
}

/// Every frame is decoded, because the claims of a file may be wrong.
DecodableFrames decodable_frames(const std::filesystem::path& file) {
    constexpr int steps = 100;
    Progress progress("decoding " + file.filename().string(), steps);
    int done = 0;
    return count_decodable_frames(file, [&](double share) {
        for (; done < static_cast<int>(share * steps); ++done) progress.step();
        return true;
    });
}

/// A time, s, rounded down to milliseconds: rounded up, "out" of a clip would play the frame that begins then.
double rounded_down(double time) {
    constexpr double inexact = 5e-4;  // ms, so that 0.5 s does not become 0.499; much less than the earliness of frames
    return std::floor(1000.0 * time + inexact) / 1000.0;
}

}  // namespace

void inspect_image(const std::filesystem::path& file) {
    silence_opencv();
    cv::Mat pixels;
    try {
        pixels = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
        refuse(file, "is an image that cannot be decoded");
    }
    if (pixels.empty()) refuse(file, "is not an image that can be decoded");
    constexpr const char* kinds[] = {"", "grey", "grey and alpha", "colour", "colour and alpha"};
    std::cout << file.string() << ": image\n"
              << "  size                " << pixels.cols << "x" << pixels.rows << '\n'
              << "  channels            " << kinds[std::min(pixels.channels(), 4)] << ", " << 8 * pixels.elemSize1()
              << " bit\n";
}

void inspect_video(const std::filesystem::path& file) {
    const ClipReport report = report_clip(file);
    const DecodableFrames decodable = decodable_frames(file);
    const auto number = [](const char* format, double value) {
        char text[64];
        std::snprintf(text, sizeof text, format, value);
        return std::string(text);
    };
    std::cout << file.string() << ": video\n"
              << "  size                " << report.size.x << "x" << report.size.y << '\n'
              << "  frames per second   " << number("%.6g", report.frames_per_second)
              << (report.variable_frame_rate ? ", the average of a variable rate\n" : "\n")  //
              << "  frames              " << report.frames
              << (decodable.count == report.frames
                      ? ""
                      : ", of which " + std::to_string(decodable.count) + " can be decoded; the one before is shown")
              << (decodable.end < report.duration ? ", none after " + number("%.3f s", rounded_down(decodable.end)) +
                                                        " (a clip's \"out\" there leaves them out)\n"
                                                  : "\n")
              << "  duration            " << number("%.3f s", report.duration) << '\n'
              << "  codec               " << report.codec << '\n'
              << "  pixel format        " << report.pixel_format << (report.alpha ? ", with opacity\n" : "\n");
    if (!report.warning.empty()) std::cout << "  warning             " << report.warning << '\n';
}

}  // namespace lapfx::commands
