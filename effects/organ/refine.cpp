// refine(): triangles that are too large for blood are split at the middles of their long edges, again and again.
// Whether an edge is split follows from its two ends alone, so the triangles on both sides agree and no crack opens,
// also at a texture seam, where the copies of a point count as one place.
#include "organ/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "lapfx/authoring/organ_report.h"
#include "organ/check.h"
#include "organ/weld.h"

namespace lapfx {

namespace {

using Corners = std::array<glm::vec3, 3>;

/// The result is the same to the last bit for both directions of an edge.
glm::vec3 middle(const glm::vec3& a, const glm::vec3& b) {
    return 0.5f * (a + b);
}

double squared(const glm::vec3& a, const glm::vec3& b) {
    const glm::dvec3 edge = glm::dvec3(b) - glm::dvec3(a);
    return glm::dot(edge, edge);
}

/// The triangles that a triangle is divided into: corners 0 to 2 are its own, 3 to 5 the middles of the edges that
/// start there.
struct Pattern {
    int count = 0;
    std::array<std::array<int, 3>, 4> triangles{};
};

/// `split[i]`: the edge from corner i to the next is too long. A quadrangle is cut along its shorter diagonal.
Pattern pattern_of(const Corners& p, const std::array<bool, 3>& split) {
    const int edges = split[0] + split[1] + split[2];
    if (edges == 3) return {4, {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}}};
    if (edges == 0) return {};
    // The one edge that is split, or the one that is not, starts at corner i.
    int i = 0;
    while (split[static_cast<std::size_t>(i)] != (edges == 1)) ++i;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (edges == 1) return {2, {{{i, i + 3, k}, {i + 3, j, k}}}};
    const auto at = [&](int corner) { return p[static_cast<std::size_t>(corner)]; };
    const int jk = j + 3, ki = k + 3;
    if (squared(at(i), middle(at(j), at(k))) <= squared(at(j), middle(at(k), at(i))))
        return {3, {{{k, ki, jk}, {i, j, jk}, {i, jk, ki}}}};
    return {3, {{{k, ki, jk}, {i, j, ki}, {j, jk, ki}}}};
}

/// Squared lengths from which on the three edges of a triangle are split, mm2; edge i starts at corner i.
using Limits = std::array<double, 3>;

/// Those of the edges of the file. Both triangles at an edge find the same; its pieces keep it.
Limits limits_of(const Corners& p, const organ::LongestEdge& longest) {
    return {longest.squared_for(squared(p[0], p[1])), longest.squared_for(squared(p[1], p[2])),
            longest.squared_for(squared(p[2], p[0]))};
}

/// Those of a triangle of a pattern. An edge inside belongs to no other triangle of the file.
Limits limits_of(const std::array<int, 3>& corners, const Limits& whole) {
    const auto limit = [&](int a, int b) {
        for (int i = 0; i < 3; ++i) {
            const auto on_edge = [&](int c) { return c == i || c == i + 3 || c == (i + 1) % 3; };
            if (on_edge(a) && on_edge(b)) return whole[static_cast<std::size_t>(i)];
        }
        return std::max({whole[0], whole[1], whole[2]});
    };
    return {limit(corners[0], corners[1]), limit(corners[1], corners[2]), limit(corners[2], corners[0])};
}

/// An edge of a few times the distance between floats there is not split: rounding would make pieces as long as it, and
/// there would be no end. Nor is one of infinite length.
bool too_long(const glm::vec3& a, const glm::vec3& b, double limit) {
    constexpr double few = 32.0;
    const glm::vec3 most = glm::max(glm::abs(a), glm::abs(b));
    const double far = std::max({most.x, most.y, most.z});
    const double least = few * far * std::numeric_limits<float>::epsilon();
    const double length2 = squared(a, b);
    return length2 > limit && length2 > least * least;
}

std::array<bool, 3> long_edges(const Corners& p, const Limits& limits) {
    return {too_long(p[0], p[1], limits[0]), too_long(p[1], p[2], limits[1]), too_long(p[2], p[0], limits[2])};
}

/// Number of triangles that one becomes; stops counting beyond `most`.
std::size_t count(const Corners& p, const Limits& limits, std::size_t most) {
    const Pattern pattern = pattern_of(p, long_edges(p, limits));
    if (pattern.count == 0) return 1;
    const std::array<glm::vec3, 6> at{p[0], p[1], p[2], middle(p[0], p[1]), middle(p[1], p[2]), middle(p[2], p[0])};
    std::size_t sum = 0;
    for (int t = 0; t < pattern.count && sum <= most; ++t) {
        const auto& c = pattern.triangles[static_cast<std::size_t>(t)];
        sum += count({at[static_cast<std::size_t>(c[0])], at[static_cast<std::size_t>(c[1])],
                      at[static_cast<std::size_t>(c[2])]},
                     limits_of(c, limits), most - std::min(most, sum));
    }
    return sum;
}

/// Places of the vertices; those of one point are the same to the last bit.
std::vector<glm::vec3> places_of(const Organ& organ) {
    const organ::Weld weld = organ::weld_surface(organ.positions, organ.indices);
    std::vector<glm::vec3> first(weld.points), places(organ.positions.size());
    for (std::size_t v = organ.positions.size(); v-- > 0;) first[weld.point[v]] = organ.positions[v];
    for (std::size_t v = 0; v < places.size(); ++v) places[v] = first[weld.point[v]];
    return places;
}

Corners corners_of(const Organ& organ, const std::vector<glm::vec3>& places, std::size_t triangle) {
    const std::uint32_t* const v = &organ.indices[3 * triangle];
    return {places[v[0]], places[v[1]], places[v[2]]};
}

glm::vec3 unit_or(const glm::vec3& direction, const glm::vec3& otherwise) {
    const float length = glm::length(direction);
    return length > 1e-6f ? direction / length : otherwise;
}

/// Every 32,768 triangles it reports progress and asks whether to stop.
constexpr std::size_t indices_between_stages = std::size_t{3} << 15;

class Refiner {
  public:
    Refiner(organ::SplitOrgan& out, const organ::LongestEdge& longest)
        : organ_(out.organ), from_(out.from), longest_(longest), places_(places_of(organ_)) {}

