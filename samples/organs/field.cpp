#include "field.h"

#include <cmath>

#include "curve.h"
#include "tissue.h"

namespace organs {

View field_view() {
    return view_from({0.0, 0.316, 0.949});
}

Patch stomach_shape() {
    // From behind the top of the fundus down the body into the antrum.
    const std::vector<dvec3> spine = {{58, 52, -66},   {55, 38, -50},   {50, 16, -32},
                                      {42, -10, -20},  {29, -38, -12},  {7, -64, -9},
                                      {-26, -84, -10}, {-64, -95, -18}, {-112, -98, -34}};
    const std::vector<dvec2> radius = {{22, 24}, {29, 31}, {35, 37}, {35, 38}, {32, 36},
                                       {28, 32}, {25, 27}, {22, 23}, {20, 20}};
    const dvec3 eye = field_view().toward;
    Patch patch = make_patch(104, 84, [&](double u, double v) {
        const dvec3 centre = along(spine, v);
        const dvec3 axis =
            glm::normalize(along(spine, std::min(v + 0.01, 1.0)) - along(spine, std::max(v - 0.01, 0.0)));
        const dvec3 front = glm::normalize(eye - axis * glm::dot(eye, axis));
        const dvec3 side = glm::cross(front, axis);
        const dvec2 size =
            along(radius, v) * std::sqrt(clamp01(1.0 - std::pow(1.0 - std::min(v / 0.24, 1.0), 2.0)));
        const double angle = (u - 0.5) * 2.0 * 2.25;
        return centre + front * (size.x * std::cos(angle)) + side * (size.y * std::sin(angle));
    });
    relax(patch, 6);
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        const double swell = 7.0 * fbm(p * 0.017, 2, 101u);
        const double dents = 2.2 * fbm(p * 0.05, 3, 102u);
        const double folds =
            -2.4 *
            std::pow(
                ridges(dvec3(p.x * 0.012, p.y * 0.030, p.z * 0.012) + 0.3 * perlin3(p * 0.02, 103u), 1, 104u),
                3.0);
        return swell + dents + folds;
    });
    return patch;
}

Patch liver_edge_shape() {
    const std::vector<dvec3> edge = {{-150, -60, 6}, {-118, -36, 18}, {-84, -14, 26},
                                     {-48, 6, 26},   {-12, 24, 18},   {26, 43, 2},
                                     {62, 60, -20},  {98, 70, -44},   {130, 76, -64}};
    // Across: x up from the edge, y towards the eye; from the top of the front over the sharp edge to the
    // underside.
    const std::vector<dvec2> section = {{150, -20}, {120, 12}, {88, 26},   {58, 28}, {34, 24},
                                        {16, 16},   {6, 8.5},  {1.2, 3.2}, {0, 0},   {1.4, -3.4},
                                        {6, -12},   {15, -30}, {26, -52},  {36, -78}};
    const dvec3 eye = field_view().toward;
    Patch patch = make_patch(80, 66, [&](double u, double v) {
        const dvec3 on = along(edge, u);
        const dvec3 run =
            glm::normalize(along(edge, std::min(u + 0.02, 1.0)) - along(edge, std::max(u - 0.02, 0.0)));
        const dvec3 front = glm::normalize(eye - run * glm::dot(eye, run));
        const dvec3 up = glm::cross(front, run);
        const dvec2 across = along(section, v);
        const double thin = 1.0 - 0.45 * ramp(0.55, 1.0, u);
        return on + up * across.x + front * (across.y * thin);
    });
    displace(patch, [](const Vertex& at) {
        return 4.0 * fbm(at.rest * 0.014, 2, 121u) + 0.9 * fbm(at.rest * 0.06, 3, 122u);
    });
    return patch;
}

Patch lesser_omentum_shape() {
    // x of the stomach's lesser curvature (some way inside it) at heights y.
    const std::vector<double> curvature = {46, 44, 40, 34, 28, 24, 20, 12, -6, -40, -74};
    Patch patch = make_patch(84, 72, [&](double u, double v) {
        const double y = 82.0 - 178.0 * v;
        const double right = along(curvature, v);
        const double x = glm::mix(-135.0, right, u);
        const double from_right = right - x;
        const double taut = -16.0 - 0.02 * from_right * ramp(0.0, 60.0, from_right);
        const double sag =
            -24.0 * std::sin(pi * clamp01(from_right / 150.0)) * (0.6 + 0.4 * std::sin(pi * v));
        // The oesophagus lifts the membrane on its way to the hiatus.
        const double off = x - (6.0 - 0.34 * (y - 10.0));
        const double gullet = 13.0 * std::exp(-off * off / 120.0) * ramp(-14.0, 16.0, y);
        const double back = -0.35 * std::max(0.0, y - 18.0) - 0.18 * std::max(0.0, -y - 50.0);
        return dvec3(x, y, taut + sag + gullet + back);
    });
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        const dvec3 pulled =
            dvec3(p.x * 0.016 + p.y * 0.010, p.y * 0.060 - p.x * 0.026, 0.0) + 0.5 * perlin3(p * 0.02, 131u);
        return 3.2 * fbm(p * 0.03, 3, 132u) + 2.6 * (ridges(pulled, 2, 133u) - 0.4);
    });
    for (Vertex& vertex : patch.vertices) {
        const dvec3& p = vertex.rest;
        const double t = clamp01((82.0 - p.y) / 178.0);
        const double from_right = along(curvature, t) - p.x;
        vertex.mask = clamp01(0.85 * (1.0 - ramp(26.0, 62.0, from_right)) + 0.30 * fbm(p * 0.03, 3, 134u) +
                              0.45 * ramp(88.0, 130.0, from_right));
    }
    return patch;
}

