#include "projection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel.h"

namespace clips {
namespace {

/// Starting a thread does not pay for small grids.
template <class Body>
void for_planes(glm::ivec3 cells, const Body& body) {
    if (cells.x * cells.y * cells.z < 40000) return body(0, cells.z);
    for_slabs(cells.z, body);
}

}  // namespace

Projection::Projection(glm::ivec3 cells, Walls walls) : walls_(walls) {
    float h = 1.0f;
    for (;;) {
        const std::size_t count = std::size_t(cells.x + 2) * std::size_t(cells.y + 2) * std::size_t(cells.z + 2);
        levels_.push_back(
            {cells, h * h, std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)});
        const bool halves = cells.x % 2 == 0 && cells.y % 2 == 0 && cells.z % 2 == 0;
        if (!halves || std::min({cells.x, cells.y, cells.z}) <= 4) break;
        cells /= 2;
        h *= 2.0f;
    }
}

/// Pressure is 0 on the open faces (ghost = -inside) and has no slope across a wall (ghost = inside).
void Projection::set_ghosts(const Level& level, std::vector<float>& p) const {
    const auto [nx, ny, nz] = std::array{level.cells.x, level.cells.y, level.cells.z};
    const float bottom = walls_.bottom ? 1.0f : -1.0f;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            p[level.at(-1, j, k)] = -p[level.at(0, j, k)];
            p[level.at(nx, j, k)] = -p[level.at(nx - 1, j, k)];
        }
        for (int i = -1; i <= nx; ++i) {
            p[level.at(i, -1, k)] = bottom * p[level.at(i, 0, k)];
            p[level.at(i, ny, k)] = -p[level.at(i, ny - 1, k)];
        }
    }
    for (int j = -1; j <= ny; ++j)
        for (int i = -1; i <= nx; ++i) {
            p[level.at(i, j, -1)] = -p[level.at(i, j, 0)];
            p[level.at(i, j, nz)] = -p[level.at(i, j, nz - 1)];
        }
}

/// Gauss-Seidel in two colours: cells of one colour only read the other, so slabs do not depend on their
/// order.
void Projection::smooth(Level& level, int sweeps) const {
    const std::size_t dy = std::size_t(level.cells.x + 2), dz = dy * std::size_t(level.cells.y + 2);
    for (int half = 0; half < 2 * sweeps; ++half) {
        set_ghosts(level, level.p);
        for_planes(level.cells, [&](int begin, int end) {
            for (int k = begin; k < end; ++k)
                for (int j = 0; j < level.cells.y; ++j) {
                    float* p = level.p.data() + level.at(0, j, k);
                    const float* rhs = level.rhs.data() + level.at(0, j, k);
                    for (int i = (half + j + k) & 1; i < level.cells.x; i += 2) {
                        float* c = p + i;
                        const float sum = c[-1] + c[1] + *(c - dy) + c[dy] + *(c - dz) + c[dz];
                        *c = (sum - level.h2 * rhs[i]) * (1.0f / 6.0f);
                    }
                }
        });
    }
}

void Projection::find_residual(Level& level) const {
    const std::size_t dy = std::size_t(level.cells.x + 2), dz = dy * std::size_t(level.cells.y + 2);
    const float inverse = 1.0f / level.h2;
    set_ghosts(level, level.p);
    for_planes(level.cells, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < level.cells.y; ++j) {
                const std::size_t row = level.at(0, j, k);
                for (int i = 0; i < level.cells.x; ++i) {
                    const float* c = level.p.data() + row + i;
                    const float sum = c[-1] + c[1] + *(c - dy) + c[dy] + *(c - dz) + c[dz];
                    level.residual[row + i] = level.rhs[row + i] - (sum - 6.0f * *c) * inverse;
                }
            }
    });
}

void Projection::restrict_to(const Level& fine, Level& coarse) const {
    for_planes(coarse.cells, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < coarse.cells.y; ++j)
                for (int i = 0; i < coarse.cells.x; ++i) {
                    float sum = 0.0f;
                    for (int c = 0; c < 8; ++c)
                        sum += fine.residual[fine.at(2 * i + (c & 1), 2 * j + ((c >> 1) & 1), 2 * k + (c >> 2))];
                    coarse.rhs[coarse.at(i, j, k)] = 0.125f * sum;
                }
    });
    std::fill(coarse.p.begin(), coarse.p.end(), 0.0f);
}

