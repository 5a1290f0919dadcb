// Frames of one clip, decoded ahead on a worker thread into a fixed ring of buffers (paper: "buffering
// scheme", table 1: MAX_TEXTURES / streams buffers each). The render thread asks for a frame by number and
// never decodes.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <opencv2/core.hpp>
#include <thread>
#include <vector>

#include "smoke/clip_file.h"
#include "smoke/policy.h"

namespace lapfx::smoke {

class ClipStream {
  public:
    /// Opens the clip and counts its frames. `buffers` is at least 2. Throws Error (bad_input).
    ClipStream(const std::filesystem::path& path, int buffers);
    ~ClipStream();
    ClipStream(const ClipStream&) = delete;
    ClipStream& operator=(const ClipStream&) = delete;

    const OldClipInfo& info() const { return info_; }

    /// Frame `index` (0 .. frame_count - 1), BGR, valid until the next call; null when it is late (policy
    /// latest). Moving forward by a few frames is what the ring is made for; any other jump starts decoding
    /// anew there. A frame that the file cannot give (corrupt in the middle) is the last good
    /// one that was decoded.
    const cv::Mat* frame(int index, Policy policy) noexcept;

    /// A frame that is decoded already, or null; it does not move the stream. Meant for the frame after the
    /// current one.
    const cv::Mat* peek(int index) noexcept;

    std::uint64_t misses() const { return misses_; }

  private:
    struct Slot {
        int index = -1;  ///< frame number that it holds
        cv::Mat image;
    };

    void work();
    Slot* find_slot(int index);
    int next_missing() const;
    Slot* free_slot();
    void decode(int index, cv::Mat& into) noexcept;
    bool read(int index, cv::Mat& into);
    int ahead_of_current(int index) const;

    const std::filesystem::path path_;
    const OldClipInfo info_;

    // worker only
    cv::VideoCapture capture_;
    int position_ = 0;  ///< number of the frame that the next grab gives
    cv::Mat last_good_;

    // shared, under mutex_
    std::mutex mutex_;
    std::condition_variable wanted_, ready_;
    std::vector<Slot> slots_;
    int current_ = 0;  ///< frame that the render thread shows; its slot is not reused
    bool stop_ = false;

    // render thread only
    std::uint64_t misses_ = 0;

    std::thread worker_;  ///< last: it starts when all else is ready
};

}  // namespace lapfx::smoke
