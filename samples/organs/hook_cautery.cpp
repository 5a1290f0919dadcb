// A monopolar L-hook: the tip of the hook at the origin, the shaft along +z.
#include <cmath>

#include "curve.h"
#include "glb.h"
#include "models.h"

namespace organs {
namespace {

/// One ring of a swept part: its centre and half widths, across and along the hook's bend.
struct Ring {
    dvec3 centre{0.0};
    dvec2 half{1.0};
};

/// Sweeps rounded sections along a line in the plane x = 0.
Patch sweep(const std::vector<Ring>& rings, int around) {
    std::vector<dvec3> centres;
    for (const Ring& ring : rings) centres.push_back(ring.centre);
    const int rows = static_cast<int>(rings.size());
    Patch patch = make_patch(around + 1, rows, [&](double u, double v) {
        const std::size_t i = static_cast<std::size_t>(std::lround(v * (rows - 1)));
        const dvec3 before = centres[i == 0 ? 0 : i - 1];
        const dvec3 after = centres[std::min(i + 1, centres.size() - 1)];
        const dvec3 step = after - before;
        const dvec3 run = glm::length(step) > 1e-9 ? glm::normalize(step) : dvec3(0.0, 0.0, 1.0);
        const dvec3 across(1.0, 0.0, 0.0);
        const dvec3 up = glm::cross(run, across);
        const double angle = -2.0 * pi * u;
        return rings[i].centre + across * (rings[i].half.x * std::cos(angle)) +
               up * (rings[i].half.y * std::sin(angle));
    });
    for (int row = 0; row < rows; ++row) {  // the seam shares its normal
        const dvec3 normal = patch.at(0, row).normal + patch.at(around, row).normal;
        patch.at(0, row).normal = patch.at(around, row).normal = glm::normalize(normal);
        patch.at(around, row).position = patch.at(0, row).position;
    }
    return patch;
}

constexpr double axis_height = 4.6;  // of the shaft above the tip, mm

/// Round parts on the shaft's axis; edges are given as close pairs of rings.
Surface turned(const std::string& name, const std::vector<dvec2>& profile, const dvec3& color, double roughness) {
    std::vector<Ring> rings;
    for (const dvec2& at : profile) rings.push_back({{0.0, axis_height, at.x}, dvec2(at.y)});
    Surface surface;
    surface.name = name;
    surface.color = color;
    surface.roughness = roughness;
    append(surface.mesh, sweep(rings, 32));
    return surface;
}

Surface hook() {
    // From the tip up, round the bend, and back along the shaft into the collar.
    const std::vector<dvec3> line = {{0, 0.0, 0},   {0, 0.15, 0},  {0, 0.5, 0},   {0, 1.2, 0},
                                     {0, 2.2, 0.0}, {0, 3.2, 0.0}, {0, 4.1, 0.3}, {0, 4.55, 1.2},
                                     {0, 4.6, 2.4}, {0, 4.6, 4.5}, {0, 4.6, 7.0}, {0, 4.6, 9.5}};
    const std::vector<dvec2> half = {{0.02, 0.02}, {0.24, 0.26}, {0.36, 0.40}, {0.42, 0.48},
                                     {0.46, 0.52}, {0.50, 0.56}, {0.55, 0.60}, {0.60, 0.62},
                                     {0.64, 0.64}, {0.66, 0.66}, {0.68, 0.68}, {0.70, 0.70}};
    std::vector<Ring> rings;
    constexpr int count = 56;
    for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count;
        rings.push_back({along(line, t), along(half, t)});
    }
    Surface surface;
    surface.name = "hook";
    surface.color = {0.52, 0.51, 0.50};
    surface.roughness = 0.32;
    surface.metallic = 0.9;
    Patch patch = sweep(rings, 20);
    for (Vertex& vertex : patch.vertices) {  // the tip is burnt
        vertex.light =
            glm::mix(0.35, 1.0, ramp(0.2, 3.4, vertex.position.y + 0.5 * fbm(vertex.position * 1.5, 2, 231u)));
    }
    append(surface.mesh, patch);
    return surface;
}

}  // namespace

void make_hook_cautery(const std::filesystem::path& folder) {
    const std::vector<dvec2> collar = {{7.6, 0.02},  {7.6, 0.7},   {7.62, 1.2},  {7.75, 1.32}, {9.0, 1.5},
                                       {11.0, 1.85}, {13.0, 2.12}, {14.6, 2.24}, {15.0, 2.2},  {15.02, 1.9}};
    std::vector<dvec2> shaft = {{14.4, 1.5}, {14.4, 2.36}, {14.5, 2.46}, {14.7, 2.5}, {16.0, 2.5}};
    for (int i = 1; i <= 24; ++i) shaft.push_back({16.0 + 11.7 * i, 2.5});
    shaft.push_back({299.8, 2.5});
    shaft.push_back({300.0, 2.4});
    shaft.push_back({300.0, 0.02});
    write_glb(folder / "hook_cautery.glb", "hook cautery",
              {hook(), turned("collar", collar, {0.80, 0.78, 0.72}, 0.35),
               turned("shaft", shaft, {0.022, 0.022, 0.024}, 0.42)});
}

}  // namespace organs
