// Runs by text and style. Runs that are not used for a while go, a few slots a frame; their memory serves the next
// ones, so that a number that changes every frame allocates nothing either. Private to text/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/core/id.h"
#include "ui/text/fonts.h"
#include "ui/text/index_table.h"

namespace lapfx::ui {

class RunCache {
  public:
    RunCache();

    /// nullptr: not there. Otherwise counts as used in this frame.
    const Run* find(std::string_view text, std::uint64_t style) {
        const std::uint64_t hash = hash_bytes(style, text);
        const std::uint32_t index = table_.find(
            hash, [&](std::uint32_t i) { return entries_[i]->style == style && entries_[i]->text == text; });
        if (index == IndexTable::none) return nullptr;
        entries_[index]->used = frame_;
        return &entries_[index]->run;
    }
    /// An empty run for what find() did not find. Stays where it is until the next call of next_frame() or clear().
    Run& add(std::string_view text, std::uint64_t style);
    void next_frame();
    void clear();
    std::size_t size() const { return table_.size(); }

  private:
    struct Entry {
        std::string text;
        std::uint64_t style = 0;
        std::uint64_t used = 0;  ///< frame
        Run run;
    };
    std::unique_ptr<Entry> fresh() const;
    void release(std::uint32_t index);

    IndexTable table_{2048};
    std::vector<std::unique_ptr<Entry>> entries_;
    std::vector<std::uint32_t> spare_;   ///< entries not in the table, with their memory
    std::vector<std::uint32_t> vacant_;  ///< places in entries_ where there is none
    std::uint64_t frame_ = 0;
    std::size_t sweep_ = 0;  ///< slot that next_frame() looks at next
};

}  // namespace lapfx::ui
