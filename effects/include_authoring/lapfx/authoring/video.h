// A surgery video, read frame by frame as a player shows it: upright, with square pixels, in sRGB.
//
//     lapfx::VideoReader video("operation.mp4");  // throws lapfx::Error
//     lapfx::Image image;
//     if (!video.read(video.frame_at(12.5), image)) log("a frame is missing; the one before it is shown");
//
// Any video, single image or numbered images ("frame_%04d.png"): one plain local file, or those images; never a URL or
// a file that a file names. Times in s from the first frame. One thread at a time, any thread; info(), frame_at() and
// time_of() from others meanwhile, too. Opening reads the whole file once, without decoding it: with gigabytes do that
// on another thread than the UI.
#pragma once

#include <atomic>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "lapfx/organ.h"

namespace lapfx {

struct VideoInfo {
    glm::ivec2 size{0};  ///< px as it is shown: turned as the file asks for, widened where its pixels are not square
    int frames = 0;
    double duration = 0.0;           ///< s, the last frame's time included
    double frames_per_second = 0.0;  ///< mean
    std::string codec;               ///< FFmpeg's name: "h264"
    std::string warning;             ///< what is unusual about it, although it plays; one line, or empty
};

class VideoReader {
  public:
    /// Throws Error (bad_input): no such file, not a video that can be decoded, a side over 8192 px, over ten million
    /// frames. `stop`, if given, ends that early: Error (runtime).
    explicit VideoReader(const std::filesystem::path& path, const std::atomic<bool>* stop = nullptr);
    VideoReader(VideoReader&&) noexcept;
    VideoReader& operator=(VideoReader&&) noexcept;
    ~VideoReader();

    const VideoInfo& info() const;
    /// The frame that is shown at `time`; before the first one that, after the last one that.
    int frame_at(double time) const;
    double time_of(int frame) const;  ///< s; `frame` in 0 .. frames - 1 (assert)

    /// Frame 0 .. frames - 1 (assert), opaque. The next in order costs one decode; a jump those from the key frame
    /// before it. A frame that the file cannot give is the last good one before it, or black, and then the answer is
    /// false. `stop`, if given, ends a long way to a frame early: false, and `into` is as it was.
    bool read(int frame, Image& into, const std::atomic<bool>* stop = nullptr) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
