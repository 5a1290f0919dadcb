// weld_surface(): seams whose two sides differ by rounding.
#include <array>
#include <bit>
#include <limits>

#include "organ/weld.h"

namespace lapfx::organ {

namespace {

/// How far apart two ends may be to count as one, as a part of the shortest edge there. Seams that were written with
/// few digits, or whose two sides were quantized separately, are torn by a few thousandths.
constexpr double of_shortest_edge = 0.01;
/// In a mesh so fine that rounding exceeds that: units in the last place, up to this part of the shortest edge.
constexpr double roundings = 4.0, most_of_shortest_edge = 0.05;
/// Two triangles with a smaller angle at their edge (10 degrees) are on top of each other: a sheet next to a sheet.
constexpr double folded = 0.985;
/// More open edges than this at one place are not a seam; this bounds the time for such a file.
constexpr int most_alike = 64;

/// An edge of one triangle only.
struct OpenEdge {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t across;  ///< the triangle's third point
};

std::vector<OpenEdge> open_edges(const std::vector<std::uint32_t>& corners, std::uint32_t points) {
    struct Half {
        std::uint32_t other, corner;  // `corner`: index of the edge's first corner
    };
    const auto next = [](std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    // Lists every edge at its lower point.
    std::vector<std::uint32_t> start(points + std::size_t{1}, 0);
    for (std::size_t c = 0; c < corners.size(); ++c) ++start[std::min(corners[c], corners[next(c)]) + 1];
    for (std::uint32_t p = 0; p < points; ++p) start[p + 1] += start[p];
    std::vector<Half> halves(corners.size());
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t a = corners[c], b = corners[next(c)];
        halves[fill[std::min(a, b)]++] = {std::max(a, b), static_cast<std::uint32_t>(c)};
    }
    std::vector<OpenEdge> open;
    for (std::uint32_t p = 0; p < points; ++p) {
        const auto begin = halves.begin() + start[p], end = halves.begin() + start[p + 1];
        std::sort(begin, end, [](const Half& a, const Half& b) {
            return a.other != b.other ? a.other < b.other : a.corner < b.corner;
        });
        for (auto half = begin; half != end;) {
            const auto last = std::find_if(half, end, [&](const Half& h) { return h.other != half->other; });
            if (last - half == 1 && half->other != p)
                open.push_back({{p, half->other}, corners[next(next(half->corner))]});
            half = last;
        }
    }
    return open;
}

class Seams {
  public:
    Seams(std::span<const glm::vec3> positions, std::vector<std::uint32_t> corners, Weld& weld)
        : weld_(weld), corners_(std::move(corners)), parent_(weld.points) {
        for (const std::uint32_t vertex : first_vertices(weld)) places_.emplace_back(positions[vertex]);
        for (std::uint32_t p = 0; p < weld.points; ++p) parent_[p] = p;
    }

    void sew() {
        const std::vector<OpenEdge> edges = open_edges(corners_, weld_.points);
        if (edges.empty()) return;
        find_tolerances(edges);
        join_edges(edges);
        if (!any_) return;
        part_collapsed();
        renumber();
    }

  private:
    struct Entry {
        std::uint64_t cell;
        std::uint32_t edge, next;
    };
    static constexpr std::uint32_t none = 0xffffffff;

    void find_tolerances(const std::vector<OpenEdge>& edges) {
        tolerance_.assign(weld_.points, -1.0f);
        for (const OpenEdge& edge : edges)
            for (const std::uint32_t end : edge.ends) tolerance_[end] = std::numeric_limits<float>::max();
        double largest = 0.0;
        for (std::size_t c = 0; c < corners_.size(); ++c) {
            const std::uint32_t a = corners_[c], b = corners_[c % 3 == 2 ? c - 2 : c + 1];
            if (a == b || (tolerance_[a] < 0.0f && tolerance_[b] < 0.0f)) continue;
            const auto length = static_cast<float>(glm::distance(places_[a], places_[b]));
            for (const std::uint32_t p : {a, b})
                if (tolerance_[p] >= 0.0f) tolerance_[p] = std::min(tolerance_[p], length);
            const glm::dvec3 size = glm::abs(places_[a]);
            largest = std::max({largest, size.x, size.y, size.z});
        }
        const double rounding = roundings * std::numeric_limits<float>::epsilon() * largest;
        for (float& t : tolerance_)
            if (t >= 0.0f)
                t = static_cast<float>(
                    std::min(most_of_shortest_edge * t, std::max<double>(of_shortest_edge * t, rounding)));
    }

    double tolerance(const OpenEdge& edge) const {
        return std::min(tolerance_[edge.ends[0]], tolerance_[edge.ends[1]]);
    }

    /// Finds edges by their middles, in cubes of about a quarter of their length.
    void join_edges(const std::vector<OpenEdge>& edges) {
        heads_.assign(std::bit_ceil(edges.size() * 2), none);
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            const glm::dvec3 &a = places_[edges[e].ends[0]], &b = places_[edges[e].ends[1]];
            const double length = glm::distance(a, b), reach = tolerance(edges[e]);
            const glm::dvec3 middle = 0.5 * (a + b);
            if (!(length > 0.0) || !std::isfinite(length)) continue;
            for (int level = level_of(length - 2.0 * reach); level <= level_of(length + 2.0 * reach); ++level) {
                const double side = std::ldexp(0.25, level);
                const glm::dvec3 low = cube(middle - reach, side), high = cube(middle + reach, side);
                for (double x = low.x; x <= high.x; ++x)
                    for (double y = low.y; y <= high.y; ++y)
                        for (double z = low.z; z <= high.z; ++z) match(edges, e, key(level, {x, y, z}));
            }
            const int level = level_of(length);
            const std::uint64_t cell = key(level, cube(middle, std::ldexp(0.25, level)));
            std::uint32_t& head = heads_[cell & (heads_.size() - 1)];
            entries_.push_back({cell, e, head});
            head = static_cast<std::uint32_t>(entries_.size()) - 1;
        }
    }

