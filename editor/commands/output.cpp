#include "commands/output.h"

#include <unistd.h>

#include <array>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "lapfx/error.h"
#include "lapfx/file.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

Error cannot_write(const fs::path& path, const std::string& reason) {
    return {Failure::runtime, Fault{.file = path.string(), .place = "", .reason = reason}};
}

/// A view of an RGBA image as OpenCV's BGR.
void to_bgr(const Image& image, cv::Mat& bgr) {
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
}

}  // namespace

void write_png(const fs::path& path, const Image& image) {
    cv::Mat bgr;
    to_bgr(image, bgr);
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".png", bgr, bytes)) throw cannot_write(path, "the picture cannot be encoded as PNG");
    write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool is_video_name(const fs::path& path) {
    constexpr std::array<const char*, 4> extensions{".mp4", ".mov", ".mkv", ".avi"};
    return std::find(extensions.begin(), extensions.end(), path.extension().string()) != extensions.end();
}

VideoFile::VideoFile(const fs::path& path, double fps, cv::Size size) : path_(fs::absolute(path)) {
    std::error_code error;
    const auto status = fs::symlink_status(path_, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) throw cannot_write(path, "is not a plain file");
    if (::access(path_.parent_path().c_str(), W_OK) != 0)
        throw cannot_write(path, "its folder is missing or cannot be written to");
    // The extension stays last: the container is chosen by it.
    beside_ = path_.parent_path() /
              (".lapfx-" + std::to_string(::getpid()) + "-" + path_.stem().string() + path_.extension().string());
    // H.264 where FFmpeg can encode it, else MPEG-4 part 2, which it always can.
    for (const int codec : {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')})
        if (writer_.open(beside_.string(), cv::CAP_FFMPEG, codec, fps, size)) return;
    fs::remove(beside_, error);
    throw cannot_write(path, "no video of " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                                 " pixels can be encoded here (the sides must be even)");
}

VideoFile::~VideoFile() {
    if (finished_) return;
    writer_.release();
    std::error_code error;
    fs::remove(beside_, error);
}

void VideoFile::add(const Image& image) {
    to_bgr(image, frame_);
    writer_.write(frame_);
    ++frames_;
}

void VideoFile::finish() {
    writer_.release();
    std::error_code error;
    // A full disk shows only here, for OpenCV's writer does not tell: every frame must come back.
    cv::VideoCapture written(beside_.string(), cv::CAP_FFMPEG);
    int readable = 0;
    while (written.isOpened() && written.grab()) ++readable;
    if (readable != frames_)
        throw cannot_write(path_, "the video could not be written whole: " + std::to_string(readable) + " of " +
                                      std::to_string(frames_) + " frames; is the disk full?");
    fs::rename(beside_, path_, error);
    if (error) throw cannot_write(path_, "cannot be written: " + error.message());
    finished_ = true;
}

}  // namespace lapfx::commands
