// A table from 64-bit hashes to indices that mean something to its owner: open addressing, linear probing. Grows by
// doubling, never shrinks; finding and erasing allocate nothing. The low bits of the hashes have to be well mixed.
// tsl::robin_map finds as fast, but keeps keys where here the owner has them already, and gives no slots to sweep a few
// a frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lapfx::ui {

class IndexTable {
  public:
    static constexpr std::uint32_t none = 0xffffffff;

    explicit IndexTable(std::size_t power_of_two) : slots_(power_of_two) {}

    /// The index kept under `hash` for which same(index) holds, or none.
    template <typename Same>
    std::uint32_t find(std::uint64_t hash, Same&& same) const {
        for (std::size_t at = home(hash); slots_[at].index != none; at = next(at)) {
            if (slots_[at].hash == hash && same(slots_[at].index)) return slots_[at].index;
        }
        return none;
    }

    void insert(std::uint64_t hash, std::uint32_t index) {
        if (++used_ * 2 > slots_.size()) grow();
        put({hash, index});
    }

    /// Later slots of the same cluster move up; slot `at` may hold another index afterwards.
    void erase_slot(std::size_t at) {
        --used_;
        for (std::size_t from = next(at); slots_[from].index != none; from = next(from)) {
            // An entry may move to the hole only when the hole lies between its home and where it is.
            const std::size_t reach = (from - home(slots_[from].hash)) & (slots_.size() - 1);
            if (reach < ((from - at) & (slots_.size() - 1))) continue;
            slots_[at] = slots_[from];
            at = from;
        }
        slots_[at] = {};
    }

    std::uint32_t in_slot(std::size_t at) const { return slots_[at].index; }
    std::size_t slots() const { return slots_.size(); }
    std::size_t size() const { return used_; }
    void clear() {
        slots_.assign(slots_.size(), {});
        used_ = 0;
    }

  private:
    struct Slot {
        std::uint64_t hash = 0;
        std::uint32_t index = none;
    };

    std::size_t home(std::uint64_t hash) const { return hash & (slots_.size() - 1); }
    std::size_t next(std::size_t at) const { return (at + 1) & (slots_.size() - 1); }
    void put(Slot slot) {
        std::size_t at = home(slot.hash);
        while (slots_[at].index != none) at = next(at);
        slots_[at] = slot;
    }
    void grow() {
        std::vector<Slot> old(slots_.size() * 2);
        old.swap(slots_);
        for (const Slot& slot : old) {
            if (slot.index != none) put(slot);
        }
    }

    std::vector<Slot> slots_;
    std::size_t used_ = 0;
};

}  // namespace lapfx::ui