    void run(std::size_t triangles, const work::Stages& stages) {
        from_.parts = organ_.parts;
        from_.indices = std::move(organ_.indices);
        const std::vector<std::uint32_t>& before = from_.indices;
        indices_.reserve(3 * triangles);
        known_.reserve((triangles - before.size() / 3) * 3 / 4);  // about two new triangles for each
        std::size_t told = 0;
        for (Part& part : organ_.parts) {
            const auto first = static_cast<std::uint32_t>(indices_.size());
            for (std::uint32_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
                const Triangle v{before[i], before[i + 1], before[i + 2]};
                split(v, limits_of(corners_at(v), longest_));
                if (indices_.size() < told) continue;
                stages.reach(std::min(1.0, static_cast<double>(indices_.size()) / static_cast<double>(3 * triangles)));
                told = indices_.size() + indices_between_stages;
            }
            part.first_index = first;
            part.index_count = static_cast<std::uint32_t>(indices_.size()) - first;
        }
        organ_.indices = std::move(indices_);
    }

  private:
    using Triangle = std::array<std::uint32_t, 3>;

    Corners corners_at(const Triangle& v) const { return {places_[v[0]], places_[v[1]], places_[v[2]]}; }

    void split(const Triangle& v, const Limits& limits) {
        const Corners p = corners_at(v);
        const std::array<bool, 3> edges = long_edges(p, limits);
        const Pattern pattern = pattern_of(p, edges);
        if (pattern.count == 0) {
            indices_.insert(indices_.end(), v.begin(), v.end());
            return;
        }
        std::array<std::uint32_t, 6> corner{v[0], v[1], v[2], 0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i)
            if (edges[i]) corner[i + 3] = midpoint(v[i], v[(i + 1) % 3]);
        for (int t = 0; t < pattern.count; ++t) {
            const auto& c = pattern.triangles[static_cast<std::size_t>(t)];
            split({corner[static_cast<std::size_t>(c[0])], corner[static_cast<std::size_t>(c[1])],
                   corner[static_cast<std::size_t>(c[2])]},
                  limits_of(c, limits));
        }
    }

