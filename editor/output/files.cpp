#include "output/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

/// Writes something to the disk, which throws with the reason if it is full: OpenCV's writer does not report why it
/// failed.
void require_room(const fs::path& path) {
    const Beside folder(path, Beside::Kind::folder);
    try {
        write_file(folder.path() / path.filename(), std::string(std::size_t{64} << 10U, '\0'));
    } catch (const Error& error) {
        throw cannot_write(path, error.faults().front().reason);
    }
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

VideoFile::VideoFile(const fs::path& path, double fps, cv::Size size) : path_(fs::absolute(path)), size_(size) {
    require_replaceable(path_);
    const std::string what = "a video of " + std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels";
    // OpenCV would leave the last column or row away.
    if (size.width % 2 != 0 || size.height % 2 != 0)
        throw cannot_write(path, what + " cannot be encoded here (the sides must be even)");
    // The extension stays last: the container is chosen by it.
    beside_ = std::make_unique<Beside>(path_, Beside::Kind::file, path_.extension().string());
    // H.264 where FFmpeg can encode it, else MPEG-4 part 2, which it always can.
    for (const int codec : {cv::VideoWriter::fourcc('a', 'v', 'c', '1'), cv::VideoWriter::fourcc('m', 'p', '4', 'v')})
        if (writer_.open(beside_->path().string(), cv::CAP_FFMPEG, codec, fps, size)) return;
    require_room(path);
    char rate[32];
    std::snprintf(rate, sizeof rate, "%.6g", fps);
    throw cannot_write(path, what + " and " + rate + " frames a second cannot be encoded here");
}

/// The file is closed before `beside_` removes it.
VideoFile::~VideoFile() {
    writer_.release();
    written_.release();
}

void VideoFile::add(const Image& image) {
    to_bgr(image, frame_);
    writer_.write(frame_);
    ++frames_;
}

/// A full disk is found only here, because OpenCV's writer does not report it: every frame has to be read back.
bool VideoFile::check() {
    if (checked_) return false;
    if (!closed_) {
        closed_ = true;
        writer_.release();
        written_.open(beside_->path().string(), cv::CAP_FFMPEG);
    }
    if (written_.isOpened() && written_.grab()) {
        ++readable_;
        return true;
    }
    const cv::Size size(static_cast<int>(written_.get(cv::CAP_PROP_FRAME_WIDTH)),
                        static_cast<int>(written_.get(cv::CAP_PROP_FRAME_HEIGHT)));
    if (readable_ != frames_)
        throw cannot_write(path_, "the video could not be written completely: " + std::to_string(readable_) + " of " +
                                      std::to_string(frames_) + " frames; is the disk full?");
    if (frames_ > 0 && size != size_)
        throw cannot_write(path_, "the video has " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                                      " pixels, not " + std::to_string(size_.width) + "x" +
                                      std::to_string(size_.height));
    written_.release();
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
