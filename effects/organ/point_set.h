// Points of a surface that have to be looked at again, each once, in the order in which they came. Allocates only to
// grow. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "organ/zeroed.h"

namespace lapfx::organ {

class PointSet {
  public:
    /// An empty set of points below `count`.
    explicit PointSet(std::size_t count) : has_(count) {}

    /// True when it was not in it before.
    bool add(std::uint32_t point) {
        if (std::exchange(has_[point], 1) != 0) return false;
        points_.push_back(point);
        return true;
    }
    void clear() noexcept {
        for (const std::uint32_t point : points_) has_[point] = 0;
        points_.clear();
    }
    bool has(std::uint32_t point) const { return has_[point] != 0; }
    bool empty() const { return points_.empty(); }
    std::span<const std::uint32_t> points() const { return points_; }

  private:
    Zeroed<char> has_;  // per point
    std::vector<std::uint32_t> points_;
};

}  // namespace lapfx::organ
