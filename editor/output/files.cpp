#include "output/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"
#include "output/video_encoder.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

}  // namespace

void to_bgr(const Image& image, cv::Mat& bgr) {
    const cv::Mat rgba(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::cvtColor(rgba, bgr, cv::COLOR_RGBA2BGR);
}

Error cannot_write(const fs::path& path, const std::string& reason) {
    return {Failure::runtime, Fault{.file = path.string(), .place = "", .reason = reason}};
}

void require_replaceable(const fs::path& path) {
    require_not_read(path);
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (fs::exists(status)) {
        if (!fs::is_regular_file(status)) throw cannot_write(path, "not written: it exists and is not a plain file");
        if (::access(path.c_str(), W_OK) != 0) throw cannot_write(path, "not written: it is write-protected");
    }
    if (!fs::is_directory(folder_of(path), error)) throw cannot_write(path, "its folder is missing");
    if (::access(folder_of(path).c_str(), W_OK | X_OK) != 0)
        throw cannot_write(path, std::string("its folder cannot be written to: ") + std::strerror(errno));
}

void give_name(const fs::path& beside, const fs::path& path) {
    require_replaceable(path);
    std::error_code error;
    const fs::file_status old = fs::status(path, error);
    if (fs::exists(old)) fs::permissions(beside, old.permissions(), error);
    fs::rename(beside, path, error);
    if (error) throw cannot_write(path, "cannot be written: " + error.message());
}

void write_png(const fs::path& path, const Image& image) {
    cv::Mat bgr;
    to_bgr(image, bgr);
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".png", bgr, bytes)) throw cannot_write(path, "the picture cannot be encoded as PNG");
    write_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

bool is_video_name(const fs::path& path) {
    const FileFormat* const format = format_named(path);
    return format != nullptr && format->content == Content::video && format->written;
}

VideoFile::VideoFile(const fs::path& path, double fps, glm::ivec2 size, Codec codec, Quality quality)
    : path_(fs::absolute(path)), size_(size) {
    require_replaceable(path_);
    if (const std::string fault = codec_fault(codec, path); !fault.empty()) throw cannot_write(path, fault);
    // Those with half the chroma need it; one rule for all is easier to know.
    if (size.x % 2 != 0 || size.y % 2 != 0)
        throw cannot_write(path, "a video of " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                                     " pixels cannot be encoded here (the sides must be even)");
    // The extension stays last: the container is chosen by it.
    beside_ = std::make_unique<Beside>(path_, Beside::Kind::file, path_.extension().string());
    encoder_ = std::make_unique<VideoEncoder>(
        beside_->path(), VideoFormat{.fps = fps, .size = size, .codec = codec, .quality = quality}, path);
}

/// The members close the file before `beside_` removes it.
VideoFile::~VideoFile() = default;

void VideoFile::add(const Image& image) {
    encoder_->add(image);
    ++frames_;
}

/// What the encoder did not notice is found here: every frame has to be read back.
bool VideoFile::check() {
    if (checked_) return false;
    if (encoder_) {
        encoder_->finish();
        encoder_.reset();
        written_ = std::make_unique<cv::VideoCapture>(beside_->path().string(), cv::CAP_FFMPEG);
    }
    if (written_->isOpened() && written_->grab()) {
        ++readable_;
        return true;
    }
    const glm::ivec2 size(static_cast<int>(written_->get(cv::CAP_PROP_FRAME_WIDTH)),
                          static_cast<int>(written_->get(cv::CAP_PROP_FRAME_HEIGHT)));
    if (readable_ != frames_)
        throw cannot_write(path_, "the video could not be written completely: " + std::to_string(readable_) + " of " +
                                      std::to_string(frames_) + " frames; is the disk full?");
    if (frames_ > 0 && size != size_)
        throw cannot_write(path_, "the video has " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                                      " pixels, not " + std::to_string(size_.x) + "x" + std::to_string(size_.y));
    written_.reset();
    checked_ = true;
    return false;
}

void VideoFile::publish() {
    give_name(beside_->path(), path_);
    beside_.reset();
}

void VideoFile::finish() {
    while (check()) {
    }
    publish();
}

}  // namespace lapfx::output
