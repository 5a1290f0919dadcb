// Organs of known shape, so that distances and areas on them have a closed form.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>

#include "lapfx/organ.h"

namespace lapfx::test {

/// Makes an organ that can be drawn from positions and indices: one part, one white material.
inline Organ drawable(Organ organ, const std::vector<glm::vec3>& normals) {
    organ.normals = normals;
    organ.tangents.assign(organ.positions.size(), glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    organ.uvs.assign(organ.positions.size(), glm::vec2(0.0f));
    organ.colors.assign(organ.positions.size(), glm::vec4(1.0f));
    organ.materials = {Material{.name = "tissue", .base_color = glm::vec4(0.6f, 0.4f, 0.35f, 1.0f)}};
    organ.parts = {
        Part{.name = "all", .first_index = 0, .index_count = static_cast<std::uint32_t>(organ.indices.size())}};
    return organ;
}

/// How the squares of plane() are cut into triangles.
enum class Cut {
    regular,    ///< all alike, right-angled
    irregular,  ///< inner vertices moved by up to 30 % of a square, diagonals at random
};

/// A square `side` mm wide around the origin in the plane y = 0, of 2 n n triangles, facing +y.
inline Organ plane(double side, std::uint32_t n, Cut cut = Cut::regular) {
    Organ organ;
    std::mt19937 random(7);
    const auto chance = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t x = 0; x <= n; ++x) {
            const bool inner = x > 0 && x < n && z > 0 && z < n && cut == Cut::irregular;
            const double dx = inner ? 0.6 * (chance() - 0.5) : 0.0, dz = inner ? 0.6 * (chance() - 0.5) : 0.0;
            organ.positions.emplace_back(glm::vec3(glm::dvec3((x + dx) / n - 0.5, 0.0, (z + dz) / n - 0.5) * side));
        }
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = z * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            if (cut == Cut::irregular && chance() < 0.5)
                organ.indices.insert(organ.indices.end(), {a, c, b, b, c, d});
            else
                organ.indices.insert(organ.indices.end(), {a, c, d, a, d, b});
        }
    return drawable(std::move(organ), std::vector<glm::vec3>(organ.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f)));
}

/// A sphere around the origin: an icosahedron whose triangles are cut into four `cuts` times.
inline Organ sphere(double radius, int cuts) {
    const double g = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<glm::dvec3> unit{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (glm::dvec3& p : unit) p = glm::normalize(p);
    std::vector<std::array<std::uint32_t, 3>> faces{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (int i = 0; i < cuts; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(unit.size()));
            if (fresh) unit.push_back(glm::normalize(unit[a] + unit[b]));
            return place->second;
        };
        std::vector<std::array<std::uint32_t, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(finer);
    }
    Organ organ;
    std::vector<glm::vec3> normals;
    for (const glm::dvec3& p : unit) {
        organ.positions.emplace_back(p * radius);
        normals.emplace_back(p);
    }
    for (const auto& face : faces) organ.indices.insert(organ.indices.end(), face.begin(), face.end());
    return drawable(std::move(organ), normals);
}

/// Both organs as one, `second` moved by `shift`.
inline Organ joined(const Organ& first, const Organ& second, glm::vec3 shift) {
    Organ organ = first;
    std::vector<glm::vec3> normals = first.normals;
    normals.insert(normals.end(), second.normals.begin(), second.normals.end());
    const auto base = static_cast<std::uint32_t>(first.positions.size());
    for (const glm::vec3& p : second.positions) organ.positions.push_back(p + shift);
    for (const std::uint32_t i : second.indices) organ.indices.push_back(base + i);
    return drawable(std::move(organ), normals);
}

}  // namespace lapfx::test
