// Sampled scalar fields on a regular 3-D lattice, and the staggered velocity made of three of them.
//
// Lengths are in velocity cells, y points up, the camera looks along -z. Cell (i, j, k) of the velocity grid spans [i,
// i+1] x [j, j+1] x [k, k+1]. A field knows the place of its first sample and the spacing of samples, so that face
// values, cell centres and a finer density grid all use the same code.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace clips {

struct Field {
    glm::ivec3 size{0};
    glm::vec3 origin{0.0f};  ///< position of sample (0, 0, 0)
    float spacing = 1.0f;
    std::vector<float> values;

    Field() = default;
    Field(glm::ivec3 samples, glm::vec3 first, float step)
        : size(samples), origin(first), spacing(step), values(std::size_t(samples.x) * samples.y * samples.z, 0.0f) {}

    std::size_t index(int i, int j, int k) const { return (std::size_t(k) * size.y + j) * size.x + i; }
    float& at(int i, int j, int k) { return values[index(i, j, k)]; }
    float at(int i, int j, int k) const { return values[index(i, j, k)]; }
    glm::vec3 position(int i, int j, int k) const { return origin + spacing * glm::vec3(i, j, k); }

    /// The cube of eight samples around a position, clamped into the lattice.
    struct Cube {
        std::size_t base;
        glm::vec3 f;
    };
    Cube cube(glm::vec3 position) const {
        const glm::vec3 last = glm::vec3(size) - 1.001f;
        const glm::vec3 g = glm::clamp((position - origin) * (1.0f / spacing), glm::vec3(0.0f), last);
        const int i = int(g.x), j = int(g.y), k = int(g.z);
        return {index(i, j, k), g - glm::vec3(float(i), float(j), float(k))};
    }

    /// Trilinear interpolation; outside, the nearest value inside.
    float sample(glm::vec3 position) const { return blend(cube(position)); }

    float blend(const Cube& c) const {
        const std::size_t dy = std::size_t(size.x), dz = dy * size.y;
        const float* p = values.data() + c.base;
        const float a = p[0] + c.f.x * (p[1] - p[0]);
        const float b = p[dy] + c.f.x * (p[dy + 1] - p[dy]);
        const float d = p[dz] + c.f.x * (p[dz + 1] - p[dz]);
        const float e = p[dz + dy] + c.f.x * (p[dz + dy + 1] - p[dz + dy]);
        const float front = a + c.f.y * (b - a);
        const float back = d + c.f.y * (e - d);
        return front + c.f.z * (back - front);
    }

    /// Smallest and largest of the eight samples.
    glm::vec2 bounds(const Cube& c) const {
        const std::size_t dy = std::size_t(size.x), dz = dy * size.y;
        const float* p = values.data() + c.base;
        const auto [low_a, high_a] = std::minmax({p[0], p[1], p[dy], p[dy + 1]});
        const auto [low_b, high_b] = std::minmax({p[dz], p[dz + 1], p[dz + dy], p[dz + dy + 1]});
        return {std::min(low_a, low_b), std::max(high_a, high_b)};
    }
};

/// Velocity on a staggered (MAC) grid, cells per second: each component is on the faces that it crosses, so that the
/// pressure does not decouple into a checkerboard (Harlow and Welch 1965).
struct Velocity {
    glm::ivec3 cells{0};
    Field u, v, w;

    Velocity() = default;
    explicit Velocity(glm::ivec3 n)
        : cells(n),
          u(n + glm::ivec3(1, 0, 0), {0.0f, 0.5f, 0.5f}, 1.0f),
          v(n + glm::ivec3(0, 1, 0), {0.5f, 0.0f, 0.5f}, 1.0f),
          w(n + glm::ivec3(0, 0, 1), {0.5f, 0.5f, 0.0f}, 1.0f) {}

    glm::vec3 at_cell(int i, int j, int k) const {
        return 0.5f * glm::vec3(u.at(i, j, k) + u.at(i + 1, j, k), v.at(i, j, k) + v.at(i, j + 1, k),
                                w.at(i, j, k) + w.at(i, j, k + 1));
    }
};

/// The same velocity gathered at cell centres: one interpolation instead of three where paths are traced. The
/// fourth component is padding, so that a sample is one vector register.
class Flow {
  public:
    explicit Flow(glm::ivec3 cells) : cells_(cells), values_(std::size_t(cells.x) * cells.y * cells.z) {}

    void gather(const Velocity& velocity, int k_begin, int k_end) {
        for (int k = k_begin; k < k_end; ++k)
            for (int j = 0; j < cells_.y; ++j)
                for (int i = 0; i < cells_.x; ++i) values_[index(i, j, k)] = glm::vec4(velocity.at_cell(i, j, k), 0.0f);
    }

    glm::vec3 sample(glm::vec3 p) const {
        const float x = std::clamp(p.x - 0.5f, 0.0f, float(cells_.x) - 1.001f);
        const float y = std::clamp(p.y - 0.5f, 0.0f, float(cells_.y) - 1.001f);
        const float z = std::clamp(p.z - 0.5f, 0.0f, float(cells_.z) - 1.001f);
        const int i = int(x), j = int(y), k = int(z);
        const float fx = x - float(i), fy = y - float(j), fz = z - float(k);
        const glm::vec4* a = values_.data() + index(i, j, k);
        const glm::vec4* b = a + cells_.x;
        const glm::vec4* c = a + std::size_t(cells_.x) * cells_.y;
        const glm::vec4* d = c + cells_.x;
        const glm::vec4 near = (a[0] * (1 - fx) + a[1] * fx) * (1 - fy) + (b[0] * (1 - fx) + b[1] * fx) * fy;
        const glm::vec4 far = (c[0] * (1 - fx) + c[1] * fx) * (1 - fy) + (d[0] * (1 - fx) + d[1] * fx) * fy;
        return glm::vec3(near * (1 - fz) + far * fz);
    }

  private:
    std::size_t index(int i, int j, int k) const { return (std::size_t(k) * cells_.y + j) * cells_.x + i; }

    glm::ivec3 cells_;
    std::vector<glm::vec4> values_;
};

}  // namespace clips
