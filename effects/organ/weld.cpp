#include "organ/weld.h"

#include <bit>

namespace lapfx::organ {

namespace {

std::uint64_t hash(glm::vec3 p) {
    p += 0.0f;  // -0 becomes 0
    std::uint64_t h = std::bit_cast<std::uint32_t>(p.x);
    h = (h ^ (h >> 32)) * 0x9e3779b97f4a7c15ull + std::bit_cast<std::uint32_t>(p.y);
    h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9ull + std::bit_cast<std::uint32_t>(p.z);
    h = (h ^ (h >> 32)) * 0x94d049bb133111ebull;
    return h ^ (h >> 31);
}

}  // namespace

Weld weld_positions(std::span<const glm::vec3> positions) {
    constexpr std::uint32_t none = 0xffffffff;
    Weld weld;
    weld.point.resize(positions.size());
    // Open addressing, at most half full; a slot holds the first vertex of a point.
    std::vector<std::uint32_t> slots(std::bit_ceil(positions.size() * 2 + 1), none);
    const std::uint64_t mask = slots.size() - 1;
    for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::uint64_t slot = hash(positions[vertex]) & mask;
        while (slots[slot] != none && positions[slots[slot]] != positions[vertex]) slot = (slot + 1) & mask;
        if (slots[slot] == none) {
            slots[slot] = vertex;
            weld.point[vertex] = weld.points++;
        } else {
            weld.point[vertex] = weld.point[slots[slot]];
        }
    }
    return weld;
}

std::vector<std::uint32_t> first_vertices(const Weld& weld) {
    std::vector<std::uint32_t> first(weld.points);
    for (auto vertex = static_cast<std::uint32_t>(weld.point.size()); vertex-- > 0;) first[weld.point[vertex]] = vertex;
    return first;
}

}  // namespace lapfx::organ
