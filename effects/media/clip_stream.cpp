#include "media/clip_stream.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <limits>

namespace lapfx::media {

namespace {

/// Most frames that a playing clip advances by in one cycle; more is a jump.
constexpr int most_played_steps = 16;

}  // namespace

ClipStream::ClipStream(DecodePool& pool, Decoder decoder, Loop loop, int buffers, const std::vector<std::uint8_t>* kept,
                       std::span<const std::span<std::uint8_t>> memory)
    : pool_(pool),
      kept_(kept),
      decoder_(std::move(decoder)),
      slots_(static_cast<std::size_t>(buffers + spare_slots)),
      buffers_(static_cast<std::size_t>(buffers)),
      loop_(loop),
      current_(loop.first),
      broken_(static_cast<std::size_t>(decoder_.info().frame_count())) {
    assert(memory.empty() || memory.size() == slots_.size());
    for (std::size_t i = 0; i < memory.size(); ++i) slots_[i].given = memory[i];
    window_.reserve(buffers_);
    find_window();
    pool_.join(*this);
}

ClipStream::~ClipStream() {
    stop_ = true;
    pool_.leave(*this);
}

bool ClipStream::is_kept(int index) const {
    return kept_ != nullptr && (*kept_)[static_cast<std::size_t>(index)] != 0;
}

/// The nearest frames at or after the current one, step by step round the loop, that are not kept. Frames outside the
/// loop occur once.
void ClipStream::find_window() {
    window_.clear();
    if (resting_) return;
    int index = current_;
    for (int steps = 0; steps <= loop_.length() && window_.size() < buffers_;
         ++steps, index = loop_.after(index, step_)) {
        if (is_kept(index)) continue;
        if (in_window(index)) return;
        window_.push_back(index);
    }
}

bool ClipStream::in_window(int index) const {
    return std::find(window_.begin(), window_.end(), index) != window_.end();
}

ClipStream::Slot* ClipStream::find(int index) {
    const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.index == index; });
    return found == slots_.end() ? nullptr : &*found;
}

/// A slot that nobody needs: the render thread does not read it, and it has neither one of the next frames nor the
/// newest one, which is shown while decoding is behind. Slots with memory are preferred.
ClipStream::Slot* ClipStream::free_slot() {
    Slot* best = nullptr;
    for (Slot& slot : slots_) {
        const bool needed = slot.index >= 0 && (in_window(slot.index) || slot.index == newest_);
        if (&slot == lent_ || needed) continue;
        if (best == nullptr || slot.bytes().size() > best->bytes().size()) best = &slot;
    }
    return best;
}

/// The first frame after the newest one that is neither kept nor decoded; -1: none.
int ClipStream::next_behind() const {
    int index = newest_;
    for (int steps = 0; steps < loop_.length(); ++steps) {
        index = loop_.after(index);
        const bool there =
            std::any_of(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.index == index; });
        if (!there && !is_kept(index)) return index;
    }
    return -1;
}

int ClipStream::urgency() {
    closing_ = resting_ && !closed_;
    if (closing_ && !stop_) return std::numeric_limits<int>::max();  // after every frame that is shown
    if (stop_ || resting_) return -1;
    find_window();
    int soon = 0;
    if (behind_ && newest_ >= 0) {
        wanted_ = next_behind();
    } else {
        const auto missing =
            std::find_if(window_.begin(), window_.end(), [&](int index) { return find(index) == nullptr; });
        wanted_ = missing == window_.end() ? -1 : *missing;
        soon = static_cast<int>(missing - window_.begin());
    }
    into_ = wanted_ < 0 ? nullptr : free_slot();
    return into_ == nullptr ? -1 : soon;
}

void ClipStream::begin() {
    closed_ = closing_;  // a decoder that is read from opens its file
    if (closing_) return;
    into_->index = -1;  // nobody finds the slot while it is written without the lock
    written_ = into_;
}

void ClipStream::run() noexcept {
    if (closing_)
        decoder_.rest();
    else if (into_->given.empty())
        whole_ = decoder_.read(wanted_, into_->picture, &stop_);
    else
        whole_ = decoder_.read(wanted_, into_->given, &stop_);
}

void ClipStream::end() {
    if (closing_) return;
    into_->index = newest_ = wanted_;
    written_ = nullptr;
    if (resting_) into_->clear();
    work_.decode = decoder_.decode_seconds();
    work_.copy = decoder_.copy_seconds();
    ++work_.decoded;
    std::uint8_t& broken = broken_[static_cast<std::size_t>(wanted_)];
    if (whole_ || stop_ || broken != 0) return;
    broken = 1;
    ++work_.broken;
}

void ClipStream::move_to(int index) {
    current_ = index;
    resting_ = false;
    find_window();
    pool_.wake();
}

