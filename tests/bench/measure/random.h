// Random numbers for the pictures of `lapfx bench measure`: the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace lapfx::bench {

class Random {
  public:
    /// `part` and `number`: of a picture, so that a change of one draws no other anew.
    Random(std::uint32_t seed, std::uint32_t part, std::uint32_t number)
        : engine_(seed * 2654435761U ^ (part * 40503U + number) * 2246822519U) {}

    double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0; }
    double log_in(double low, double high) { return low * std::pow(high / low, in(0, 1)); }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
    bool chance(double share) { return in(0, 1) < share; }
    /// Standard deviation 1.
    double normal() {
        const double length = std::sqrt(-2.0 * std::log(in(1e-9, 1)));
        return length * std::cos(in(0, 6.283185307));
    }

  private:
    std::mt19937 engine_;
};

}  // namespace lapfx::bench
