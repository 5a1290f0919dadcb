// Files of pictures: whole files or none. What is written is looked at again before it gets its name.
//
//     output::write_png("still.png", image);
//     output::VideoFile video("clip.mp4", 25, {1280, 1024});
//     for (const Image& image : images) video.add(image);
//     video.finish();
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "lapfx/organ.h"

namespace lapfx::output {

/// Encodes a PNG and writes it beside, then renames it. Throws Error (runtime).
void write_png(const std::filesystem::path& path, const Image& image);

/// A video that appears under its name when it is finished and not before: dropped unfinished, nothing is left of it.
class VideoFile {
  public:
    /// The container follows from the extension (is_video_name). Throws Error (runtime).
    VideoFile(const std::filesystem::path& path, double fps, cv::Size size);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    void add(const Image& image);
    /// After the last frame: reads one back. False: all have been, and they are as many and as large as those that were
    /// added. Throws Error (runtime).
    bool check();
    /// Gives the file its name, once it has been checked. Throws Error (runtime).
    void publish();
    /// Checks all that has not been, and publishes. Throws Error (runtime).
    void finish();

  private:
    std::filesystem::path path_;
    std::unique_ptr<Beside> beside_;
    cv::Size size_;
    cv::VideoWriter writer_;
    cv::VideoCapture written_;
    cv::Mat frame_;
    int frames_ = 0, readable_ = 0;
    bool closed_ = false, checked_ = false;
};

/// Whether an export may be of this name: the formats of videos that are written (lapfx/authoring/formats.h).
bool is_video_name(const std::filesystem::path& path);

/// The colours, as OpenCV has them; alpha is left out.
void to_bgr(const Image& image, cv::Mat& bgr);

/// For a file that cannot be written (runtime).
Error cannot_write(const std::filesystem::path& path, const std::string& reason);
/// Whether a file of this name may be written: there is none, or a plain one that is not write-protected, and its
/// folder is there. Throws Error (runtime).
void require_replaceable(const std::filesystem::path& path);
/// Gives `beside` the name `path` and, if a file of that name goes for it, its permissions. Throws Error (runtime).
void give_name(const std::filesystem::path& beside, const std::filesystem::path& path);

}  // namespace lapfx::output