    static int level_of(double length) { return std::ilogb(length); }

    /// Whole numbers: edges are not shorter than the float resolution of their own coordinates, but other coordinates
    /// may be larger.
    static glm::dvec3 cube(const glm::dvec3& place, double side) {
        return glm::clamp(glm::floor(place / side), -1e15, 1e15);
    }

    static std::uint64_t key(int level, const glm::dvec3& cube) {
        auto h = static_cast<std::uint64_t>(level + 2000);
        for (int axis = 0; axis < 3; ++axis) {
            h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cube[axis]))) * 0x9e3779b97f4a7c15ull;
            h ^= h >> 31;
        }
        return h;
    }

    /// Compares with the edges that are already in a cube.
    void match(const std::vector<OpenEdge>& edges, std::uint32_t e, std::uint64_t cell) {
        int alike = 0;
        for (std::uint32_t i = heads_[cell & (heads_.size() - 1)]; i != none; i = entries_[i].next) {
            if (entries_[i].cell != cell) continue;
            if (++alike > most_alike) return;
            join(edges[e], edges[entries_[i].edge]);
        }
    }

    void join(const OpenEdge& e, const OpenEdge& f) {
        const double reach = std::min(tolerance(e), tolerance(f));
        const auto near = [&](std::uint32_t p, std::uint32_t q) {
            return glm::distance(places_[p], places_[q]) <= reach;
        };
        const bool straight = near(e.ends[0], f.ends[0]) && near(e.ends[1], f.ends[1]);
        const bool turned = !straight && near(e.ends[0], f.ends[1]) && near(e.ends[1], f.ends[0]);
        if ((!straight && !turned) || !goes_on(e, f)) return;
        unite(e.ends[0], f.ends[straight ? 0 : 1]);
        unite(e.ends[1], f.ends[straight ? 1 : 0]);
    }

    /// Whether the triangles at two edges are on different sides of them.
    bool goes_on(const OpenEdge& e, const OpenEdge& f) const {
        const glm::dvec3 a = inwards(e), b = inwards(f);
        return glm::dot(a, b) < folded * glm::length(a) * glm::length(b);  // false if one has no area
    }

    glm::dvec3 inwards(const OpenEdge& e) const {
        const glm::dvec3 along = glm::normalize(places_[e.ends[1]] - places_[e.ends[0]]);
        const glm::dvec3 to = places_[e.across] - places_[e.ends[0]];
        return to - glm::dot(to, along) * along;
    }

    std::uint32_t root(std::uint32_t p) {
        while (parent_[p] != p) p = parent_[p] = parent_[parent_[p]];
        return p;
    }

    void unite(std::uint32_t p, std::uint32_t q) {
        p = root(p), q = root(q);
        if (p == q) return;
        parent_[std::max(p, q)] = std::min(p, q);
        any_ = true;
    }

    /// When many points are at one place, each close to the next, both ends of an edge may have become one; these are
    /// separated again.
    void part_collapsed() {
        std::vector<char> collapsed(parent_.size(), 0);
        bool any = false;
        for (std::size_t c = 0; c < corners_.size(); ++c) {
            const std::uint32_t a = corners_[c], b = corners_[c % 3 == 2 ? c - 2 : c + 1];
            if (a == b || root(a) != root(b)) continue;
            collapsed[root(a)] = 1;
            any = true;
        }
        if (!any) return;
        std::vector<std::uint32_t> roots(parent_.size());
        for (std::uint32_t p = 0; p < parent_.size(); ++p) roots[p] = root(p);
        for (std::uint32_t p = 0; p < parent_.size(); ++p) parent_[p] = collapsed[roots[p]] ? p : roots[p];
    }

    void renumber() {
        std::vector<std::uint32_t> number(parent_.size(), 0);
        std::uint32_t points = 0;
        for (std::uint32_t p = 0; p < parent_.size(); ++p) {
            const std::uint32_t r = root(p);  // the lowest, so it already has its number
            if (r == p) {
                number[p] = points++;
                continue;
            }
            number[p] = number[r];
            ++weld_.sewn;
            weld_.gap = std::max(weld_.gap, glm::distance(places_[p], places_[r]));
        }
        for (std::uint32_t& point : weld_.point) point = number[point];
        weld_.points = points;
    }

    Weld& weld_;
    std::vector<std::uint32_t> corners_;  ///< points of the triangles
    std::vector<std::uint32_t> parent_;   ///< each point has one that it is joined to, and finally itself
    std::vector<glm::dvec3> places_;
    std::vector<float> tolerance_;  ///< each point has one; below 0 if no edge there is open
    std::vector<std::uint32_t> heads_;
    std::vector<Entry> entries_;
    bool any_ = false;
};

}  // namespace

Weld weld_surface(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
    Weld weld = weld_positions(positions);
    std::vector<std::uint32_t> corners(indices.size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = weld.point[indices[i]];
    Seams(positions, std::move(corners), weld).sew();
    return weld;
}

}  // namespace lapfx::organ
