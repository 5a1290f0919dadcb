#include "smoke/clip_stream.h"

#include <algorithm>
#include <cassert>

namespace lapfx::smoke {

ClipStream::ClipStream(const std::filesystem::path& path, int buffers)
    : path_(path), info_(read_clip_info(path)), capture_(open_clip(path)) {
    last_good_ = cv::Mat::zeros(info_.size, CV_8UC3);
    slots_.resize(static_cast<std::size_t>(std::clamp(buffers, 2, std::max(2, info_.frame_count))));
    worker_ = std::thread([this] { work(); });
}

ClipStream::~ClipStream() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wanted_.notify_one();
    worker_.join();
}

const cv::Mat* ClipStream::frame(int index, Policy policy) noexcept {
    assert(index >= 0 && index < info_.frame_count);
    std::unique_lock lock(mutex_);
    if (current_ != index) {
        current_ = index;
        wanted_.notify_one();
    }
    Slot* slot = find_slot(index);
    if (slot == nullptr && policy == Policy::wait)
        ready_.wait(lock, [&] { return (slot = find_slot(index)) != nullptr; });
    if (slot == nullptr) {
        ++misses_;
        return nullptr;
    }
    return &slot->image;  // pinned: the worker never reuses the current frame's slot
}

const cv::Mat* ClipStream::peek(int index) noexcept {
    const std::lock_guard lock(mutex_);
    const Slot* slot = find_slot(index);
    return slot == nullptr ? nullptr : &slot->image;
}

void ClipStream::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        Slot* slot = nullptr;
        int index = -1;
        wanted_.wait(lock, [&] {
            if (stop_) return true;
            index = next_missing();
            slot = index < 0 ? nullptr : free_slot();
            return slot != nullptr;
        });
        if (stop_) return;
        slot->index = -1;  // nobody can find it while it is written without the lock
        lock.unlock();
        decode(index, slot->image);
        lock.lock();
        slot->index = index;
        ready_.notify_one();
    }
}

ClipStream::Slot* ClipStream::find_slot(int index) {
    const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.index == index; });
    return found == slots_.end() ? nullptr : &*found;
}

/// Frames from the current one on, round the loop.
int ClipStream::ahead_of_current(int index) const {
    return (index - current_ + info_.frame_count) % info_.frame_count;
}

/// The nearest frame at or after the current one that no slot holds, or -1 when the ring is full of what
/// comes next.
int ClipStream::next_missing() const {
    const int span = std::min(static_cast<int>(slots_.size()), info_.frame_count);
    for (int ahead = 0; ahead < span; ++ahead) {
        const int index = (current_ + ahead) % info_.frame_count;
        if (std::none_of(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.index == index; })) return index;
    }
    return -1;
}

/// A slot whose frame is not among the next ones to be shown.
ClipStream::Slot* ClipStream::free_slot() {
    const int span = static_cast<int>(slots_.size());
    for (Slot& slot : slots_)
        if (slot.index < 0 || ahead_of_current(slot.index) >= span) return &slot;
    return nullptr;
}

/// A file can break or vanish while it plays; the stream goes on with the last good frame.
void ClipStream::decode(int index, cv::Mat& into) noexcept {
    try {
        if (read(index, into)) {
            into.copyTo(last_good_);
            return;
        }
    } catch (const std::exception&) {  // cv::Exception, or Error when the file cannot be opened again
    }
    try {
        last_good_.copyTo(into);
    } catch (const std::exception&) {  // no memory for it: the slot keeps what it had
    }
}

bool ClipStream::read(int index, cv::Mat& into) {
    if (index < position_) {
        // Seeking by number is not exact in every container; the start always is.
        capture_ = open_clip(path_);
        position_ = 0;
    }
    for (; position_ < index; ++position_)
        if (!capture_.grab()) return false;
    ++position_;
    return capture_.read(into) && into.size() == info_.size && into.type() == CV_8UC3;
}

}  // namespace lapfx::smoke
