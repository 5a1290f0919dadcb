// Sums over the triangles of a surface, of which only those that have changed are computed again. In whole units, so
// that a sum does not depend on the order of changes. One thread at a time.
//
//     sums.mark(triangle);
//     sums.measure([&](std::uint32_t triangle) { return std::array{share(triangle) * area(triangle)}; });
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "organ/above_zero.h"

namespace lapfx::organ {

/// `Count`: how many sums, of values in mm2 or mm3.
template <std::size_t Count>
class TriangleSums {
  public:
    explicit TriangleSums(std::size_t triangles) : triangles_(triangles) {}

    /// Its part has changed. True the first time since there was nothing.
    bool mark(std::uint32_t triangle) {
        if (state_.empty()) {
            state_.resize(triangles_, untouched);
            parts_.resize(triangles_);
        }
        char& state = state_[triangle];
        if (state == marked) return false;
        const bool first = state == untouched;
        if (first) {
            touched_.push_back(triangle);
            parts_[triangle] = {};
        }
        state = marked;
        marked_.push_back(triangle);
        return first;
    }
    /// All parts that there are have changed.
    void mark_all() {
        for (const std::uint32_t t : touched_) state_[t] = marked;
        marked_ = touched_;
    }
    /// There is nothing anywhere any more.
    void clear() noexcept {
        for (const std::uint32_t t : touched_) state_[t] = untouched;
        touched_.clear();
        marked_.clear();
        sums_ = {};
    }
    /// `part(triangle)`: what a triangle adds to each sum, an array of double.
    template <class Part>
    void measure(const Part& part) {
        for (const std::uint32_t t : marked_) {
            const std::array<double, Count> now = part(t);
            for (std::size_t i = 0; i < Count; ++i) {
                const std::int64_t units = whole_units(now[i], unit);
                sums_[i] += units - parts_[t][i];
                parts_[t][i] = units;
            }
            state_[t] = measured;
        }
        marked_.clear();
    }
    double sum(std::size_t i = 0) const { return static_cast<double>(sums_[i]) * unit; }

  private:
    static constexpr double unit = 1e-6;  // mm2, mm3
    enum State : char { untouched, measured, marked };

    std::size_t triangles_;
    std::vector<char> state_;                             // per triangle; empty until one is marked
    std::vector<std::array<std::int64_t, Count>> parts_;  // the same
    std::vector<std::uint32_t> touched_;                  // triangles that are not untouched
    std::vector<std::uint32_t> marked_;
    std::array<std::int64_t, Count> sums_{};
};

}  // namespace lapfx::organ