    std::uint32_t midpoint(std::uint32_t a, std::uint32_t b) {
        if (b < a) std::swap(a, b);
        const auto [found, is_new] =
            known_.try_emplace(std::uint64_t{a} << 32 | b, static_cast<std::uint32_t>(organ_.positions.size()));
        if (is_new) add(a, b);
        return found->second;
    }

    void add(std::uint32_t a, std::uint32_t b) {
        Organ& o = organ_;
        const glm::vec3 place = middle(places_[a], places_[b]);
        const glm::vec3 normal = unit_or(o.normals[a] + o.normals[b], o.normals[a]);
        const glm::vec3 along = glm::vec3(o.tangents[a]) + glm::vec3(o.tangents[b]);
        const glm::vec3 tangent = unit_or(along - normal * glm::dot(normal, along), glm::vec3(o.tangents[a]));
        places_.push_back(place);
        o.positions.push_back(place);
        o.normals.push_back(normal);
        o.tangents.emplace_back(tangent, o.tangents[a].w);
        o.uvs.push_back(0.5f * (o.uvs[a] + o.uvs[b]));
        o.colors.push_back(0.5f * (o.colors[a] + o.colors[b]));
        from_.midpoints.emplace_back(a, b);
    }

    Organ& organ_;
    organ::Unsplit& from_;
    organ::LongestEdge longest_;
    std::vector<glm::vec3> places_;
    std::vector<std::uint32_t> indices_;
    std::unordered_map<std::uint64_t, std::uint32_t>
        known_;  // the vertices that a midpoint lies between, the smaller first
};

double longest2_of(const Corners& p) {
    return std::max({squared(p[0], p[1]), squared(p[1], p[2]), squared(p[2], p[0])});
}

double area_of(const Corners& p) {
    return 0.5 * glm::length(glm::cross(glm::dvec3(p[1]) - glm::dvec3(p[0]), glm::dvec3(p[2]) - glm::dvec3(p[0])));
}

/// A lower bound for the number of triangles: none is larger than the equilateral one of the longest edge that is
/// allowed, and each piece of a triangle's longest edge belongs to a different triangle.
class AtLeast {
  public:
    void add(const Corners& p) {
        const double longest2 = longest2_of(p), area = area_of(p);
        if (!std::isfinite(longest2) || !std::isfinite(area)) return;  // it stays as it is
        sizes_.push_back({longest2, area});
        longest2_ = std::max(longest2_, longest2);
    }
    double longest_edge() const { return std::sqrt(longest2_); }  ///< mm, of the triangles added
    double triangles(const organ::LongestEdge& longest) const {
        double by_length = 0.0, by_area = 0.0;
        for (const Size& size : sizes_) {
            const double limit2 = longest.squared_for(size.longest2);
            by_length += std::sqrt(size.longest2 / limit2);
            by_area += size.area / (0.25 * std::sqrt(3.0) * limit2);
        }
        return std::max(by_length, by_area);
    }

  private:
    struct Size {
        double longest2, area;  // mm2
    };
    std::vector<Size> sizes_;
    double longest2_ = 0.0;
};

/// mm that half of the surface has no longer edges than, after splitting.
double usual_length(const Organ& organ, const std::vector<glm::vec3>& places, const organ::LongestEdge& longest) {
    struct Piece {
        double length2, area;
    };
    std::vector<Piece> pieces;
    pieces.reserve(organ.triangle_count());
    double whole = 0.0;
    for (std::size_t t = 0; t < organ.triangle_count(); ++t) {
        const Corners p = corners_of(organ, places, t);
        const double area = area_of(p);
        if (!std::isfinite(area)) continue;
        pieces.push_back({longest.squared_for(longest2_of(p)), area});
        whole += area;
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.length2 < b.length2; });
    double sum = 0.0;
    for (const Piece& piece : pieces)
        if ((sum += piece.area) >= 0.5 * whole) return std::sqrt(piece.length2);
    return organ::longest_wanted;
}

}  // namespace

