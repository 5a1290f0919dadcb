// report(): what `lapfx inspect` says about an organ.
#include <cstdio>
#include <numeric>

#include "lapfx/authoring/organ_report.h"
#include "organ/refine.h"
#include "organ/weld.h"

namespace lapfx {

namespace {

/// Units that files use, as factors.
constexpr double factors[] = {1000.0, 100.0, 25.4, 10.0, 0.1, 0.01, 0.001};

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}

std::size_t count_components(const std::vector<std::uint32_t>& triangles, std::uint32_t points) {
    std::vector<std::uint32_t> parent(points);
    std::iota(parent.begin(), parent.end(), 0u);
    std::size_t components = points;
    const auto unite = [&](std::uint32_t a, std::uint32_t b) {
        a = root(parent, a);
        b = root(parent, b);
        if (a == b) return;
        parent[std::max(a, b)] = std::min(a, b);
        --components;
    };
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        unite(triangles[i], triangles[i + 1]);
        unite(triangles[i], triangles[i + 2]);
    }
    return components;
}

void count_edges(const std::vector<std::uint32_t>& triangles, OrganReport& report) {
    std::vector<std::uint64_t> edges;
    edges.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint64_t a = triangles[i + c], b = triangles[i + (c + 1) % 3];
            edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        report.boundary_edges += end - i == 1;
        report.non_manifold_edges += end - i > 2;
        i = end;
    }
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// A unit mistake is the most common fault of a mesh; the factor that brings it nearest to the size of a
/// liver.
std::string size_warning(double longest, double scale) {
    if (longest >= shortest_organ && longest <= longest_organ) return {};
    double best = factors[0];
    const auto distance = [&](double factor) { return std::abs(std::log(longest * factor / 200.0)); };
    for (const double factor : factors)
        if (distance(factor) < distance(best)) best = factor;
    const bool fits = longest * best >= shortest_organ && longest * best <= longest_organ;
    return "its longest side is " + number(longest) + " mm, which is unusual for an organ (" + number(shortest_organ) +
           " to " + number(longest_organ) + " mm)" +
           (fits ? "; is the unit wrong? scale " + number(scale * best) + " would make it " + number(longest * best) +
                       " mm"
                 : "");
}

}  // namespace

OrganReport report(const Organ& organ) {
    OrganReport report;
    report.vertices = organ.positions.size();
    report.triangles = organ.triangle_count();
    report.warnings = organ.warnings;
    if (organ.positions.empty()) return report;
    report.minimum = report.maximum = glm::dvec3(organ.positions.front());
    for (const glm::vec3& p : organ.positions) {
        report.minimum = glm::min(report.minimum, glm::dvec3(p));
        report.maximum = glm::max(report.maximum, glm::dvec3(p));
    }
    const organ::RefinePlan plan = organ::plan_refine(organ);
    if (plan.is_told())
        report.warnings.push_back(
            "its triangles are too many and too large to split all edges down to " + number(organ::longest_wanted) +
            " mm: on half of it, blood and burns can be no finer than edges of " + number(plan.usual) + " mm");
    const organ::Weld weld = organ::weld_surface(organ.positions, organ.indices);
    std::vector<std::uint32_t> triangles(organ.indices.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = weld.point[organ.indices[i]];
    report.components = count_components(triangles, weld.points);
    count_edges(triangles, report);
    const glm::dvec3 size = report.maximum - report.minimum;
    const std::string warning = size_warning(std::max({size.x, size.y, size.z}), organ.scale);
    if (!warning.empty()) report.warnings.push_back(warning);
    return report;
}

}  // namespace lapfx
