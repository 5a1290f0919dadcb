// Ears are cut here and not by a library: GLU's tessellator, the one that Debian has for C++ under a licence of ours,
// brings libOpenGL into a core that links no OpenGL, and makes one vertex of corners at the same place, whose texture
// coordinates differ.
#include "organ/polygon.h"

namespace lapfx::organ {

namespace {

/// Cutting ears takes time with the square of the corners; no sane polygon has more.
constexpr std::size_t most_corners_for_ears = 1024;
/// For each corner of a ring so many corners are tried as ears: a ring that does not cross itself does with two, and
/// what goes on without end is none.
constexpr std::size_t most_tries = 8;

using Ring = std::vector<glm::dvec2>;

/// Newell's normal: right for concave and slightly bent rings too.
glm::dvec3 ring_normal(std::span<const glm::vec3> ring) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(ring[0]);  // far from the scene's origin the products would lose their digits
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
        const bool may_have_ears = !crosses_itself(ring_);  // else any corner that turns left is as good as another
        bool simple = may_have_ears;
        std::size_t start = 0;  // one ear is looked for behind the other: cut round the ring, not all at one corner
        while (left_.size() > 3) {
            std::size_t ear = first([&](std::size_t i) { return repeats(i); }, start);
            if (ear == none && may_have_ears) ear = first_ear(start);
            // What is left is a line, there and back.
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

    /// A corner that was no ear is tried again when the one beside it has been cut off, and once more when none is
    /// found: where corners lie at the same place, others may have been in the way, too.
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
    std::vector<char> no_ear_;  ///< of each corner of the ring: it was tried, and nothing has changed beside it
    std::size_t tries_;         ///< that are left
    std::size_t looks_ = 0;
};

}  // namespace

bool triangulate(std::span<const glm::vec3> ring, std::vector<std::uint32_t>& out, std::size_t* looks) {
    const bool few = ring.size() <= most_corners_for_ears;
    if (ring.size() > 3 && few) {
        const Ring flat = flattened(ring, ring_normal(ring));
        // Of four corners that all turn left none lies in another's ear; five may be those of a star.
        if (ring.size() > 4 || !is_convex(flat)) {
            Ears ears(flat, out);
            const bool simple = ears.cut();
            if (looks != nullptr) *looks += ears.looks();
            return simple;
        }
    }
    for (std::uint32_t i = 2; i < ring.size(); ++i) out.insert(out.end(), {0u, i - 1, i});
    return few;
}

}  // namespace lapfx::organ