organ::RefinePlan organ::plan_refine(const Organ& organ, const work::Stages& stages) {
    require_complete(organ);
    RefinePlan plan{.triangles = organ.triangle_count()};
    // First without joining vertices: most organs are fine enough, and joining takes longer than this check.
    std::vector<std::size_t> coarse;
    for (std::size_t t = 0; t < organ.triangle_count(); ++t) {
        const Corners p = corners_of(organ, organ.positions, t);
        const std::array<bool, 3> edges = long_edges(p, limits_of(p, {}));
        if (edges[0] || edges[1] || edges[2]) coarse.push_back(t);
    }
    if (coarse.empty()) return plan;
    plan.splits = true;
    stages.reach(0.0);
    const std::vector<glm::vec3> places = places_of(organ);
    AtLeast at_least;
    for (const std::size_t t : coarse) at_least.add(corners_of(organ, places, t));
    const std::size_t most = coarse.size() + most_added;
    const auto longest_of = [&](int step) {
        return LongestEdge{.whole_up_to = step == 0 ? std::numeric_limits<double>::infinity()
                                                    : at_least.longest_edge() * std::pow(1.25, -step)};
    };
    const auto made_by = [&](int step) {
        stages.reach(0.0);
        ++plan.counts;
        const LongestEdge longest = longest_of(step);
        std::size_t made = 0;
        for (std::size_t i = 0; i < coarse.size() && made <= most; ++i) {
            const Corners p = corners_of(organ, places, coarse[i]);
            made += count(p, limits_of(p, longest), most - made);
        }
        return made;
    };
    int step = 0;
    std::size_t made = made_by(step);
    if (made > most) {
        // The first step that is fine enough: usually that of the estimate. For long and thin triangles, where the
        // estimate is poor, it is found by doubling strides and then by halving. Not for step 0, because edges too far
        // out to be split make fewer triangles than the estimate.
        int too_fine = 0;
        for (step = 1; at_least.triangles(longest_of(step)) > static_cast<double>(most); ++step) {
            stages.reach(0.0);
            too_fine = step;
        }
        for (int stride = 1; (made = made_by(step)) > most; stride *= 2) {
            too_fine = step;
            step += stride;
        }
        while (step - too_fine > 1) {
            const int middle = (step + too_fine) / 2;
            const std::size_t there = made_by(middle);
            if (there > most)
                too_fine = middle;
            else
                step = middle, made = there;
        }
        plan.longest = longest_of(step);
        plan.length = std::sqrt(plan.longest.squared_for(at_least.longest_edge() * at_least.longest_edge()));
        plan.usual = usual_length(organ, places, plan.longest);
    }
    plan.triangles += made - coarse.size();
    return plan;
}

organ::SplitOrgan organ::refine(Organ organ, const RefinePlan& plan, const work::Stages& stages) {
    SplitOrgan split{.organ = std::move(organ), .from = {}};
    if (!plan.splits) return split;
    Refiner(split, plan.longest).run(plan.triangles, stages);
    const auto fit = [](auto&... arrays) {
        (arrays.shrink_to_fit(), ...);
    };  // so there is room for half of them to grow
    Organ& o = split.organ;
    fit(o.positions, o.normals, o.tangents, o.uvs, o.colors, o.indices, split.from.midpoints);
    return split;
}

RefineReport report_refine(const Organ& organ) {
    const organ::RefinePlan plan = organ::plan_refine(organ);
    return {.triangles = plan.triangles, .longest_edge = plan.splits ? plan.length : 0.0, .bounded = plan.bounded()};
}

RefinedOrgan refine(Organ organ) {
    const organ::RefinePlan plan = organ::plan_refine(organ);
    organ::SplitOrgan split = organ::refine(std::move(organ), plan);
    return {.organ = std::move(split.organ), .midpoints = std::move(split.from.midpoints)};
}

organ::FineOrgan::FineOrgan(const Organ& organ) : given_(organ) {
    if (const RefinePlan plan = plan_refine(organ); plan.splits) split_ = refine(organ, plan);
}

}  // namespace lapfx
