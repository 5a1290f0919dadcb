// Sums over the triangles of a surface, of which only those that have changed are computed again. In whole units, so
// that a sum does not depend on the order of changes. One thread at a time.
//
//     sums.mark(triangle);
//     sums.measure([&](std::uint32_t triangle, std::uint32_t) { return std::array{share(triangle) * area(triangle)};
//     });
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "organ/above_zero.h"
#include "organ/zeroed.h"

namespace lapfx::organ {

/// `Count`: how many sums, of values in mm2 or mm3. Memory and time are those of the triangles that have been marked,
/// so that the first of them costs no more on a large surface.
template <std::size_t Count>
class TriangleSums {
  public:
    explicit TriangleSums(std::size_t triangles) : number_(triangles) {}

    /// Its part has changed. True the first time since there was nothing: it is then numbered, from 0 on.
    bool mark(std::uint32_t triangle) {
        std::uint32_t& number = number_[triangle];
        const bool first = number == 0;
        if (first) {
            touched_.push_back({.triangle = triangle});
            number = static_cast<std::uint32_t>(touched_.size());
        }
        Touched& touched = touched_[number - 1];
        if (!std::exchange(touched.is_marked, true)) marked_.push_back(number - 1);
        return first;
    }
    /// All parts that there are have changed.
    void mark_all() {
        marked_.resize(touched_.size());
        std::iota(marked_.begin(), marked_.end(), 0U);
        for (Touched& touched : touched_) touched.is_marked = true;
    }
    /// There is nothing anywhere any more.
    void clear() noexcept {
        for (const Touched& touched : touched_) number_[touched.triangle] = 0;
        touched_.clear();
        marked_.clear();
        sums_ = {};
    }
    /// `part(triangle, number)`: what a triangle adds to each sum, an array of double; its number as mark() gave it.
    template <class Part>
    void measure(const Part& part) {
        for (const std::uint32_t number : marked_) {
            Touched& touched = touched_[number];
            const std::array<double, Count> now = part(touched.triangle, number);
            for (std::size_t i = 0; i < Count; ++i) {
                const std::int64_t units = whole_units(now[i], unit);
                sums_[i] += units - touched.parts[i];
                touched.parts[i] = units;
            }
            touched.is_marked = false;
        }
        marked_.clear();
    }
    double sum(std::size_t i = 0) const { return static_cast<double>(sums_[i]) * unit; }

  private:
    static constexpr double unit = 1e-6;  // mm2, mm3
    struct Touched {
        std::uint32_t triangle;
        bool is_marked = false;
        std::array<std::int64_t, Count> parts{};  // in the sums
    };

    Zeroed<std::uint32_t> number_;       // per triangle: 1 + its number, 0 where nothing was marked
    std::vector<Touched> touched_;       // the index is its number
    std::vector<std::uint32_t> marked_;  // numbers
    std::array<std::int64_t, Count> sums_{};
};

}  // namespace lapfx::organ