void ClipStream::aim(int index, int step) noexcept {
    const std::lock_guard lock(pool_.mutex());
    lent_ = nullptr;
    behind_ = false;
    step_ = step;
    move_to(index);
}

ClipStream::LentFrame ClipStream::frame(int index, Policy policy, double& waited) noexcept {
    std::unique_lock lock(pool_.mutex());
    assert(index >= 0 && static_cast<std::size_t>(index) < broken_.size() && !is_kept(index));
    lent_ = nullptr;
    int steps = 0;
    for (int at = current_; at != index && steps <= most_played_steps; ++steps) at = loop_.after(at);
    move_to(index);
    Slot* slot = find(index);
    behind_ = slot == nullptr && policy == Policy::latest && steps <= most_played_steps;
    if (slot == nullptr && policy == Policy::wait) {
        const auto start = std::chrono::steady_clock::now();
        while ((slot = find(index)) == nullptr) pool_.wait_for_piece(lock);
        waited += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    const bool any = behind_ || policy == Policy::skip;
    if (slot == nullptr && any && newest_ >= 0) {
        slot = find(newest_);
        if (slot == nullptr) return {.bytes = {}, .index = newest_};
    }
    return lend(slot);
}

/// No worker writes over it until the next call.
ClipStream::LentFrame ClipStream::lend(const Slot* slot) {
    lent_ = slot;
    if (slot == nullptr) return {};
    return {slot->bytes(), slot->index, static_cast<int>(slot - slots_.data())};
}

ClipStream::LentFrame ClipStream::peek(int index) noexcept {
    const std::lock_guard lock(pool_.mutex());
    return lend(in_window(index) ? find(index) : nullptr);
}

ClipStream::LentFrame ClipStream::peek_any() noexcept {
    const std::lock_guard lock(pool_.mutex());
    const auto found =
        std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.index >= 0 && !is_kept(s.index); });
    return lend(found == slots_.end() ? nullptr : &*found);
}

void ClipStream::take(int slot, std::span<std::uint8_t> memory) noexcept {
    const std::lock_guard lock(pool_.mutex());
    Slot& taken = slots_[static_cast<std::size_t>(slot)];
    assert(&taken == lent_);
    lent_ = nullptr;
    taken.clear();
    taken.given = memory;
    pool_.wake();
}

int ClipStream::give(std::span<std::uint8_t> memory) noexcept {
    const std::lock_guard lock(pool_.mutex());
    const auto idle = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) {
        return slot.given.empty() && slot.index < 0 && &slot != written_ && &slot != lent_;
    });
    if (idle == slots_.end()) return -1;
    idle->clear();
    idle->given = memory;
    return static_cast<int>(idle - slots_.begin());
}

int ClipStream::give_back() noexcept {
    const std::lock_guard lock(pool_.mutex());
    const auto given = [](const Slot& slot) { return !slot.given.empty(); };
    if (static_cast<std::size_t>(std::count_if(slots_.begin(), slots_.end(), given)) <= buffers_ + spare_slots)
        return -1;
    const auto idle = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) {
        return given(slot) && slot.index < 0 && &slot != written_ && &slot != lent_;
    });
    if (idle == slots_.end()) return -1;
    idle->given = {};
    return static_cast<int>(idle - slots_.begin());
}

void ClipStream::set_loop(Loop loop) noexcept {
    const std::lock_guard lock(pool_.mutex());
    if (loop_ == loop && !resting_) return;
    loop_ = loop;
    resting_ = false;
    find_window();
    pool_.wake();
}

void ClipStream::set_buffers(int buffers) noexcept {
    const std::lock_guard lock(pool_.mutex());
    buffers_ = std::clamp(static_cast<std::size_t>(buffers), std::size_t{1}, slots_.size() - spare_slots);
    find_window();
    for (Slot& slot : slots_)
        if (slot.index >= 0 && !in_window(slot.index) && &slot != lent_) slot.clear();
    pool_.wake();
}

bool ClipStream::rest() noexcept {
    const std::lock_guard lock(pool_.mutex());
    find_window();
    if (!window_.empty()) return false;
    resting_ = true;
    pool_.wake();
    lent_ = nullptr;
    newest_ = -1;
    for (Slot& slot : slots_)
        if (slot.index >= 0) slot.clear();
    return true;
}

ClipStream::Work ClipStream::work() const noexcept {
    const std::lock_guard lock(pool_.mutex());
    return work_;
}

bool ClipStream::closed() const noexcept {
    const std::lock_guard lock(pool_.mutex());
    return closed_;
}

std::size_t ClipStream::memory() const noexcept {
    const std::lock_guard lock(pool_.mutex());
    std::size_t bytes = 0;
    for (const Slot& slot : slots_)
        bytes += !slot.given.empty() ? slot.given.size() : slot.index >= 0 ? slot.picture.bytes.capacity() : 0;
    return bytes;
}

}  // namespace lapfx::media
