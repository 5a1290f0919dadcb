#include "smoke/clip_stream.h"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace lapfx::smoke {

ClipStream::ClipStream(DecodePool& pool, Decoder decoder, Loop loop, int buffers, const std::vector<std::uint8_t>* kept)
    : pool_(pool),
      kept_(kept),
      decoder_(std::move(decoder)),
      slots_(static_cast<std::size_t>(buffers)),
      loop_(loop),
      current_(loop.first),
      broken_(static_cast<std::size_t>(decoder_.info().frame_count())) {
    window_.reserve(slots_.size());
    find_window();
    pool_.join(*this);
}

ClipStream::~ClipStream() {
    stop_ = true;
    pool_.leave(*this);
}

/// The nearest frames at or after the current one, round the loop, that are not kept. Frames outside the loop come once.
void ClipStream::find_window() {
    window_.clear();
    int index = current_;
    for (int steps = 0; steps <= loop_.length() && window_.size() < slots_.size();
         ++steps, index = loop_.after(index)) {
        if (is_kept(index)) continue;
        if (in_window(index)) return;
        window_.push_back(index);
    }
}

bool ClipStream::in_window(int index) const {
    return std::find(window_.begin(), window_.end(), index) != window_.end();
}

bool ClipStream::is_kept(int index) const {
    return kept_ != nullptr && (*kept_)[static_cast<std::size_t>(index)] != 0;
}

ClipStream::Slot* ClipStream::find(int index) {
    const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.index == index; });
    return found == slots_.end() ? nullptr : &*found;
}

int ClipStream::urgency() {
    if (stop_) return -1;
    find_window();
    const auto missing =
        std::find_if(window_.begin(), window_.end(), [&](int index) { return find(index) == nullptr; });
    if (missing == window_.end()) return -1;
    wanted_ = *missing;
    return static_cast<int>(missing - window_.begin());
}

void ClipStream::begin() {
    // There are as many slots as frames in the window, and one of these is missing.
    const auto free = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return !in_window(s.index); });
    assert(free != slots_.end());
    into_ = &*free;
    into_->index = -1;  // nobody finds it while it is written without the lock
}

void ClipStream::run() noexcept {
    whole_ = decoder_.read(wanted_, into_->picture, &stop_);
}

void ClipStream::end() {
    into_->index = wanted_;
    work_.decode = decoder_.decode_seconds();
    work_.copy = decoder_.copy_seconds();
    ++work_.decoded;
    std::uint8_t& broken = broken_[static_cast<std::size_t>(wanted_)];
    if (whole_ || stop_ || broken != 0) return;
    broken = 1;
    ++work_.broken;
}

void ClipStream::aim(int index) noexcept {
    {
        const std::lock_guard lock(pool_.mutex());
        current_ = index;
    }
    pool_.wake();
}

const Picture* ClipStream::frame(int index, Policy policy, double& waited) noexcept {
    std::unique_lock lock(pool_.mutex());
    assert(index >= 0 && static_cast<std::size_t>(index) < broken_.size() && !is_kept(index));
    if (current_ != index) {
        current_ = index;
        find_window();
        pool_.wake();
    }
    Slot* slot = find(index);
    if (slot == nullptr && policy == Policy::wait) {
        const auto start = std::chrono::steady_clock::now();
        pool_.wake();
        while ((slot = find(index)) == nullptr) pool_.wait_for_piece(lock);
        waited += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    // The current frame is in the window: no worker writes over it until the render thread moves on.
    return slot == nullptr ? nullptr : &slot->picture;
}

const Picture* ClipStream::peek(int index) noexcept {
    const std::lock_guard lock(pool_.mutex());
    const Slot* slot = in_window(index) ? find(index) : nullptr;
    return slot == nullptr ? nullptr : &slot->picture;
}

const Picture* ClipStream::peek_any(int& index) noexcept {
    const std::lock_guard lock(pool_.mutex());
    find_window();
    for (const int next : window_)
        if (const Slot* slot = find(next)) {
            index = next;
            return &slot->picture;
        }
    return nullptr;
}

void ClipStream::set_loop(Loop loop) noexcept {
    {
        const std::lock_guard lock(pool_.mutex());
        if (loop_ == loop) return;
        loop_ = loop;
        find_window();
    }
    pool_.wake();
}

bool ClipStream::rest() noexcept {
    const std::lock_guard lock(pool_.mutex());
    find_window();
    if (!window_.empty()) return false;
    for (Slot& slot : slots_)
        if (slot.index >= 0) slot = Slot();
    return true;
}

ClipStream::Work ClipStream::work() const noexcept {
    const std::lock_guard lock(pool_.mutex());
    return work_;
}

std::size_t ClipStream::memory() const noexcept {
    const std::lock_guard lock(pool_.mutex());
    std::size_t bytes = 0;
    for (const Slot& slot : slots_)
        if (slot.index >= 0) bytes += slot.picture.bytes.capacity();
    return bytes;
}

}  // namespace lapfx::smoke
