// A surgery video, read frame by frame as a player shows it: upright, with square pixels and whole rows, in sRGB.
//
//     lapfx::VideoReader video("operation.mp4");  // throws lapfx::Error
//     lapfx::Image image;
//     if (!video.read(video.frame_at(12.5), image)) log("a frame is missing; the one before it is shown");
//
// Takes any video, single image or numbered images ("frame_%04d.png") as plain local files, never a URL or a file that
// another file names. HDR and wide gamuts are converted; colours that are not are a warning. Times are in s from the
// first frame. One thread at a time, any thread; other threads may call info(), frame_at() and time_of() meanwhile.
// Opening reads the whole file once, without decoding it: with gigabytes do that on another thread than the UI.
#pragma once

#include <atomic>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "lapfx/organ.h"

namespace lapfx {

struct VideoInfo {
    glm::ivec2 size{0};  ///< pixels as shown: rotated as the file asks for, widened where its pixels are not square
    int frames = 0;
    double duration = 0.0;           ///< s, including the time of the last frame
    double frames_per_second = 0.0;  ///< mean
    std::string codec;               ///< FFmpeg's name: "h264"
    std::string warning;             ///< what is unusual about a video that plays; one line, or empty
};

class VideoReader {
  public:
    /// Throws Error (bad_input): no such file, not a video that can be decoded, a side over 8192 px, over ten million
    /// frames. If given, `stop` ends that early with Error (runtime).
    explicit VideoReader(const std::filesystem::path& path, const std::atomic<bool>* stop = nullptr);
    VideoReader(VideoReader&&) noexcept;
    VideoReader& operator=(VideoReader&&) noexcept;
    ~VideoReader();

    const VideoInfo& info() const;
    /// The frame that is shown at `time`; the first or last one outside the video.
    int frame_at(double time) const;
    double time_of(int frame) const;  ///< s; `frame` in 0 .. frames - 1 (assert)

    /// Reads a frame, 0 .. frames - 1 (assert), opaque. The next frame in order costs one decode; a jump costs all
    /// frames from the key frame before it. A frame that cannot be decoded is the last good one before it, or black,
    /// and then the answer is false. If given, `stop` ends a long search early: then the answer is false and `into` is
    /// unchanged.
    bool read(int frame, Image& into, const std::atomic<bool>* stop = nullptr) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
