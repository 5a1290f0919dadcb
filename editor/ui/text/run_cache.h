// Runs by text and style. Runs that are not used for a while are dropped, a few slots in each frame; their memory is
// used for new ones, so that a number that changes in every frame allocates nothing. Private to text/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/text/fonts.h"
#include "ui/text/index_table.h"
#include "ui/value/id.h"

namespace lapfx::ui {

class RunCache {
  public:
    RunCache();

    /// nullptr: not there. Otherwise counts as used in this frame.
    const Run* find(std::string_view text, std::uint64_t style) {
        // A UI at rest asks for the same texts in the same order, frame after frame.
        if (next_ == order_.size() && next_ < most_order) order_.push_back(nullptr);
        Entry* none = nullptr;
        Entry*& expected = next_ < order_.size() ? order_[next_++] : none;
        if (expected == nullptr || expected->style != style || expected->text != text) expected = look_up(text, style);
        if (expected == nullptr) return nullptr;
        expected->used = frame_;
        return &expected->run;
    }
    /// An empty run for what find() did not find. Stays where it is until the next call of next_frame() or clear().
    Run& add(std::string_view text, std::uint64_t style);
    void next_frame();
    void clear();
    std::size_t size() const { return table_.size(); }

  private:
    static constexpr std::size_t most_order = 8192;  ///< texts of a frame whose order is kept
    struct Entry {
        std::string text;
        std::uint64_t style = 0;
        std::uint64_t used = 0;  ///< frame
        Run run;
    };
    Entry* look_up(std::string_view text, std::uint64_t style) const {
        const std::uint32_t index = table_.find(hash_bytes(style, text), [&](std::uint32_t i) {
            return entries_[i]->style == style && entries_[i]->text == text;
        });
        return index == IndexTable::none ? nullptr : entries_[index].get();
    }
    std::unique_ptr<Entry> fresh() const;
    void release(std::uint32_t index);

    IndexTable table_{2048};
    std::vector<std::unique_ptr<Entry>> entries_;
    std::vector<std::uint32_t> spare_;   ///< entries not in the table, with their memory
    std::vector<std::uint32_t> vacant_;  ///< places in entries_ where there is none
    std::vector<Entry*> order_;          ///< what find() gave in the frame before, and so far in this one
    std::size_t next_ = 0;               ///< of order_
    std::uint64_t frame_ = 0;
    std::size_t sweep_ = 0;  ///< slot that next_frame() looks at next
};

}  // namespace lapfx::ui
