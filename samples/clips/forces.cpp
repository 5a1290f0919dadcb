#include "forces.h"

#include <cmath>

#include "parallel.h"

namespace clips {
namespace {

/// Calls body(i, j, k) for all cells, in slabs.
template <class Body>
void for_cells(glm::ivec3 cells, const Body& body) {
    for_slabs(cells.z, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < cells.y; ++j)
                for (int i = 0; i < cells.x; ++i) body(i, j, k);
    });
}

glm::vec3 centre(int i, int j, int k) {
    return glm::vec3(i, j, k) + 0.5f;
}

}  // namespace

Forces::Forces(glm::ivec3 cells)
    : cells_(cells), force_(std::size_t(cells.x) * cells.y * cells.z), vorticity_(force_.size()) {}

void Forces::clear() {
    std::fill(force_.begin(), force_.end(), glm::vec3(0.0f));
}

void Forces::add_buoyancy(const Field& temperature, const Field& density, float lift, float weight) {
    for_cells(cells_, [&](int i, int j, int k) {
        const glm::vec3 x = centre(i, j, k);
        force_[index(i, j, k)].y += lift * temperature.sample(x) - weight * density.sample(x);
    });
}

void Forces::add_confinement(const Velocity& velocity, float strength) {
    const glm::ivec3 last = cells_ - 1;
    for_cells(cells_, [&](int i, int j, int k) {
        const auto at = [&](int a, int b, int c) {
            const glm::ivec3 n = glm::clamp(glm::ivec3(a, b, c), glm::ivec3(0), last);
            return velocity.at_cell(n.x, n.y, n.z);
        };
        const glm::vec3 dx = at(i + 1, j, k) - at(i - 1, j, k);
        const glm::vec3 dy = at(i, j + 1, k) - at(i, j - 1, k);
        const glm::vec3 dz = at(i, j, k + 1) - at(i, j, k - 1);
        const glm::vec3 curl = 0.5f * glm::vec3(dy.z - dz.y, dz.x - dx.z, dx.y - dy.x);
        vorticity_[index(i, j, k)] = glm::vec4(curl, glm::length(curl));
    });
    for_cells(cells_, [&](int i, int j, int k) {
        if (glm::any(glm::equal(glm::ivec3(i, j, k), glm::ivec3(0))) || glm::any(glm::equal(glm::ivec3(i, j, k), last)))
            return;
        const auto size = [&](int a, int b, int c) { return vorticity_[index(a, b, c)].w; };
        const glm::vec3 uphill(size(i + 1, j, k) - size(i - 1, j, k), size(i, j + 1, k) - size(i, j - 1, k),
                               size(i, j, k + 1) - size(i, j, k - 1));
        const glm::vec3 direction = uphill / (glm::length(uphill) + 1e-4f);
        force_[index(i, j, k)] += strength * glm::cross(direction, glm::vec3(vorticity_[index(i, j, k)]));
    });
}

void Forces::add_turbulence(const TurbulenceTile& tile, float scale, glm::vec3 drift, float strength,
                            const Field* where, float gain) {
    for_cells(cells_, [&](int i, int j, int k) {
        const glm::vec3 x = centre(i, j, k);
        const float weight = where ? std::min(1.0f, gain * where->sample(x)) : 1.0f;
        if (weight < 1e-3f) return;
        // The axes of the second tile are swapped, so that the two never align.
        const glm::vec3 a = tile.sample(x * scale + drift);
        const glm::vec3 b =
            tile.sample(glm::vec3(x.z, x.x, x.y) * scale - glm::vec3(drift.z, drift.x, drift.y) + 0.37f);
        force_[index(i, j, k)] += (0.7f * strength * weight) * (a + glm::vec3(b.y, b.z, b.x));
    });
}

void Forces::apply(Velocity& velocity, float dt) const {
    const float half = 0.5f * dt;
    for_slabs(cells_.z, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < cells_.y; ++j)
                for (int i = 0; i < cells_.x; ++i) {
                    const glm::vec3 f = half * force_[index(i, j, k)];
                    velocity.u.at(i, j, k) += f.x;
                    velocity.u.at(i + 1, j, k) += f.x;
                    velocity.v.at(i, j, k) += f.y;
                    velocity.v.at(i, j + 1, k) += f.y;
                }
    });
    // Faces across z would belong to two slabs, so these slabs are rows.
    for_slabs(cells_.y, [&](int begin, int end) {
        for (int k = 0; k < cells_.z; ++k)
            for (int j = begin; j < end; ++j)
                for (int i = 0; i < cells_.x; ++i) {
                    const float f = half * force_[index(i, j, k)].z;
                    velocity.w.at(i, j, k) += f;
                    velocity.w.at(i, j, k + 1) += f;
                }
    });
}

}  // namespace clips