/// Adds the coarse correction, interpolated: each fine cell takes 3/4 of its parent and 1/4 of the next, per
/// axis.
void Projection::prolong_to(Level& coarse, Level& fine) const {
    set_ghosts(coarse, coarse.p);
    const std::size_t dy = std::size_t(coarse.cells.x + 2), dz = dy * std::size_t(coarse.cells.y + 2);
    for_planes(fine.cells, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < fine.cells.y; ++j)
                for (int i = 0; i < fine.cells.x; ++i) {
                    const float* c = coarse.p.data() + coarse.at(i / 2, j / 2, k / 2);
                    const std::ptrdiff_t x = (i & 1) ? 1 : -1;
                    const std::ptrdiff_t y = (j & 1) ? std::ptrdiff_t(dy) : -std::ptrdiff_t(dy);
                    const std::ptrdiff_t z = (k & 1) ? std::ptrdiff_t(dz) : -std::ptrdiff_t(dz);
                    const auto row = [&](std::ptrdiff_t o) { return 0.75f * c[o] + 0.25f * c[o + x]; };
                    const auto plane = [&](std::ptrdiff_t o) { return 0.75f * row(o) + 0.25f * row(o + y); };
                    fine.p[fine.at(i, j, k)] += 0.75f * plane(0) + 0.25f * plane(z);
                }
    });
}

void Projection::cycle(std::size_t index) {
    Level& level = levels_[index];
    if (index + 1 == levels_.size()) return smooth(level, 30);
    smooth(level, 2);
    find_residual(level);
    restrict_to(level, levels_[index + 1]);
    cycle(index + 1);
    prolong_to(levels_[index + 1], level);
    smooth(level, 2);
}

void Projection::project(Velocity& velocity, const Field& expansion, int cycles) {
    Level& top = levels_.front();
    const glm::ivec3 n = top.cells;
    if (walls_.bottom)
        for (int k = 0; k < n.z; ++k)
            for (int i = 0; i < n.x; ++i) velocity.v.at(i, 0, k) = 0.0f;
    for_slabs(n.z, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < n.y; ++j)
                for (int i = 0; i < n.x; ++i)
                    top.rhs[top.at(i, j, k)] = velocity.u.at(i + 1, j, k) - velocity.u.at(i, j, k) +
                                               velocity.v.at(i, j + 1, k) - velocity.v.at(i, j, k) +
                                               velocity.w.at(i, j, k + 1) - velocity.w.at(i, j, k) -
                                               expansion.at(i, j, k);
    });
    for (int c = 0; c < cycles; ++c) cycle(0);
    set_ghosts(top, top.p);
    for_slabs(n.z + 1, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j <= n.y; ++j)
                for (int i = 0; i <= n.x; ++i) {
                    const float p = top.p[top.at(i, j, k)];
                    if (j < n.y && k < n.z) velocity.u.at(i, j, k) -= p - top.p[top.at(i - 1, j, k)];
                    if (i < n.x && k < n.z) velocity.v.at(i, j, k) -= p - top.p[top.at(i, j - 1, k)];
                    if (i < n.x && j < n.y) velocity.w.at(i, j, k) -= p - top.p[top.at(i, j, k - 1)];
                }
    });
}

double Projection::divergence(const Velocity& velocity) {
    const glm::ivec3 n = velocity.cells;
    double square = 0.0;
    for (int k = 0; k < n.z; ++k)
        for (int j = 0; j < n.y; ++j)
            for (int i = 0; i < n.x; ++i) {
                const double d = double(velocity.u.at(i + 1, j, k)) - double(velocity.u.at(i, j, k)) +
                                 double(velocity.v.at(i, j + 1, k)) - double(velocity.v.at(i, j, k)) +
                                 double(velocity.w.at(i, j, k + 1)) - double(velocity.w.at(i, j, k));
                square += d * d;
            }
    return std::sqrt(square / (double(n.x) * n.y * n.z));
}

}  // namespace clips
