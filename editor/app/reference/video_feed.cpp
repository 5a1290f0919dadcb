#include "app/reference/video_feed.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds between_looks{1};
constexpr std::size_t most_spare = 3;  // images: one is shown, one has come and one is being read

}  // namespace

struct VideoFeed::Spare {
    std::mutex mutex;
    std::vector<std::unique_ptr<Image>> images;
};

VideoFeed::VideoFeed(bool exact) : exact_(exact), spare_(std::make_shared<Spare>()) {
    spare_->images.reserve(most_spare);
    if (!exact_) thread_ = std::thread([this] { run(); });
}

VideoFeed::~VideoFeed() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
        give_up_ = true;
    }
    wished_.notify_one();
    thread_.join();
}

void VideoFeed::set_wake(std::function<void()> wake) {
    const std::lock_guard lock(mutex_);
    wake_ = std::move(wake);
}

void VideoFeed::open(const fs::path& file, std::shared_ptr<VideoReader> reader) {
    shown_ = {.opening = wished_last_.opening + 1, .settled = file.empty(), .video = nullptr, .faults = {}};
    image_ = std::make_shared<const Image>();
    wished_last_ = {.opening = shown_.opening, .file = file, .frame = -1, .reader = nullptr};
    Wish wish = wished_last_;
    wish.reader = std::move(reader);
    if (exact_) {
        serve(std::move(wish));
        take();
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        wish_ = std::move(wish);
        give_up_ = true;
    }
    wished_.notify_one();
}

void VideoFeed::want(int frame) {
    if (exact_) {
        wished_last_.frame = frame;
        serve(wished_last_);
        look_after_file();
        take();
        return;
    }
    if (frame == std::exchange(wished_last_.frame, frame)) return;
    {
        const std::lock_guard lock(mutex_);
        wish_.frame = frame;
    }
    wished_.notify_one();
}

bool VideoFeed::take() {
    const std::lock_guard lock(mutex_);
    if (!std::exchange(fresh_, false)) return false;
    if (ready_.opening != wished_last_.opening) return false;  // of the file before
    shown_ = ready_;
    if (std::exchange(fresh_image_, false)) image_ = std::move(ready_image_);
    return true;
}

void VideoFeed::run() {
    Wish served;
    std::unique_lock lock(mutex_);
    while (true) {
        wished_.wait_for(lock, between_looks,
                         [&] { return stopping_ || wish_.opening != served.opening || wish_.frame != served.frame; });
        if (stopping_) return;
        const bool idle = wish_.opening == served.opening && wish_.frame == served.frame;
        Wish wish = wish_;
        wish_.reader.reset();  // it is used once
        served = wish_;
        give_up_ = false;
        lock.unlock();
        serve(std::move(wish));
        if (idle) look_after_file();
        lock.lock();
    }
}

void VideoFeed::serve(Wish wish) {
    if (wish.opening != made_.opening) open_now(wish);
    if (reader_ != nullptr && wish.frame >= 0 && wish.frame < reader_->info().frames && wish.frame != made_.frame)
        read_frame(wish.frame);
}

void VideoFeed::open_now(Wish& wish) {
    made_ = {.opening = wish.opening, .settled = true, .video = nullptr, .faults = {}};
    file_ = wish.file;
    reader_.reset();
    made_image_.reset();
    opened_ = seen_ = stamp_of(file_);
    if (!file_.empty()) try {
            reader_ = wish.reader ? std::move(wish.reader) : std::make_shared<VideoReader>(file_, &give_up_);
            made_.video = reader_;
        } catch (const Error& error) {
            made_.faults = error.faults();
        } catch (const std::bad_alloc&) {
            made_.faults = {{.file = file_.string(), .place = "", .reason = "needs more memory than is available"}};
        }
    publish(false);
}

/// Empty, with the memory of one that nobody holds any more: while a video plays nothing is allocated, or given back by
/// the thread of the window.
std::shared_ptr<Image> VideoFeed::spare_image() const {
    std::unique_ptr<Image> image;
    {
        const std::lock_guard lock(spare_->mutex);
        if (!spare_->images.empty()) {
            image = std::move(spare_->images.back());
            spare_->images.pop_back();
        }
    }
    if (!image) image = std::make_unique<Image>();
    image->pixels.clear();
    return {image.release(), [spare = spare_](Image* done) {
                std::unique_ptr<Image> back(done);
                const std::lock_guard lock(spare->mutex);
                if (spare->images.size() < most_spare) spare->images.push_back(std::move(back));
            }};
}

void VideoFeed::read_frame(int frame) {
    std::shared_ptr<Image> image = spare_image();
    made_.good = reader_->read(frame, *image, &give_up_);
    if (!made_.good && give_up_) return;
    if (!image->pixels.empty()) made_image_ = std::move(image);  // without memory the last one stays
    if (!made_image_) return;
    made_.frame = frame;
    ++decoded_;
    publish(true);
}

/// Numbered images: their folder's.
std::optional<VideoFeed::Stamp> VideoFeed::stamp_of(const fs::path& file) {
    std::error_code error;
    Stamp stamp;
    if (fs::is_regular_file(file, error)) {
        stamp.size = fs::file_size(file, error);
        if (!error) stamp.written = fs::last_write_time(file, error);
    } else if (file.filename().string().find('%') != std::string::npos) {
        stamp.written = fs::last_write_time(file.parent_path().empty() ? "." : file.parent_path(), error);
    } else {
        return std::nullopt;
    }
    return error ? std::nullopt : std::optional(stamp);
}

/// The one that is open stays as it is until there is another that can be opened.
void VideoFeed::look_after_file() {
    if (file_.empty()) return;
    const std::optional<Stamp> before = std::exchange(seen_, stamp_of(file_));
    if (seen_ == opened_) {
        if (made_.video == nullptr || made_.faults.empty()) return;
        made_.faults.clear();  // it is back
        return publish(false);
    }
    if (!seen_) {
        if (made_.video == nullptr || !made_.faults.empty()) return;
        made_.faults = {{.file = file_.string(), .place = "", .reason = "no longer exists; its last frame stays"}};
        return publish(false);
    }
    if (seen_ != before && !exact_) return;  // still being written
    opened_ = seen_;
    try {
        reader_ = std::make_shared<VideoReader>(file_, &give_up_);
        const int frame = std::min(made_.frame, reader_->info().frames - 1);
        made_.video = reader_;
        made_.faults.clear();
        if (frame >= 0) return read_frame(frame);
    } catch (const Error& error) {
        made_.faults = error.faults();
    } catch (const std::bad_alloc&) {
        made_.faults = {{.file = file_.string(), .place = "", .reason = "needs more memory than is available"}};
    }
    publish(false);
}

void VideoFeed::publish(bool with_image) {
    std::function<void()> wake;
    {
        const std::lock_guard lock(mutex_);
        ready_ = made_;
        if (with_image) ready_image_ = made_image_;
        fresh_image_ = with_image || (fresh_image_ && made_.frame >= 0);  // never an image of the former file
        fresh_ = true;
        wake = wake_;
    }
    if (wake) wake();
}

}  // namespace lapfx::app
