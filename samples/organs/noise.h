// Seeded noise and random numbers that give the same values on every run: integer hashes, no library
// distributions.
//
//     Random random(7);
//     double bump = fbm(p * 0.2, 4, 11);   // p in mm: features of about 5 mm
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace organs {

using glm::dvec2;
using glm::dvec3;

inline constexpr double pi = 3.14159265358979323846;

std::uint32_t hash(std::uint32_t seed, int x, int y, int z);

/// A small sequential generator (splitmix64).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double next();  ///< 0 <= value < 1
    double between(double low, double high) { return low + (high - low) * next(); }

  private:
    std::uint64_t state_;
};

/// Gradient noise, about -1..1, one feature per unit.
double perlin(const dvec3& p, std::uint32_t seed);
dvec3 perlin3(const dvec3& p, std::uint32_t seed);

/// Octaves of perlin, each half as large and half as strong; about -1..1.
double fbm(const dvec3& p, int octaves, std::uint32_t seed);

/// Sharp crests where perlin passes zero; 0..1, 1 on the crest.
double ridges(const dvec3& p, int octaves, std::uint32_t seed);

/// Distances to the two nearest of points scattered one per unit cube, and the identity of the nearest.
struct Cell {
    double nearest = 0.0;
    double second = 0.0;
    std::uint32_t id = 0;
};
Cell worley(const dvec3& p, std::uint32_t seed);

/// 0..1 from a hash.
inline double unit(std::uint32_t h) {
    return static_cast<double>(h >> 8) / 16777216.0;
}

inline double clamp01(double x) {
    return x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x);
}

/// 0 at `from`, 1 at `to` (which may be the lower of the two), smooth at both.
inline double ramp(double from, double to, double x) {
    const double t = clamp01((x - from) / (to - from));
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace organs
