// Encodes pictures into a video file, with FFmpeg's libraries. VideoFile (output/files.h) gives it its name.
//
//     VideoEncoder encoder("clip.tmp.mp4", {.fps = 25, .size = {1280, 1024}});
//     for (const Image& image : images) encoder.add(image);
//     encoder.finish();
//
// Frame n is shown from n / fps on, exactly; a .mkv has its times in ms. The colours are those of BT.709 and say so, in
// the stream and in the container: a player that has to guess takes a matrix by the number of rows. Nothing is printed.
// One thread at a time, any thread.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "output/codecs.h"

namespace lapfx::output {

struct VideoFormat {
    double fps = 25;     ///< frames per second, 0.001 to 10000; told as a fraction of whole numbers up to 65535
    glm::ivec2 size{0};  ///< px; even, except for a lossless codec
    Codec codec = Codec::h264;
    Quality quality = Quality::good;                  ///< of a codec that is lossless: unused
    std::span<const std::string_view> encoders = {};  ///< instead of those of the codec's row
};

class VideoEncoder {
  public:
    /// Writes `file` anew; the container follows from its extension. Errors name `shown` instead, if it is given.
    /// Throws Error (runtime): the codec is not there or cannot do this, or the file cannot be written.
    VideoEncoder(const std::filesystem::path& file, const VideoFormat& format, std::filesystem::path shown = {});
    /// Closes the file. Without finish() it is not complete.
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// Of the size that was told (assert); alpha is ignored. Throws Error (runtime), such as for a full disk; then the
    /// file is lost.
    void add(const Image& image);
    /// Writes the last frames and closes the file; called once. Throws Error (runtime).
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx::output
