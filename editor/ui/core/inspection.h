// What can be read of a frame afterwards: by tests, dumps, accessibility, benchmarks.
#pragma once

#include "ui/core/overlays.h"

namespace lapfx::ui {

class Inspection : public Overlays {
  public:
    /// The nodes of the last frame() that was completed. core/tree.h finds nodes in them and writes them out.
    std::span<const Node> tree() const;
    std::size_t duplicates() const { return duplicates_; }
    int builds() const { return static_cast<int>(build_); }                                        ///< so far
    std::span<const WakeReason> wake_reasons() const { return {reasons_.data(), reason_count_}; }  ///< the last 64
    void clear_wake_reasons() { reason_count_ = 0; }
    std::size_t memory_used() const;  ///< bytes, of nodes, arenas, tables and draw list

  protected:
    using Overlays::Overlays;
};

}  // namespace lapfx::ui