Patch wall_shape() {
    Patch patch = make_patch(56, 56, [](double u, double v) {
        const double a = 2.0 * u - 1.0;
        const double b = 2.0 * v - 1.0;
        const dvec2 disc(a * std::sqrt(1.0 - b * b / 2.0), -b * std::sqrt(1.0 - a * a / 2.0));
        const double r = glm::length(disc);
        const double polar = 2.25 * r;
        const dvec2 around = r > 1e-9 ? disc / r : dvec2(0.0);
        return dvec3(155.0 * std::sin(polar) * around.x, 122.0 * std::sin(polar) * around.y,
                     8.0 - 122.0 * std::cos(polar));
    });
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        const double muscle = ridges(dvec3(p.x * 0.025, p.y * 0.010, p.z * 0.012), 2, 141u);
        return 9.0 * fbm(p * 0.012, 3, 142u) + 5.0 * muscle + 2.0 * fbm(p * 0.05, 2, 143u);
    });
    for (Vertex& vertex : patch.vertices) {
        vertex.mask = ramp(95.0, 30.0, glm::length(dvec2(vertex.rest.x, vertex.rest.y - 35.0)));
    }
    return patch;
}

namespace {

struct Blanket {
    double thickness = 0.0;  ///< below zero: under the tissue that it lies on
    double fullness = 0.0;   ///< 0 at the rim to 1: how far its lobules swell
};

/// Lays fat of the given thickness on what is below, lets its lobules swell, and hides what is covered.
Patch lay_fat(const HeightMap& under, const dvec2& low, const dvec2& high, int columns, int rows,
              const std::function<Blanket(const dvec2&)>& blanket) {
    const auto plane = [&](double u, double v) {
        return dvec2(glm::mix(low.x, high.x, u), glm::mix(high.y, low.y, v));
    };
    Patch patch = make_patch(columns, rows, [&](double u, double v) {
        const dvec2 xy = plane(u, v);
        return under.view().place(xy, under.at(xy));
    });
    patch.hidden.resize(patch.vertices.size());
    std::vector<double> thickness;
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
        const int column = static_cast<int>(i) % columns;
        const int row = static_cast<int>(i) / columns;
        const Blanket here = blanket(
            plane(static_cast<double>(column) / (columns - 1), static_cast<double>(row) / (rows - 1)));
        const dvec3& p = patch.vertices[i].rest;
        const double large = lobules(p, 24.0, 151u).height;
        const double middle = lobules(p, 11.0, 401u).height;
        thickness.push_back(here.thickness + here.fullness * (7.0 * (large - 0.45) + 3.6 * (middle - 0.45)));
        patch.hidden[i] = thickness.back() < -1.2;
    }
    std::size_t next = 0;
    displace(patch, [&](const Vertex&) { return std::max(thickness[next++], -4.0); });
    return patch;
}

}  // namespace

Patch apron_shape(const HeightMap& under) {
    const std::vector<dvec2> rim = {{128, 62}, {100, 44}, {84, 20},   {72, -6},    {58, -34},
                                    {34, -58}, {0, -78},  {-44, -92}, {-128, -104}};
    return lay_fat(under, {-128, -128}, {132, 66}, 128, 96, [&](const dvec2& xy) {
        const dvec3 p(xy, 0.0);
        const double inside = -beside_line(rim, xy) + 7.0 * fbm(p * 0.035, 3, 152u);
        return Blanket{-5.0 + 15.0 * ramp(-4.0, 26.0, inside) + 4.0 * fbm(p * 0.03, 2, 153u),
                       ramp(-2.0, 16.0, inside)};
    });
}

Patch cardia_fat_shape(const HeightMap& under) {
    const std::vector<dvec2> line = {{20, 44}, {14, 28}, {6, 12}, {4, -8}, {0, -30}, {-14, -52}, {-44, -72}};
    return lay_fat(under, {-72, -92}, {56, 64}, 86, 104, [&](const dvec2& xy) {
        const dvec3 p(xy, 0.0);
        double where = 0.0;
        const double off = std::abs(beside_line(line, xy, &where));
        const double width = glm::mix(19.0, 9.0, ramp(0.15, 0.75, where)) + 5.0 * fbm(p * 0.04, 3, 161u);
        const double inside = width - off - 12.0 * ramp(0.93, 1.0, where);
        return Blanket{-4.0 + 11.0 * ramp(-3.0, 15.0, inside), ramp(-2.0, 12.0, inside)};
    });
}

}  // namespace organs
