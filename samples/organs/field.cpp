#include "field.h"

#include <cmath>

#include "curve.h"
#include "tissue.h"

namespace organs {

View field_view() {
    return view_from({0.0, 0.316, 0.949});
}

namespace {

constexpr dvec3 wall_centre(0.0, 0.0, 8.0);
constexpr dvec3 wall_size(180.0, 145.0, 128.0);

/// How far a point of the field's plane is inside the rim of the greater omentum, mm.
double inside_apron(const dvec2& xy) {
    static const std::vector<dvec2> rim = {{178, 96},  {128, 74},   {103, 50},  {88, 22},   {77, -6},
                                           {62, -34},  {36, -60},   {0, -80},   {-40, -94}, {-78, -90},
                                           {-98, -68}, {-116, -42}, {-190, -22}};
    return -beside_line(rim, xy) + 8.0 * fbm(dvec3(xy, 0.0) * 0.035, 3, 152u);
}

/// The same for the fat pad at the angle of His and the fat that runs from it down the lesser curvature.
double inside_cardia_fat(const dvec2& xy) {
    static const std::vector<dvec2> line = {{16, 52},   {13, 32},   {6, 14},    {-1, -6},
                                            {-10, -28}, {-30, -47}, {-64, -59}, {-112, -62}};
    double where = 0.0;
    const double off = std::abs(beside_line(line, xy, &where));
    const double width = glm::mix(20.0, 10.0, ramp(0.15, 0.7, where)) + 6.0 * fbm(dvec3(xy, 3.0) * 0.045, 3, 161u);
    return width - off - 12.0 * ramp(0.95, 1.0, where);
}

dvec2 in_plane(const dvec3& p) {
    const dvec3 seen = field_view().seen(p);
    return {seen.x, seen.y};
}

}  // namespace

Patch stomach_shape() {
    // From behind the top of the fundus down the body into the antrum.
    const std::vector<dvec3> spine = {{60, 54, -68},    {57, 40, -52},   {51, 16, -33},   {42, -10, -20},
                                      {29, -38, -12},   {7, -64, -9},    {-26, -84, -10}, {-68, -95, -18},
                                      {-118, -98, -32}, {-180, -96, -46}};
    const std::vector<dvec2> radius = {{22, 25}, {30, 33}, {36, 38}, {35, 37}, {31, 36},
                                       {28, 32}, {26, 28}, {23, 24}, {22, 22}, {22, 22}};
    const dvec3 eye = field_view().toward;
    Patch patch = make_patch(96, 82, [&](double u, double v) {
        const dvec3 centre = along(spine, v);
        const dvec3 axis =
            glm::normalize(along(spine, std::min(v + 0.01, 1.0)) - along(spine, std::max(v - 0.01, 0.0)));
        const dvec3 front = glm::normalize(eye - axis * glm::dot(eye, axis));
        const dvec3 side = glm::cross(front, axis);
        const dvec2 size = along(radius, v) * std::sqrt(clamp01(1.0 - std::pow(1.0 - std::min(v / 0.22, 1.0), 2.0)));
        const double angle = (u - 0.5) * 2.0 * 2.25;
        return centre + front * (size.x * std::cos(angle)) + side * (size.y * std::sin(angle));
    });
    relax(patch, 6);
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        const double swell = 9.0 * fbm(p * 0.016, 2, 101u);
        const double dents = 3.0 * fbm(p * 0.045, 3, 102u);
        // Slack folds run along the body, deepest near the fundus.
        const dvec3 bent = dvec3(p.x * 0.030 + p.y * 0.006, p.y * 0.009, p.z * 0.012) + 0.35 * perlin3(p * 0.018, 103u);
        const double fold = std::pow(ridges(bent, 1, 104u), 4.0);
        return swell + dents - 4.5 * fold;
    });
    for (Vertex& vertex : patch.vertices) {
        const dvec2 xy = in_plane(vertex.position);
        vertex.mask = ramp(-11.0, 3.0, std::max(inside_apron(xy), inside_cardia_fat(xy)));
    }
    return patch;
}

