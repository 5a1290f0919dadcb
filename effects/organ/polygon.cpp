// No library does this as needed: GLU's tessellator merges corners at the same place, although their texture
// coordinates differ, and needs libOpenGL, which this core does not link. GEOS returns places instead of corners and
// takes ten times as long. tinyobjloader loses triangles of concave rings. CGAL's triangulations are under the GPL.
#include "organ/polygon.h"

#include <algorithm>
#include <cmath>

namespace lapfx::organ {

namespace {

/// Cutting ears takes time proportional to the square of the corners; no sane polygon has more.
constexpr std::size_t most_corners_for_ears = 1024;
/// Tries per corner of a ring: a ring that does not cross itself needs two, and one that needs more crosses itself.
constexpr std::size_t most_tries = 8;

using Ring = std::vector<glm::dvec2>;

/// Newell's normal: right for concave and slightly bent rings too.
glm::dvec3 ring_normal(std::span<const glm::vec3> ring) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(ring[0]);  // far from the origin of the scene the products would lose digits
    for (std::size_t i = 0; i < ring.size(); ++i)
        normal += glm::cross(glm::dvec3(ring[i]) - origin, glm::dvec3(ring[(i + 1) % ring.size()]) - origin);
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

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return cross(b - a, c - a);
}

bool is_convex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) <= 0) return false;
    return true;
}

/// Whether two edges cross within both of them.
bool crosses_itself(const Ring& ring) {
    const auto sides = [](double a, double b) { return (a > 0 && b < 0) || (a < 0 && b > 0); };
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (std::size_t k = i + 2; k < ring.size(); ++k) {
            const glm::dvec2 &a = ring[i], &b = ring[i + 1], &c = ring[k], &d = ring[(k + 1) % ring.size()];
            if (sides(turn(a, b, c), turn(a, b, d)) && sides(turn(c, d, a), turn(c, d, b))) return true;
        }
    return false;
}

class Ears {
  public:
    Ears(const Ring& ring, std::vector<std::uint32_t>& out)
        : ring_(ring), out_(out), left_(ring.size()), no_ear_(ring.size(), 0), tries_(most_tries * ring.size()) {
        for (std::size_t i = 0; i < left_.size(); ++i) left_[i] = static_cast<std::uint32_t>(i);
    }

    /// False when the ring crosses itself.
    bool cut() {
        const bool may_have_ears = !crosses_itself(ring_);  // otherwise any corner that turns left will do
        bool simple = may_have_ears;
        std::size_t start =
            0;  // the next ear is looked for behind this one, to go round the ring and not cut all at one corner
        while (left_.size() > 3) {
            std::size_t ear = first([&](std::size_t i) { return repeats(i); }, start);
            if (ear == none && may_have_ears) ear = first_ear(start);
            // The rest is a line, there and back.
            if (ear == none && may_have_ears) ear = first([&](std::size_t i) { return corner(i) == 0.0; }, start);
            if (ear == none) {
                simple = false;
                ear = first([&](std::size_t i) { return corner(i) > 0.0; }, start);
            }
            if (ear == none) ear = 0;
            out_.insert(out_.end(), {left_[before(ear)], left_[ear], left_[after(ear)]});
            no_ear_[left_[before(ear)]] = no_ear_[left_[after(ear)]] = 0;
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
            start = ear % left_.size();
        }
        out_.insert(out_.end(), left_.begin(), left_.end());
        return simple && tries_ > 0 && corner(1) >= 0.0;
    }

    /// Corners looked at so far.
    std::size_t looks() const { return looks_; }

  private:
    static constexpr std::size_t none = ~std::size_t{0};

    template <class Test>
    std::size_t first(const Test& test, std::size_t start) {
        for (std::size_t k = 0; k < left_.size(); ++k, ++looks_)
            if (const std::size_t i = (start + k) % left_.size(); test(i)) return i;
        return none;
    }

    /// A corner that was not an ear is tried again when its neighbour has been cut off, and again when none is found:
    /// where corners are at the same place, others may also have been in the way.
    std::size_t first_ear(std::size_t start) {
        const auto try_it = [&](std::size_t i) {
            char& no_ear = no_ear_[left_[i]];
            if (no_ear != 0 || tries_ == 0) return false;
            --tries_;
            no_ear = !is_ear(i);
            return no_ear == 0;
        };
        const std::size_t ear = first(try_it, start);
        if (ear != none) return ear;
        std::fill(no_ear_.begin(), no_ear_.end(), 0);
        return first(try_it, start);
    }

