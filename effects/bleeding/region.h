// Places of a surface that have to be examined again, with a box around them. Allocates only to grow. One thread at a
// time.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>

#include "organ/point_set.h"

namespace lapfx::bleeding {

/// Axis-aligned, mm; empty at first.
struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dvec3& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    bool meets(const Box& other) const {
        return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high));
    }
};

class Region {
  public:
    /// An empty region of a surface with these points.
    explicit Region(std::span<const glm::dvec3> positions) : positions_(positions), points_(positions.size()) {}

    void add(std::uint32_t vertex) {
        if (points_.add(vertex)) box_.add(positions_[vertex]);
    }
    void clear() {
        points_.clear();
        box_ = {};
    }
    bool has(std::uint32_t vertex) const { return points_.has(vertex); }
    bool empty() const { return points_.empty(); }
    std::span<const std::uint32_t> vertices() const { return points_.points(); }
    const Box& box() const { return box_; }

  private:
    std::span<const glm::dvec3> positions_;
    organ::PointSet points_;
    Box box_;
};

}  // namespace lapfx::bleeding
