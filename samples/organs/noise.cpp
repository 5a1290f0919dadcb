#include "noise.h"

#include <cmath>

namespace organs {
namespace {

std::uint32_t mix_bits(std::uint32_t h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    h ^= h >> 16;
    return h;
}

double gradient(std::uint32_t h, const dvec3& d) {
    // The twelve edge directions of a cube, four of them twice.
    const double a = (h & 8u) == 0u ? d.x : d.y;
    const double b = (h & 12u) == 0u ? d.y : ((h & 13u) == 12u ? d.x : d.z);
    return ((h & 1u) != 0u ? -a : a) + ((h & 2u) != 0u ? -b : b);
}

double fade(double t) {
    return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

std::uint32_t hash(std::uint32_t seed, int x, int y, int z) {
    std::uint32_t h = mix_bits(seed + 0x9e3779b9u);
    h = mix_bits(h ^ (static_cast<std::uint32_t>(x) * 0x85ebca6bu));
    h = mix_bits(h ^ (static_cast<std::uint32_t>(y) * 0xc2b2ae35u));
    return mix_bits(h ^ (static_cast<std::uint32_t>(z) * 0x27d4eb2fu));
}

double Random::next() {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) / 9007199254740992.0;
}

double perlin(const dvec3& p, std::uint32_t seed) {
    const dvec3 cell = glm::floor(p);
    const dvec3 f = p - cell;
    const int x = static_cast<int>(cell.x);
    const int y = static_cast<int>(cell.y);
    const int z = static_cast<int>(cell.z);
    double corner[8];
    for (int i = 0; i < 8; ++i) {
        const int dx = i & 1;
        const int dy = (i >> 1) & 1;
        const int dz = i >> 2;
        corner[i] = gradient(hash(seed, x + dx, y + dy, z + dz) >> 7, f - dvec3(dx, dy, dz));
    }
    const double u = fade(f.x);
    const double v = fade(f.y);
    const double w = fade(f.z);
    const double near_side = glm::mix(glm::mix(corner[0], corner[1], u), glm::mix(corner[2], corner[3], u), v);
    const double far_side = glm::mix(glm::mix(corner[4], corner[5], u), glm::mix(corner[6], corner[7], u), v);
    return glm::mix(near_side, far_side, w);
}

dvec3 perlin3(const dvec3& p, std::uint32_t seed) {
    return {perlin(p, seed), perlin(p + 31.7, seed + 101u), perlin(p - 17.3, seed + 202u)};
}

double fbm(const dvec3& p, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double strength = 0.5;
    double frequency = 1.0;
    for (int i = 0; i < octaves; ++i) {
        sum += strength * perlin(p * frequency, seed + static_cast<std::uint32_t>(i) * 17u);
        strength *= 0.5;
        frequency *= 2.03;
    }
    return sum * 1.6;
}

double ridges(const dvec3& p, int octaves, std::uint32_t seed) {
    double sum = 0.0;
    double total = 0.0;
    double strength = 1.0;
    double frequency = 1.0;
    for (int i = 0; i < octaves; ++i) {
        const double crest = 1.0 - std::abs(perlin(p * frequency, seed + static_cast<std::uint32_t>(i) * 29u)) * 1.6;
        sum += strength * clamp01(crest) * clamp01(crest);
        total += strength;
        strength *= 0.5;
        frequency *= 2.1;
    }
    return sum / total;
}

Cell worley(const dvec3& p, std::uint32_t seed) {
    const dvec3 base = glm::floor(p);
    Cell best{9.0, 9.0, 0u};
    for (int i = 0; i < 27; ++i) {
        const int x = static_cast<int>(base.x) + i % 3 - 1;
        const int y = static_cast<int>(base.y) + (i / 3) % 3 - 1;
        const int z = static_cast<int>(base.z) + i / 9 - 1;
        const std::uint32_t id = hash(seed, x, y, z);
        const dvec3 point = dvec3(x, y, z) + dvec3(unit(id), unit(mix_bits(id + 1u)), unit(mix_bits(id + 2u)));
        const double distance = glm::length(point - p);
        if (distance < best.nearest) {
            best.second = best.nearest;
            best.nearest = distance;
            best.id = id;
        } else if (distance < best.second) {
            best.second = distance;
        }
    }
    return best;
}

}  // namespace organs
