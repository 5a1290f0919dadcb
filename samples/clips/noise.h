// Seeded noise: integer hash, gradient noise that tiles, and a tile of divergence-free turbulence made from
// it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace clips {

/// Integer hash with good avalanche (Wellons, "Prospecting for hash functions", lowbias32).
inline std::uint32_t hash(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    x ^= x >> 16;
    return x;
}
inline std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
    return hash(x ^ (hash(y) + 0x9e3779b9U));
}

/// Uniform in [0, 1).
inline float uniform(std::uint32_t h) {
    return float(h >> 8) * (1.0f / 16777216.0f);
}

/// Gradient noise of a line, about -1 to 1, repeating after `period` units.
float noise1(float x, int period, std::uint32_t seed);

/// Gradient noise of space (Perlin 2002), about -1 to 1, repeating after `period` units along each axis.
float noise3(glm::vec3 p, int period, std::uint32_t seed);

/// Octaves of noise3, each at twice the frequency and `gain` of the amplitude.
float fractal3(glm::vec3 p, int period, int octaves, float gain, std::uint32_t seed);

/// A cube of turbulent velocity that tiles and has no divergence: the curl of a noise potential (Bridson, Houriham and
/// Nordenstam 2007). Two such tiles that drift against each other give turbulence that changes in time and returns to
/// its first state after a whole number of tiles, as a looping clip needs.
class TurbulenceTile {
  public:
    /// `lobes` swirls of the largest size along an edge; the tile's mean square is 1.
    TurbulenceTile(int lobes, int octaves, float gain, std::uint32_t seed);

    /// `p` in tiles, any value.
    glm::vec3 sample(glm::vec3 p) const;

  private:
    static constexpr int edge = 64;
    std::vector<glm::vec3> values_;
};

}  // namespace clips
