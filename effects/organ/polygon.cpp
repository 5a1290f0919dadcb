#include "organ/polygon.h"

namespace lapfx::organ {

namespace {

/// Cutting ears takes quadratic time; no sane polygon has more corners.
constexpr std::size_t most_corners_for_ears = 1024;

using Ring = std::vector<glm::dvec2>;

/// Newell's normal: right for concave and slightly bent rings too.
glm::dvec3 ring_normal(std::span<const glm::vec3> ring) {
    glm::dvec3 normal(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        normal += glm::cross(glm::dvec3(ring[i]), glm::dvec3(ring[(i + 1) % ring.size()]));
    return normal;
}

/// The ring without its longest normal coordinate, counter-clockwise.
Ring flattened(std::span<const glm::vec3> ring, const glm::dvec3& normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    Ring flat;
    for (const glm::vec3& p : ring) flat.push_back(normal[drop] < 0 ? glm::dvec2(p[v], p[u]) : glm::dvec2(p[u], p[v]));
    return flat;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool is_convex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0) return false;
    return true;
}

bool is_ear(const Ring& ring, const std::vector<std::uint32_t>& left, std::size_t i) {
    const std::size_t n = left.size();
    const glm::dvec2 &a = ring[left[(i + n - 1) % n]], &b = ring[left[i]], &c = ring[left[(i + 1) % n]];
    if (turn(a, b, c) <= 0) return false;
    for (const std::uint32_t other : left) {
        const glm::dvec2& p = ring[other];
        if (p == a || p == b || p == c) continue;
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

/// False when the ring cannot be cut: nothing was appended then.
bool cut_ears(const Ring& ring, std::vector<std::uint32_t>& out) {
    const std::size_t start = out.size();
    std::vector<std::uint32_t> left(ring.size());
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = static_cast<std::uint32_t>(i);
    while (left.size() > 3) {
        std::size_t i = 0;
        while (i < left.size() && !is_ear(ring, left, i)) ++i;
        if (i == left.size()) {
            out.resize(start);
            return false;
        }
        const std::size_t n = left.size();
        out.insert(out.end(), {left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    out.insert(out.end(), left.begin(), left.end());
    return true;
}

}  // namespace

void triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out) {
    if (ring.size() > 3 && ring.size() <= most_corners_for_ears) {
        const Ring flat = flattened(ring, ring_normal(ring));
        if (!is_convex(flat) && cut_ears(flat, out)) return;
    }
    for (std::uint32_t i = 2; i < ring.size(); ++i) out.insert(out.end(), {0u, i - 1, i});
}

}  // namespace lapfx::organ
