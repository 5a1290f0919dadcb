// Writes files of pictures, always complete ones: a file is read back before it gets its name.
//
//     output::write_png("still.png", image);
//     output::VideoFile video("clip.mp4", 25, {1280, 1024});
//     for (const Image& image : images) video.add(image);
//     video.finish();
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "output/codecs.h"

namespace cv {
class Mat;
class VideoCapture;
}  // namespace cv

namespace lapfx::output {

class VideoEncoder;

/// Encodes a PNG, writes it next to `path` and renames it. Throws Error (runtime).
void write_png(const std::filesystem::path& path, const Image& image);

/// A video that appears under its name only when it is finished. If the object is destroyed before, nothing of it is
/// left.
class VideoFile {
  public:
    /// The container follows from the extension (is_video_name). Throws Error (runtime), also for a codec that it does
    /// not hold.
    VideoFile(const std::filesystem::path& path, double fps, glm::ivec2 size, Codec codec = Codec::h264,
              Quality quality = Quality::good);
    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    VideoFile& operator=(const VideoFile&) = delete;

    /// The image has the size of the video (assert). Throws Error (runtime), such as for a full disk.
    void add(const Image& image);
    /// Reads one frame back; called after the last frame was added. Returns false when all have been read, and they are
    /// as many and as large as those that were added. Throws Error (runtime).
    bool check();
    /// Gives the file its name, once it has been checked. Throws Error (runtime).
    void publish();
    /// Checks the frames that check() has not read yet, and publishes. Throws Error (runtime).
    void finish();

  private:
    std::filesystem::path path_;
    std::unique_ptr<Beside> beside_;
    glm::ivec2 size_;
    std::unique_ptr<VideoEncoder> encoder_;      ///< null once the last frame was added
    std::unique_ptr<cv::VideoCapture> written_;  ///< reads it back; null while it is written
    int frames_ = 0, readable_ = 0;
    bool checked_ = false;
};

/// Whether a video can be exported under this name: its format is one that can be written (lapfx/authoring/formats.h).
bool is_video_name(const std::filesystem::path& path);

/// Converts an image to OpenCV's order of colours, without alpha.
void to_bgr(const Image& image, cv::Mat& bgr);

/// The error (runtime) for a file that cannot be written.
Error cannot_write(const std::filesystem::path& path, const std::string& reason);
/// Throws Error (runtime) unless a file of this name may be written: its folder exists, and there is either no such
/// file or a plain one that is not write-protected.
void require_replaceable(const std::filesystem::path& path);
/// Renames `beside` to `path`. If it replaces a file, it takes over that file's permissions. Throws Error (runtime).
void give_name(const std::filesystem::path& beside, const std::filesystem::path& path);

}  // namespace lapfx::output
