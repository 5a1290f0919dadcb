#include "vessels.h"

#include <algorithm>
#include <cmath>

#include "curve.h"

namespace organs {
namespace {

struct Demand {
    dvec3 position{0.0};
    double distance = 1e9;  ///< to the nearest vessel
    int nearest = -1;
    bool content = false;
};

/// The (u, v) whose surface point is `offset` away from that at `from`, to first order.
dvec2 move(const Patch& patch, const dvec2& from, const dvec3& offset) {
    const SurfacePoint at = sample(patch, from.x, from.y);
    const double a = glm::dot(at.du, at.du);
    const double b = glm::dot(at.du, at.dv);
    const double c = glm::dot(at.dv, at.dv);
    const double determinant = a * c - b * b;
    if (determinant < 1e-9) return from;
    const double p = glm::dot(offset, at.du);
    const double q = glm::dot(offset, at.dv);
    const dvec2 moved = from + dvec2(c * p - b * q, a * q - b * p) / determinant;
    return glm::clamp(moved, dvec2(0.0), dvec2(1.0));
}

void lay_stem(const Patch& patch, const std::vector<dvec2>& line, double step, VesselTree& tree) {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        length += glm::distance(sample(patch, line[i].x, line[i].y).vertex.position,
                                sample(patch, line[i + 1].x, line[i + 1].y).vertex.position);
    }
    const int pieces = std::max(2, static_cast<int>(length / step));
    int parent = -1;
    for (int i = 0; i < pieces; ++i) {
        const dvec2 uv = along(line, static_cast<double>(i) / pieces);
        tree.push_back({uv, sample(patch, uv.x, uv.y).vertex.position, parent, 0.0});
        parent = static_cast<int>(tree.size()) - 1;
    }
}

std::vector<Demand> scatter(const Patch& patch, const Growth& growth, int count, Random& random) {
    std::vector<Demand> demands;
    for (int tries = 0; tries < count * 30 && static_cast<int>(demands.size()) < count; ++tries) {
        const dvec2 uv(random.next(), random.next());
        const double chance = random.next();
        const SurfacePoint at = sample(patch, uv.x, uv.y);
        if (growth.demand && growth.demand(at) <= chance) continue;
        demands.push_back({at.vertex.position, 1e9, -1, false});
    }
    return demands;
}

void look_at_new(const VesselTree& tree, std::size_t first, double satisfied, std::vector<Demand>& demands) {
    for (Demand& demand : demands) {
        if (demand.content) continue;
        for (std::size_t i = first; i < tree.size(); ++i) {
            const double distance = glm::distance(tree[i].position, demand.position);
            if (distance >= demand.distance) continue;
            demand.distance = distance;
            demand.nearest = static_cast<int>(i);
        }
        demand.content = demand.distance < satisfied;
    }
}

/// One step: every vessel node that is nearest to some points grows towards their mean. False: none grew.
bool extend(const Patch& patch, const Growth& growth, const std::vector<Demand>& demands, std::vector<int>& children,
            VesselTree& tree) {
    std::vector<dvec3> pull(tree.size(), dvec3(0.0));
    for (const Demand& demand : demands) {
        if (demand.content || demand.nearest < 0) continue;
        const std::size_t i = static_cast<std::size_t>(demand.nearest);
        pull[i] += (demand.position - tree[i].position) / demand.distance;
    }
    const std::size_t count = tree.size();
    children.resize(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        if (glm::length(pull[i]) < 0.05 || children[i] >= 2) continue;
        dvec3 direction = glm::normalize(pull[i]);
        if (tree[i].parent >= 0) {  // a vessel does not turn sharply
            const dvec3 onward = tree[i].position - tree[static_cast<std::size_t>(tree[i].parent)].position;
            if (glm::length(onward) > 1e-9) direction += 0.7 * glm::normalize(onward);
        }
        direction += 0.5 * perlin3(tree[i].position * 0.2, growth.seed + 5u);
        const dvec2 uv = move(patch, tree[i].uv, glm::normalize(direction) * growth.step);
        const dvec3 position = sample(patch, uv.x, uv.y).vertex.position;
        if (glm::distance(position, tree[i].position) < 0.3 * growth.step) continue;
        tree.push_back({uv, position, static_cast<int>(i), 0.0});
        children.push_back(0);
        ++children[i];
    }
    return tree.size() > count;
}

void find_radii(const Growth& growth, VesselTree& tree) {
    std::vector<double> cubes(tree.size(), 0.0);
    const double least = growth.capillary * growth.capillary * growth.capillary;
    for (std::size_t i = tree.size(); i-- > 0;) {
        cubes[i] = std::max(cubes[i], least);
        tree[i].radius = std::min(std::cbrt(cubes[i]), growth.thickest);
        if (tree[i].parent >= 0) cubes[static_cast<std::size_t>(tree[i].parent)] += cubes[i] * 0.995;
    }
}

void wind(const Patch& patch, const Growth& growth, VesselTree& tree) {
    for (int pass = 0; pass < 6; ++pass) {
        std::vector<dvec2> sum(tree.size(), dvec2(0.0));
        std::vector<int> count(tree.size(), 0);
        for (std::size_t i = 0; i < tree.size(); ++i) {
            if (tree[i].parent < 0) continue;
            const std::size_t parent = static_cast<std::size_t>(tree[i].parent);
            sum[i] += tree[parent].uv;
            sum[parent] += tree[i].uv;
            ++count[i];
            ++count[parent];
        }
        for (std::size_t i = 0; i < tree.size(); ++i) {
            if (count[i] >= 2) tree[i].uv = glm::mix(tree[i].uv, sum[i] / static_cast<double>(count[i]), 0.5);
        }
    }
    for (VesselNode& node : tree) {
        const dvec3 wander = growth.winding * (perlin3(node.position * 0.06, growth.seed + 31u) +
                                               0.30 * perlin3(node.position * 0.15, growth.seed + 47u));
        node.uv = move(patch, node.uv, wander);
        node.position = sample(patch, node.uv.x, node.uv.y).vertex.position;
    }
}

}  // namespace

VesselTree grow(const Patch& patch, const Growth& growth) {
    VesselTree tree;
    for (const std::vector<dvec2>& stem : growth.stems) lay_stem(patch, stem, growth.step, tree);
    Random random(growth.seed);
    std::vector<int> children(tree.size(), 1);
    int count = growth.demands;
    for (int wave = 0; wave < growth.waves; ++wave, count *= 3) {
        std::vector<Demand> demands = scatter(patch, growth, count, random);
        const double satisfied = growth.satisfied * (growth.waves - wave);
        std::size_t seen = 0;
        for (int round = 0; round < 150; ++round) {
            look_at_new(tree, seen, satisfied, demands);
            seen = tree.size();
            if (!extend(patch, growth, demands, children, tree) || tree.size() > 30000) break;
        }
    }
    find_radii(growth, tree);
    wind(patch, growth, tree);
    return tree;
}

}  // namespace organs
