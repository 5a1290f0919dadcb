// Where a command writes its results: whole files or none.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "lapfx/organ.h"

namespace lapfx::commands {

/// Encodes a PNG and writes it beside, then renames it. Throws Error (runtime).
void write_png(const std::filesystem::path& path, const Image& image);

/// A video that appears under its name when it is finished and not before: dropped unfinished, nothing is left of it.
class VideoFile {
  public:
    /// The container follows from the extension (.mp4, .mov, .mkv, .avi). Throws Error (runtime).
    VideoFile(const std::filesystem::path& path, double fps, cv::Size size);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    void add(const Image& image);
    /// Closes the file and gives it its name. Throws Error (runtime).
    void finish();

  private:
    std::filesystem::path path_, beside_;
    cv::VideoWriter writer_;
    cv::Mat frame_;
    int frames_ = 0;
    bool finished_ = false;
};

bool is_video_name(const std::filesystem::path& path);

}  // namespace lapfx::commands
