// The place of each id in the newest build that had it and in the one before. The table uses open addressing and
// allocates nothing while the UI does not grow. An entry is written only when the place of its widget changes, so that
// a UI at rest does not touch the table. Whether a widget is in a build is read from the build, which has its id there.
#pragma once

#include <vector>

#include "ui/core/node_parts.h"

namespace lapfx::ui {

struct Seen {
    Id id = 0;
    std::uint32_t node = no_node, before = no_node;
    std::uint32_t ordinal = 0;  ///< the last widget of the same label had it in build `ordinal_build`
    std::uint32_t ordinal_build = 0;
    std::uint32_t events = 0;  ///< the build that has events for it
};

class StateTable {
  public:
    StateTable() : slots_(1024) {}

    /// Made when it is not there. `owner.is_alive(seen)`: what must not be forgotten when the table is full.
    template <typename Owner>
    Seen& at(Id id, const Owner& owner) {
        if (count_ * 2 >= slots_.size()) make_room(owner);
        return at(id);
    }
    const Seen* find(Id id) const {
        std::size_t i = id & (slots_.size() - 1);
        while (slots_[i].id != id && slots_[i].id != 0) i = (i + 1) & (slots_.size() - 1);
        return slots_[i].id == 0 ? nullptr : &slots_[i];
    }
    std::size_t size() const { return count_; }

  private:
    Seen& at(Id id) {
        std::size_t i = id & (slots_.size() - 1);
        while (slots_[i].id != id && slots_[i].id != 0) i = (i + 1) & (slots_.size() - 1);
        if (slots_[i].id == 0) slots_[i].id = id, ++count_;
        return slots_[i];
    }
    template <typename Owner>
    void make_room(const Owner& owner) {
        std::vector<Seen> old = std::move(slots_);
        std::size_t kept = 0;
        const auto alive = [&](const Seen& s) { return s.id != 0 && owner.is_alive(s); };
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
};

}  // namespace lapfx::ui
