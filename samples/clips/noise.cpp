#include "noise.h"

#include <cmath>

namespace clips {
namespace {

float fade(float t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

int wrap(int i, int period) {
    const int r = i % period;
    return r < 0 ? r + period : r;
}

/// Dot product of the offset with one of Perlin's twelve edge directions (four of them twice).
float gradient(std::uint32_t h, glm::vec3 d) {
    const std::uint32_t c = h & 15U;
    const float u = c < 8U ? d.x : d.y;
    const float v = c < 4U ? d.y : (c == 12U || c == 14U ? d.x : d.z);
    return ((c & 1U) ? -u : u) + ((c & 2U) ? -v : v);
}

}  // namespace

float noise1(float x, int period, std::uint32_t seed) {
    const float base = std::floor(x);
    const float f = x - base;
    const auto slope = [&](int i) { return 2.0f * uniform(hash(std::uint32_t(wrap(i, period)), seed)) - 1.0f; };
    const int i = int(base);
    const float a = slope(i) * f;
    const float b = slope(i + 1) * (f - 1.0f);
    return 2.0f * (a + fade(f) * (b - a));
}

float noise3(glm::vec3 p, int period, std::uint32_t seed) {
    const glm::vec3 base = glm::floor(p);
    const glm::vec3 f = p - base;
    const glm::ivec3 cell(base);
    const glm::vec3 s(fade(f.x), fade(f.y), fade(f.z));
    float corner[2][2][2];
    for (int k = 0; k < 2; ++k) {
        const std::uint32_t hz = hash(std::uint32_t(wrap(cell.z + k, period)), seed);
        for (int j = 0; j < 2; ++j) {
            const std::uint32_t hy = hash(std::uint32_t(wrap(cell.y + j, period)), hz);
            for (int i = 0; i < 2; ++i) {
                const std::uint32_t h = hash(std::uint32_t(wrap(cell.x + i, period)), hy);
                corner[k][j][i] = gradient(h, f - glm::vec3(float(i), float(j), float(k)));
            }
        }
    }
    const auto row = [&](int k, int j) { return glm::mix(corner[k][j][0], corner[k][j][1], s.x); };
    const auto plane = [&](int k) { return glm::mix(row(k, 0), row(k, 1), s.y); };
    return glm::mix(plane(0), plane(1), s.z);
}

float fractal3(glm::vec3 p, int period, int octaves, float gain, std::uint32_t seed) {
    float sum = 0.0f;
    float amplitude = 1.0f;
    for (int o = 0; o < octaves; ++o) {
        const float scale = float(1 << o);
        sum += amplitude * noise3(p * scale, period << o, hash(seed, std::uint32_t(o)));
        amplitude *= gain;
    }
    return sum;
}

TurbulenceTile::TurbulenceTile(int lobes, int octaves, float gain, std::uint32_t seed)
    : values_(std::size_t(edge) * edge * edge) {
    std::vector<glm::vec3> potential(values_.size());
    const auto at = [](int i, int j, int k) {
        return (std::size_t(wrap(k, edge)) * edge + std::size_t(wrap(j, edge))) * edge + std::size_t(wrap(i, edge));
    };
    for (int k = 0; k < edge; ++k)
        for (int j = 0; j < edge; ++j)
            for (int i = 0; i < edge; ++i) {
                const glm::vec3 p = glm::vec3(i, j, k) * (float(lobes) / float(edge));
                potential[at(i, j, k)] = {fractal3(p, lobes, octaves, gain, hash(seed, 1)),
                                          fractal3(p, lobes, octaves, gain, hash(seed, 2)),
                                          fractal3(p, lobes, octaves, gain, hash(seed, 3))};
            }
    double square = 0.0;
    for (int k = 0; k < edge; ++k)
        for (int j = 0; j < edge; ++j)
            for (int i = 0; i < edge; ++i) {
                const glm::vec3 dx = potential[at(i + 1, j, k)] - potential[at(i - 1, j, k)];
                const glm::vec3 dy = potential[at(i, j + 1, k)] - potential[at(i, j - 1, k)];
                const glm::vec3 dz = potential[at(i, j, k + 1)] - potential[at(i, j, k - 1)];
                const glm::vec3 curl(dy.z - dz.y, dz.x - dx.z, dx.y - dy.x);
                values_[at(i, j, k)] = curl;
                square += double(glm::dot(curl, curl));
            }
    const float scale = float(1.0 / std::sqrt(square / double(values_.size())));
    for (glm::vec3& v : values_) v *= scale;
}

glm::vec3 TurbulenceTile::sample(glm::vec3 p) const {
    const glm::vec3 g = (p - glm::floor(p)) * float(edge);
    const glm::ivec3 i = glm::ivec3(g) & (edge - 1);
    const glm::vec3 f = g - glm::floor(g);
    const glm::ivec3 n = (i + 1) & (edge - 1);
    const auto at = [&](int x, int y, int z) -> const glm::vec3& {
        return values_[(std::size_t(z) * edge + std::size_t(y)) * edge + std::size_t(x)];
    };
    const auto row = [&](int y, int z) { return glm::mix(at(i.x, y, z), at(n.x, y, z), f.x); };
    return glm::mix(glm::mix(row(i.y, i.z), row(n.y, i.z), f.y), glm::mix(row(i.y, n.z), row(n.y, n.z), f.y), f.z);
}

}  // namespace clips