Patch liver_edge_shape() {
    const std::vector<dvec3> edge = {{-190, -62, -26}, {-150, -46, -6}, {-114, -28, 6}, {-82, -8, 13}, {-50, 12, 12},
                                     {-14, 26, 8},     {22, 48, -6},    {60, 66, -26},  {98, 76, -50}, {140, 86, -80}};
    // Across: x up from the edge, y towards the eye; from the top of the front over the sharp edge to the
    // underside.
    const std::vector<dvec2> section = {{150, -44}, {118, -14}, {88, 4},    {58, 13}, {34, 14.5},
                                        {16, 11},   {6, 6.5},   {1.2, 2.6}, {0, 0},   {1.4, -3.4},
                                        {6, -12},   {15, -30},  {26, -52},  {36, -78}};
    const dvec3 eye = field_view().toward;
    Patch patch = make_patch(78, 56, [&](double u, double v) {
        const dvec3 on = along(edge, u);
        const dvec3 run = glm::normalize(along(edge, std::min(u + 0.02, 1.0)) - along(edge, std::max(u - 0.02, 0.0)));
        const dvec3 front = glm::normalize(eye - run * glm::dot(eye, run));
        const dvec3 up = glm::cross(front, run);
        const dvec2 across = along(section, v);
        const double thin = 1.0 - 0.45 * ramp(0.55, 1.0, u);
        const double wave = 2.5 * perlin(dvec3(u * 9.0, 0.0, 0.5), 120u);
        return on + up * (across.x + wave) + front * (across.y * thin);
    });
    for (int row = 0; row < patch.rows; ++row) {
        const double across = along(section, static_cast<double>(row) / (patch.rows - 1)).x;
        for (int column = 0; column < patch.columns; ++column) patch.at(column, row).mask = ramp(11.0, 0.0, across);
    }
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        const double slack = 1.0 - 0.8 * at.mask;
        return slack * (7.0 * fbm(p * 0.013, 2, 121u) + 3.0 * fbm(p * 0.035, 2, 123u)) + 0.8 * fbm(p * 0.07, 3, 122u);
    });
    return patch;
}

Patch lesser_omentum_shape() {
    // x of the stomach's lesser curvature (some way inside it) at heights y from 84 down to -110.
    const std::vector<double> curvature = {96, 84, 56, 36, 28, 22, 16, 8, -10, -50, -100};
    Patch patch = make_patch(74, 64, [&](double u, double v) {
        const double y = 84.0 - 194.0 * v;
        const double right = along(curvature, v);
        const double x = glm::mix(-185.0, right, u);
        const double from_right = right - x;
        const double taut = -15.0 - 0.02 * from_right * ramp(0.0, 60.0, from_right);
        const double sag = -25.0 * std::sin(pi * clamp01(from_right / 170.0)) * (0.6 + 0.4 * std::sin(pi * v));
        // The oesophagus lifts the membrane on its way to the hiatus.
        const double off = x - (6.0 - 0.34 * (y - 10.0));
        const double gullet = 13.0 * std::exp(-off * off / 120.0) * ramp(-14.0, 16.0, y);
        const double back = -0.35 * std::max(0.0, y - 18.0) - 0.95 * std::max(0.0, x - 22.0) * ramp(24.0, 60.0, y) -
                            0.18 * std::max(0.0, -y - 50.0);
        return dvec3(x, y, taut + sag + gullet + back);
    });
    displace(patch, [](const Vertex& at) {
        const dvec3& p = at.rest;
        // Folds run from the stomach up to the liver, as in a sheet that is pulled at both ends.
        const dvec3 pulled =
            dvec3(p.x * 0.012 + p.y * 0.012, p.y * 0.050 - p.x * 0.030, 0.0) + 0.45 * perlin3(p * 0.02, 131u);
        return 3.4 * fbm(p * 0.03, 3, 132u) + 6.5 * (ridges(pulled, 2, 133u) - 0.4);
    });
    for (Vertex& vertex : patch.vertices) {
        const dvec3& p = vertex.rest;
        const double t = clamp01((84.0 - p.y) / 194.0);
        const double from_right = along(curvature, t) - p.x;
        vertex.mask = clamp01(0.95 * (1.0 - ramp(26.0, 70.0, from_right)) + 0.45 * fbm(p * 0.03, 3, 134u) +
                              0.55 * ramp(88.0, 140.0, from_right) - 1.2 * ramp(24.0, 50.0, p.y));
    }
    return patch;
}

