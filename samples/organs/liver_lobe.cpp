// A single liver lobe, closed: two pillows that meet in a rim, sharp below and round above.
#include <cmath>

#include "canvas.h"
#include "curve.h"
#include "glb.h"
#include "models.h"
#include "tissue.h"

namespace organs {
namespace {

/// The rim as seen from the front, once round; `turn` 0..1.
dvec2 outline(double turn) {
    static const std::vector<dvec2> points = {{58, -26}, {64, 8},   {54, 38},   {20, 49},   {-22, 42},
                                              {-60, 26}, {-76, 4},  {-52, -13}, {-18, -26}, {18, -38},
                                              {42, -37}, {58, -26}, {64, 8},    {54, 38}};
    // One point before the start and two after the end make the loop smooth where it closes.
    return along(points, (1.0 + turn * 11.0) / 13.0);
}

/// `side` +1 front (domed), -1 back (hollow).
dvec3 lobe_point(double u, double v, double side) {
    const double a = side * (2.0 * u - 1.0);
    const double b = 1.0 - 2.0 * v;
    const dvec2 disc(a * std::sqrt(1.0 - b * b / 2.0), b * std::sqrt(1.0 - a * a / 2.0));
    const double r = std::min(glm::length(disc), 1.0);
    const double spread = std::sin(0.5 * pi * r) * 0.55 + r * 0.45;
    const double turn = r > 1e-9 ? std::atan2(disc.y, disc.x) / (2.0 * pi) : 0.0;
    const dvec2 rim = outline(turn - std::floor(turn));
    const double sharp = glm::mix(0.95, 0.52, ramp(-0.7, 0.7, disc.y));
    const double dome = std::pow(std::max(0.0, 1.0 - spread * spread), sharp);
    const double thick = 1.0 + 0.35 * disc.x;  // the lobe thins towards its tip
    const double front = 25.0 * dome * thick;
    const double back = -11.0 * dome * thick + 5.0 * std::exp(-4.0 * r * r) * dome;
    const double droop = -0.0022 * rim.x * rim.x * spread * spread;
    return {rim.x * spread, rim.y * spread + 6.0, (side > 0.0 ? front : back) + droop};
}

void share_rim(const Patch& front, Patch& back) {
    const int last = front.columns - 1;
    for (int row = 0; row <= last; ++row) {
        for (int column = 0; column <= last; ++column) {
            if (row % last != 0 && column % last != 0) continue;
            back.at(column, row).position = front.at(last - column, row).position;
            back.at(column, row).rest = front.at(last - column, row).rest;
            back.at(column, row).mask = front.at(last - column, row).mask;
        }
    }
}

Patch half(double side) {
    Patch patch = make_patch(71, 71, [&](double u, double v) { return lobe_point(u, v, side); });
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const double a = std::abs(2.0 * column / (patch.columns - 1.0) - 1.0);
            const double b = 2.0 * row / (patch.rows - 1.0) - 1.0;
            patch.at(column, row).mask = ramp(0.86, 1.0, std::max(a, std::abs(b))) * ramp(-0.6, 0.5, b);
        }
    }
    return patch;
}

}  // namespace

void make_liver_lobe(const std::filesystem::path& folder, int size) {
    Patch front = half(1.0);
    Patch back = half(-1.0);
    const double inset = 8.0 / size;
    front.uv_min = {inset, inset};
    front.uv_max = {1.0 - inset, 0.5 - inset};
    back.uv_min = {inset, 0.5 + inset};
    back.uv_max = {1.0 - inset, 1.0 - inset};
    share_rim(front, back);
    weld_normals({&front, &back});
    for (Patch* patch : {&front, &back}) {
        displace(*patch, [](const Vertex& at) {
            const dvec3& p = at.rest;
            return (1.0 - 0.7 * at.mask) * (5.0 * fbm(p * 0.016, 2, 221u) + 1.6 * fbm(p * 0.04, 3, 222u)) +
                   0.5 * fbm(p * 0.09, 2, 223u);
        });
    }
    share_rim(front, back);
    weld_normals({&front, &back});

    Surface surface;
    surface.name = "liver lobe";
    surface.roughness = 0.25;
    Canvas canvas(size);
    for (const Patch* patch : {&front, &back}) {
        append(surface.mesh, *patch);
        Growth growth;
        growth.stems = {{{0.5, 0.5}, {0.35, 0.45}, {0.2, 0.5}}, {{0.5, 0.5}, {0.62, 0.4}, {0.8, 0.45}}};
        growth.thickest = 0.28;
        growth.seed = 71;
        canvas.draw(*patch, grow(*patch, growth), {.vein = true, .raised = 0.2});
        canvas.paint(*patch, liver_tissue);
    }
    surface.color_jpeg = canvas.color_jpeg(84);
    surface.normal_jpeg = canvas.normal_jpeg(size / 2, 86);
    write_glb(folder / "liver_lobe.glb", "liver lobe", {surface});
}

}  // namespace organs
