#include "ui/text/run_cache.h"

#include <algorithm>

namespace lapfx::ui {

namespace {

constexpr std::size_t kept_spare = 256;  // entries that keep their memory while nothing is in them
constexpr std::size_t usual_text = 32;   // bytes
// Frames without use after which a run goes; sooner when something makes very many, such as scrolling through a long
// list.
constexpr std::uint64_t patience = 120, short_patience = 8;
constexpr std::size_t many = 4096;

}  // namespace

RunCache::RunCache() {
    entries_.reserve(2 * kept_spare);
    spare_.reserve(kept_spare);
    order_.reserve(most_order);
    for (std::uint32_t i = 0; i < kept_spare; ++i) {
        spare_.push_back(i);
        entries_.push_back(fresh());
        vacant_.reserve(entries_.capacity());  // dropping runs allocates nothing, then
    }
}

std::unique_ptr<RunCache::Entry> RunCache::fresh() const {
    auto entry = std::make_unique<Entry>();
    entry->text.reserve(usual_text);
    entry->run.glyphs.reserve(usual_text);
    entry->run.stops.reserve(usual_text + 1);
    return entry;
}

Run& RunCache::add(std::string_view text, std::uint64_t style) {
    std::uint32_t index = 0;
    if (!spare_.empty()) {
        index = spare_.back();
        spare_.pop_back();
    } else if (!vacant_.empty()) {
        index = vacant_.back();
        vacant_.pop_back();
        entries_[index] = fresh();
    } else {
        index = static_cast<std::uint32_t>(entries_.size());
        entries_.push_back(fresh());
        vacant_.reserve(entries_.capacity());  // dropping runs allocates nothing, then
    }
    Entry& entry = *entries_[index];
    entry.text = text;
    entry.style = style;
    entry.used = frame_;
    table_.insert(hash_bytes(style, text), index);
    return entry.run;
}

void RunCache::release(std::uint32_t index) {
    std::fill(order_.begin(), order_.end(), nullptr);  // one that is dropped may be among them
    Run& run = entries_[index]->run;
    const std::size_t held = std::max(entries_[index]->text.capacity(), run.glyphs.capacity());
    if (spare_.size() >= kept_spare || held > 8 * usual_text) {
        entries_[index].reset();
        vacant_.push_back(index);
        return;
    }
    run.glyphs.clear();
    run.stops.clear();
    spare_.push_back(index);
}

void RunCache::next_frame() {
    ++frame_;
    order_.resize(next_);
    next_ = 0;
    const std::uint64_t allowed = table_.size() > many ? short_patience : patience;
    // All slots in about half the patience.
    for (std::size_t left = table_.slots() / (allowed / 2); left > 0; --left) {
        sweep_ &= table_.slots() - 1;
        const std::uint32_t index = table_.in_slot(sweep_);
        if (index == IndexTable::none || frame_ - entries_[index]->used <= allowed) {
            ++sweep_;
            continue;
        }
        table_.erase_slot(sweep_);  // another may stand there now
        release(index);
    }
}

void RunCache::clear() {
    for (std::size_t slot = 0; slot < table_.slots(); ++slot) {
        if (table_.in_slot(slot) != IndexTable::none) release(table_.in_slot(slot));
    }
    table_.clear();
}

}  // namespace lapfx::ui