Patch wall_shape() {
    Patch patch = make_patch(48, 48, [](double u, double v) {
        const double a = 2.0 * u - 1.0;
        const double b = 2.0 * v - 1.0;
        const dvec2 disc(a * std::sqrt(1.0 - b * b / 2.0), -b * std::sqrt(1.0 - a * a / 2.0));
        const double r = glm::length(disc);
        const double polar = 2.25 * r;
        const dvec2 around = r > 1e-9 ? disc / r : dvec2(0.0);
        return wall_centre + wall_size * dvec3(std::sin(polar) * around, -std::cos(polar));
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

/// Puts fat on the tissue below: `thickness` (mm, below zero where it ends) over the field's plane, with lobules.
Patch lay_fat(const Ground& ground, const dvec2& low, const dvec2& high, int columns, int rows,
              const std::function<double(const dvec2&)>& inside, double full, double rise) {
    Patch patch = make_patch(columns, rows, [&](double u, double v) {
        const dvec2 xy(glm::mix(low.x, high.x, u), glm::mix(high.y, low.y, v));
        // At its rim fat follows the tissue; farther inside it bridges the hollows.
        const double bridging = ramp(-2.0, rise, inside(xy));
        return field_view().place(xy, glm::mix(ground.bare.at(xy), ground.bridged.at(xy), bridging));
    });
    patch.hidden.resize(patch.vertices.size());
    std::vector<double> thickness;
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
        Vertex& vertex = patch.vertices[i];
        const double depth = inside(in_plane(vertex.rest));
        const double fullness = ramp(-2.0, 0.7 * rise, depth);
        const double large = lobules(vertex.rest, 25.0, 151u).height;
        const double middle = lobules(vertex.rest, 11.5, 401u).height;
        const double swell = 7.0 * (large - 0.45) + 5.0 * (middle - 0.45) +
                             1.3 * (lobules(vertex.rest, 5.5, 402u).height - 0.45) +
                             4.0 * fbm(vertex.rest * 0.03, 2, 153u);
        thickness.push_back(-4.5 + (full + 4.5) * ramp(-4.0, rise, depth) + fullness * swell);
        vertex.mask = ramp(-1.0, 0.5 * full, thickness.back());
    }
    std::size_t next = 0;
    // Leans towards the eye, because normals meet in a hollow and lobules would run into each other.
    for (Vertex& vertex : patch.vertices) {
        const dvec3 out = glm::normalize(vertex.normal + 1.1 * field_view().toward);
        vertex.position += out * std::max(thickness[next++], -5.0);
    }
    relax(patch, 2);
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
        const dvec3 seen = field_view().seen(patch.vertices[i].position);
        const dvec3 in_wall = (patch.vertices[i].position - wall_centre) / wall_size;
        patch.hidden[i] = seen.z < ground.bare.at({seen.x, seen.y}) - 1.5 || glm::length(in_wall) > 1.1;
    }
    hide_islands(patch);
    return patch;
}

}  // namespace

Patch bed_shape() {
    return make_patch(60, 60, [](double u, double v) {
        const dvec2 xy(glm::mix(-215.0, 215.0, u), glm::mix(215.0, -215.0, v));
        const double back = 1.5 * std::max(0.0, xy.y - 42.0) + 0.15 * std::max(0.0, -xy.x - 60.0);
        return field_view().place(xy, -50.0 - back + 9.0 * fbm(dvec3(xy * 0.014, 0.0), 2, 171u));
    });
}

Patch apron_shape(const Ground& ground) {
    return lay_fat(ground, {-170, -150}, {196, 112}, 140, 104, inside_apron, 10.0, 26.0);
}

Patch cardia_fat_shape(const Ground& ground) {
    return lay_fat(ground, {-112, -98}, {54, 72}, 138, 142, inside_cardia_fat, 7.0, 15.0);
}

Patch ligament_shape(const Ground& ground) {
    // In the field's plane, from under the liver's edge to under the fat of the lesser curvature; half its width there.
    const std::vector<dvec2> middle = {{-66, 27}, {-53, 15}, {-40, 5}, {-26, -3}, {-12, -8}, {2, -11}};
    const std::vector<double> half = {17, 13.5, 11, 10, 11, 12.5};
    Patch patch = make_patch(96, 44, [&](double u, double v) {
        const dvec2 run =
            glm::normalize(along(middle, std::min(u + 0.02, 1.0)) - along(middle, std::max(u - 0.02, 0.0)));
        const dvec2 down(run.y, -run.x);
        const double across = 2.0 * v - 1.0;
        const double ragged = 1.0 + 0.16 * fbm(dvec3(u * 7.0, across > 0.0 ? 3.0 : 0.0, 0.5), 3, 181u);
        const dvec2 xy = along(middle, u) + down * (across * along(half, u) * ragged);
        // At its rim it goes over into the membrane; in between it is taut.
        const double firm = 1.0 - std::pow(std::abs(across), 2.5);
        const double over = glm::mix(ground.bare.at(xy) - 1.5, ground.bridged.at(xy) + 2.0, firm);
        return field_view().place(xy, over);
    });
    for (int row = 0; row < patch.rows; ++row) {
        const double across = 2.0 * row / (patch.rows - 1) - 1.0;
        for (int column = 0; column < patch.columns; ++column)
            patch.at(column, row).mask = ramp(1.0, 0.55, std::abs(across));
    }
    relax(patch, 4);
    // Strands under tension run along it.
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            Vertex& vertex = patch.at(column, row);
            const dvec3 strand(2.2 * column / patch.columns, 6.0 * row / patch.rows, 0.0);
            const double height = 2.2 * (ridges(strand, 2, 182u) - 0.5) + 1.2 * fbm(vertex.rest * 0.06, 3, 183u);
            vertex.position += vertex.normal * (vertex.mask * height);
        }
    }
    update_normals(patch);
    return patch;
}

}  // namespace organs
