// Images and videos, through OpenCV.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "commands/inspect.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

/// What FFmpeg may do with a file that only claims to be a video: read that file, as one of the formats in
/// which videos are kept. No network, no playlist that leads to other files, no word on stderr: the fault
/// says it.
void confine_decoders() {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 1);
    setenv("OPENCV_FFMPEG_CAPTURE_OPTIONS",
           "protocol_whitelist;file|format_whitelist;mov,mp4,m4a,3gp,3g2,mj2,matroska,webm,avi,mpeg,mpegts,"
           "ogg,asf,flv,"
           "yuv4mpegpipe,m4v,h264,hevc,gif",
           1);
}

std::string fourcc_text(double value) {
    const auto code = static_cast<unsigned>(value);
    std::string text;
    for (int i = 0; i < 4; ++i) {
        const char c = static_cast<char>(code >> (8 * i) & 0xff);
        if (c > ' ' && c < 0x7f) text += c;
    }
    return text.empty() ? "unknown" : text;
}

/// Matroska and WebM name their codec by a word instead of four letters, and OpenCV does not pass it on.
std::string matroska_codec(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string head(1 << 16, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!head.starts_with("\x1a\x45\xdf\xa3")) return {};
    constexpr const char* known[][2] = {{"V_VP9", "VP90"},
                                        {"V_VP8", "VP80"},
                                        {"V_AV1", "av01"},
                                        {"V_MPEG4/ISO/AVC", "avc1"},
                                        {"V_MPEGH/ISO/HEVC", "hvc1"}};
    for (const auto& [word, code] : known)
        if (head.find(word) != std::string::npos) return code;
    return {};
}

}  // namespace

void inspect_image(const std::filesystem::path& file) {
    confine_decoders();
    cv::Mat pixels;
    try {
        pixels = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
        refuse(file, "is an image that cannot be decoded");
    }
    if (pixels.empty()) refuse(file, "is no image that can be decoded");
    constexpr const char* kinds[] = {"", "grey", "grey and alpha", "colour", "colour and alpha"};
    std::cout << file.string() << ": image\n"
              << "  size                " << pixels.cols << "x" << pixels.rows << '\n'
              << "  channels            " << kinds[std::min(pixels.channels(), 4)] << ", " << 8 * pixels.elemSize1()
              << " bit\n";
}

void inspect_video(const std::filesystem::path& file) {
    confine_decoders();
    cv::VideoCapture video;
    cv::Mat frame;
    bool decoded = false;
    try {
        // Absolute, so that no name can be taken for "concat:..." or an URL.
        video.open(std::filesystem::absolute(file).string(), cv::CAP_FFMPEG);
        if (!video.isOpened()) refuse(file, "is no video that can be opened");
        decoded = video.read(frame) && !frame.empty();
    } catch (const cv::Exception&) {
        refuse(file, "is a video that cannot be decoded");
    }
    if (!decoded) refuse(file, "is a video without a frame that can be decoded");

    const double rate = video.get(cv::CAP_PROP_FPS), frames = video.get(cv::CAP_PROP_FRAME_COUNT);
    const bool rate_known = std::isfinite(rate) && rate > 0.0, count_known = std::isfinite(frames) && frames >= 1.0;
    char text[160];
    std::cout << file.string() << ": video\n"
              << "  size                " << frame.cols << "x" << frame.rows << '\n';
    std::snprintf(text, sizeof text, rate_known ? "  frames per second   %.6g\n" : "  frames per second   unknown\n",
                  rate);
    std::cout << text;
    std::snprintf(text, sizeof text, count_known ? "  frames              %.0f\n" : "  frames              unknown\n",
                  frames);
    std::cout << text;
    if (rate_known && count_known) {
        std::snprintf(text, sizeof text, "  duration            %.3f s\n", frames / rate);
        std::cout << text;
    }
    const std::string codec = matroska_codec(file);
    std::cout << "  codec               " << (codec.empty() ? fourcc_text(video.get(cv::CAP_PROP_FOURCC)) : codec)
              << '\n';
}

}  // namespace lapfx::commands
