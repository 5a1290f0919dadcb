// Where each id stands in this build and in the one before: open addressing, no allocation while the UI stays as large
// as it is.
#pragma once

#include <vector>

#include "ui/core/node.h"

namespace lapfx::ui {

struct Seen {
    Id id = 0;
    std::uint32_t build = 0, node = no_node;           ///< of the build that it was in last
    std::uint32_t before_build = 0, before = no_node;  ///< of the one before that
    std::uint32_t ordinal = 0;                         ///< of the last widget of the same label in this build
    std::uint32_t events = 0;                          ///< the build that has events for it
};

class StateTable {
  public:
    StateTable() : slots_(1024) {}

    Seen& at(Id id) {
        if (count_ * 2 >= slots_.size()) make_room();
        std::size_t i = id & (slots_.size() - 1);
        while (slots_[i].id != id && slots_[i].id != 0) i = (i + 1) & (slots_.size() - 1);
        if (slots_[i].id == 0) slots_[i].id = id, ++count_;
        return slots_[i];
    }
    Seen* find(Id id) {
        std::size_t i = id & (slots_.size() - 1);
        while (slots_[i].id != id && slots_[i].id != 0) i = (i + 1) & (slots_.size() - 1);
        return slots_[i].id == 0 ? nullptr : &slots_[i];
    }
    /// Builds go on counting up; ids not seen for so many may be forgotten when the table is full.
    void set_build(std::uint32_t build) { build_ = build; }
    std::size_t size() const { return count_; }

  private:
    static constexpr std::uint32_t keep_builds = 256;

    void make_room() {
        std::vector<Seen> old = std::move(slots_);
        std::size_t kept = 0;
        const auto alive = [this](const Seen& s) { return s.id != 0 && build_ - s.build < keep_builds; };
        for (const Seen& s : old) kept += alive(s) ? 1 : 0;
        std::size_t size = old.size();
        while (kept * 4 >= size) size *= 2;
        slots_.assign(size, {});
        count_ = 0;
        for (const Seen& s : old) {
            if (alive(s)) at(s.id) = s;
        }
    }

    std::vector<Seen> slots_;
    std::size_t count_ = 0;
    std::uint32_t build_ = 0;
};

}  // namespace lapfx::ui
