// Frames of one video, decoded on a thread of its own: the newest request counts, and nobody waits for it.
//
//     VideoFeed feed({.wake = [&] { ui.wake("video"); }});
//     feed.open("operation.mp4");
//     ...
//     each frame:  feed.take();  if (feed.video()) feed.want(feed.video()->frame_at(time));
//                  show(feed.image());
//
// A frame is decoded once for all who look at it: shared_image() stays what it is while the next one comes.
//
// It also looks once a second whether the file is still there and still the same: what vanished is told, what changed
// is opened again, and meanwhile the last frame stays. UI thread.
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "lapfx/authoring/video.h"
#include "lapfx/error.h"

namespace lapfx::app {

class VideoFeed {
  public:
    /// `exact`: there is no thread, open() and want() do it all at once: for tests and pictures.
    explicit VideoFeed(bool exact = false);
    ~VideoFeed();
    VideoFeed(const VideoFeed&) = delete;
    VideoFeed& operator=(const VideoFeed&) = delete;

    /// Any thread calls it, when there is something to take().
    void set_wake(std::function<void()> wake);
    /// Another video; empty: none. What was shown is gone. `reader`: of this file, opened already by somebody who needs
    /// it no more.
    void open(const std::filesystem::path& file, std::shared_ptr<VideoReader> reader = nullptr);
    void want(int frame);
    /// What has come since. Gives whether there was anything.
    bool take();

    bool opening() const { return !shown_.settled; }
    /// Null: not opened. Do not call its read(): the thread does.
    const std::shared_ptr<const VideoReader>& video() const { return shown_.video; }
    /// What is wrong: without video() nothing can be shown, else the last frame stays.
    const std::vector<Fault>& faults() const { return shown_.faults; }
    const Image& image() const { return *image_; }  ///< empty: none yet. Valid until the next take(), want() or open()
    const std::shared_ptr<const Image>& shared_image() const { return image_; }  ///< the same, for who keeps it
    std::uint64_t decoded() const { return decoded_; }                           ///< frames, since it was made
    int frame() const { return shown_.frame; }                                   ///< the one in image(); -1: none yet
    bool good() const { return shown_.good; }  ///< false: the file could not give it, this is the one before it

  private:
    /// How a file can be told from what it was.
    struct Stamp {
        std::filesystem::file_time_type written;
        std::uintmax_t size = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    struct Wish {
        std::uint64_t opening = 0;
        std::filesystem::path file;
        int frame = -1;
        std::shared_ptr<VideoReader> reader;
    };
    struct OpenedVideo {
        std::uint64_t opening = 0;
        bool settled = true;  ///< opened, or could not be
        std::shared_ptr<const VideoReader> video;
        std::vector<Fault> faults;
        int frame = -1;
        bool good = true;
    };

    /// Images that nobody holds any more; any thread.
    struct Spare;

    static std::optional<Stamp> stamp_of(const std::filesystem::path& file);
    void run();
    void serve(Wish wish);
    void open_now(Wish& wish);
    void look_after_file();
    void read_frame(int frame);
    std::shared_ptr<Image> spare_image() const;
    void publish(bool with_image);

    const bool exact_;
    std::mutex mutex_;
    std::condition_variable wished_;
    bool stopping_ = false;
    Wish wish_;
    OpenedVideo ready_;                         ///< what take() finds
    std::shared_ptr<const Image> ready_image_;  ///< with it
    bool fresh_ = false, fresh_image_ = false;
    std::function<void()> wake_;
    std::atomic<std::uint64_t> decoded_ = 0;
    std::atomic<bool> give_up_ = false;  ///< another file is wanted: the search for a frame ends

    // the thread's own
    const std::shared_ptr<Spare> spare_;
    OpenedVideo made_;
    std::shared_ptr<const Image> made_image_;
    std::filesystem::path file_;
    std::shared_ptr<VideoReader> reader_;
    std::optional<Stamp> opened_, seen_;

    // the UI's own
    OpenedVideo shown_;
    std::shared_ptr<const Image> image_ = std::make_shared<const Image>();
    Wish wished_last_;
    std::thread thread_;
};

}  // namespace lapfx::app