    std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }
    std::size_t after(std::size_t i) const { return (i + 1) % left_.size(); }
    const glm::dvec2& at(std::size_t i) const { return ring_[left_[i]]; }
    double corner(std::size_t i) const { return turn(at(before(i)), at(i), at(after(i))); }
    bool repeats(std::size_t i) const { return at(i) == at(before(i)); }

    bool is_ear(std::size_t i) {
        const glm::dvec2 &a = at(before(i)), &b = at(i), &c = at(after(i));
        if (turn(a, b, c) <= 0) return false;
        for (std::size_t k = 0; k < left_.size(); ++k, ++looks_) {
            if (k == i || k == before(i) || k == after(i)) continue;
            const glm::dvec2& p = at(k);
            if (p == a ? enters(k, b - a, c - a) : p == b ? enters(k, c - b, a - b) : p == c && enters(k, a - c, b - c))
                return false;
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    /// Whether an edge at a corner leads into the angle from `right` to `left` at the same place.
    bool enters(std::size_t k, const glm::dvec2& right, const glm::dvec2& left) const {
        for (const std::size_t other : {before(k), after(k)}) {
            const glm::dvec2 way = at(other) - at(k);
            if (cross(right, way) > 0 && cross(way, left) > 0) return true;
        }
        return false;
    }

    const Ring& ring_;
    std::vector<std::uint32_t>& out_;
    std::vector<std::uint32_t> left_;
    std::vector<char> no_ear_;  ///< for each corner of the ring: it was tried, and its neighbours have not changed
    std::size_t tries_;         ///< that are left
    std::size_t looks_ = 0;
};

/// Flips the edges between triangles until the two opposite angles of each are at most half a turn together (Lawson).
/// Then no triangle is flat if that can be avoided, and angles are as large as possible. Cutting ears alone leaves flat
/// triangles where corners are on an edge, and needles where they are almost on it.
class Edges {
  public:
    /// `corners`: triangles that divide the ring, none of them reversed, and without corners of the ring inside.
    Edges(const Ring& ring, std::span<std::uint32_t> corners)
        : ring_(ring), corners_(corners), beyond_(corners.size(), none), turns_left_(ring.size() * ring.size() / 2) {
        struct Side {
            std::uint64_t edge;
            std::uint32_t side;
        };
        std::vector<Side> sides;
        for (std::uint32_t side = 0; side < corners.size(); ++side) {
            const std::uint64_t from = corners[side], to = corners[next(side)];
            sides.push_back({std::min(from, to) << 32 | std::max(from, to), side});
        }
        std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
        for (std::size_t i = 1; i < sides.size(); ++i)
            if (sides[i - 1].edge == sides[i].edge) join(sides[i - 1].side, sides[i].side);
    }

    void turn_all() {
        std::vector<std::uint32_t> sides;
        for (std::uint32_t side = 0; side < corners_.size(); ++side)
            if (beyond_[side] != none && beyond_[side] > side) sides.push_back(side);
        while (!sides.empty() && turns_left_ > 0) {
            const std::uint32_t side = sides.back();
            sides.pop_back();
            ++looks_;
            if (beyond_[side] == none || !should_turn(side)) continue;
            --turns_left_;
            const std::uint32_t other = beyond_[side];
            turn_edge(side);
            sides.insert(sides.end(), {next(side), last(side), next(other), last(other)});
        }
    }

    std::size_t looks() const { return looks_; }

  private:
    static constexpr std::uint32_t none = 0xffffffff;

    /// Side k runs from corner k to the next corner of its triangle; the third corner is opposite.
    static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static std::uint32_t last(std::uint32_t side) { return next(next(side)); }

    const glm::dvec2& at(std::uint32_t side) const { return ring_[corners_[side]]; }

    void join(std::uint32_t a, std::uint32_t b) {
        if (a != none) beyond_[a] = b;
        if (b != none) beyond_[b] = a;
    }

    bool should_turn(std::uint32_t side) const {
        const std::uint32_t other = beyond_[side];
        const glm::dvec2 &a = at(side), &b = at(other), &c = at(last(side)), &d = at(last(other));
        if (turn(a, d, c) <= 0 || turn(d, b, c) <= 0) return false;  // only rounding makes this possible
        const double sine_c = turn(c, a, b), cosine_c = glm::dot(a - c, b - c);
        const double sine_d = turn(d, b, a), cosine_d = glm::dot(a - d, b - d);
        // For four corners on a circle either edge will do.
        const double rounding =
            1e-12 * (std::abs(sine_c) + std::abs(cosine_c)) * (std::abs(sine_d) + std::abs(cosine_d));
        return sine_c * cosine_d + cosine_c * sine_d < -rounding;
    }

    /// Flips the edge a-b of the triangles a b c and b a d to d-c: d c a and c d b.
    void turn_edge(std::uint32_t side) {
        const std::uint32_t other = beyond_[side];
        const std::uint32_t a = corners_[side], b = corners_[other], c = corners_[last(side)],
                            d = corners_[last(other)];
        const std::uint32_t bc = beyond_[next(side)], ca = beyond_[last(side)], ad = beyond_[next(other)],
                            db = beyond_[last(other)];
        corners_[side] = d, corners_[next(side)] = c, corners_[last(side)] = a;
        corners_[other] = c, corners_[next(other)] = d, corners_[last(other)] = b;
        join(next(side), ca);
        join(last(side), ad);
        join(next(other), db);
        join(last(other), bc);
    }

    const Ring& ring_;
    std::span<std::uint32_t> corners_;  ///< three for each triangle
    std::vector<std::uint32_t>
        beyond_;  ///< for each side, the side of the same edge in the other triangle; none: an edge of the ring
    std::size_t turns_left_;  ///< a flipped edge does not return, except by rounding
    std::size_t looks_ = 0;
};

}  // namespace

bool triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out, std::size_t* looks) {
    const bool few = ring.size() <= most_corners_for_ears;
    if (ring.size() > 3 && few) {
        const Ring flat = flattened(ring, ring_normal(ring));
        // If four corners all turn left, none is inside another's ear; five may form a star.
        if (ring.size() > 4 || !is_convex(flat)) {
            const std::size_t before = out.size();
            Ears ears(flat, out);
            const bool simple = ears.cut();
            if (looks != nullptr) *looks += ears.looks();
            if (!simple) return false;
            Edges edges(flat, std::span(out).subspan(before));
            edges.turn_all();
            if (looks != nullptr) *looks += edges.looks();
            return true;
        }
    }
    for (std::uint32_t i = 2; i < ring.size(); ++i) out.insert(out.end(), {0u, i - 1, i});
    return few;
}

}  // namespace lapfx::organ
