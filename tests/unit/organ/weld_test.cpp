// Which vertices are one point of the surface.
#include "organ/weld.h"

#include <random>

#include "bleeding/bleed_cpu.h"
#include "lapfx/authoring/organ_report.h"
#include "organ/surface.h"
#include "support/meshes.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

/// Adds `from` to `to`, with separate vertices.
void add(Organ& to, const Organ& from, const glm::vec3& by = glm::vec3(0.0f)) {
    const auto base = static_cast<std::uint32_t>(to.positions.size());
    for (const glm::vec3& p : from.positions) to.positions.push_back(p + by);
    for (const std::uint32_t i : from.indices) to.indices.push_back(base + i);
}

/// plane(side, n) in two halves without common vertices: those of the right half on the seam x = 0 are `gap` mm to
/// either side of it. Both ends of the seam are intact, so that it is one component, and nothing is bridged.
Organ torn_plane(double side, std::uint32_t n, double gap) {
    const Organ whole = plane(side, n);
    Organ torn;
    torn.positions = whole.positions;
    for (glm::vec3 p : whole.positions) {
        if (p.x == 0.0f && std::abs(p.z) < 0.45 * side)
            p.x = static_cast<float>((torn.positions.size() % 2 != 0 ? gap : -gap));
        torn.positions.push_back(p);
    }
    const auto count = static_cast<std::uint32_t>(whole.positions.size());
    for (std::size_t i = 0; i < whole.indices.size(); i += 3) {
        float x = 0.0f;
        for (std::size_t c = 0; c < 3; ++c) x += whole.positions[whole.indices[i + c]].x;
        for (std::size_t c = 0; c < 3; ++c) torn.indices.push_back(whole.indices[i + c] + (x > 0.0f ? count : 0));
    }
    return drawable(std::move(torn), std::vector<glm::vec3>(2 * count, glm::vec3(0.0f, 1.0f, 0.0f)));
}

/// mm2 of blood after 6 s: speed 4 mm/s to 16 mm, from a place next to the seam.
double bled_area(const Organ& organ, double scale) {
    const Surface surface(organ);
    BleedingParameters b;
    b.speed = 4.0 * scale;
    b.max_extent = 16.0 * scale;
    b.threshold = b.noise_strength = 0.0;
    b.gravity_bias = b.crease_bias = 0.0;
    bleeding::BleedField field(surface, {0.0, -1.0, 0.0});
    field.set(std::vector<Wound>{{.position = glm::dvec3(-0.33, 0.0, 0.4) * scale}}, b);
    field.update(6.0);
    return field.amount().area;
}

/// Points that were joined although they are apart.
std::uint32_t sewn(const Organ& organ) {
    return organ::weld_surface(organ.positions, organ.indices).sewn;
}

TEST(Weld, BloodCrossesASeamThatRoundingTore) {
    for (const double scale : {1.0, 0.1, 100.0}) {
        const double whole = bled_area(plane(60.0 * scale, 60), scale);
        EXPECT_GT(whole, 780.0 * scale * scale);
        for (const double gap : {0.0, 2e-17, 1e-6, 0.004})
            EXPECT_NEAR(bled_area(torn_plane(60.0 * scale, 60, gap * scale), scale), whole, 0.001 * whole)
                << scale << ", " << gap;
    }
}

TEST(Weld, SeamsCountOncePerPlaceThatMoved) {
    const Organ organ = torn_plane(60.0, 60, 1e-6);
    const organ::Weld weld = organ::weld_surface(organ.positions, organ.indices);
    EXPECT_EQ(weld.sewn, 53u);  // those between -26 and 26 mm, once each; of the copies that no triangle uses none
    EXPECT_NEAR(weld.gap, 1e-6, 1e-9);
    const OrganReport r = report(organ);
    EXPECT_EQ(r.boundary_edges, 240u);
    EXPECT_EQ(r.non_manifold_edges, 0u);
}

TEST(Weld, RoundingFarFromTheOriginIsSewn) {
    Organ organ = plane(2.0, 20);  // halves that float arithmetic has moved differently
    for (glm::vec3& p : organ.positions) p = (p + glm::vec3(800.0f, -700.0f, 900.0f));
    Organ torn = torn_plane(2.0, 20, 0.0);
    std::mt19937 random(3);
    for (glm::vec3& p : torn.positions) {
        p += glm::vec3(800.0f, -700.0f, 900.0f);
        for (int axis = 0; axis < 3; ++axis)
            if (random() % 2 == 0) p[axis] = std::nextafter(p[axis], 1e9f);
    }
    EXPECT_EQ(report(torn).boundary_edges, report(organ).boundary_edges);
}

TEST(Weld, SheetsThatLieOnOneAnotherStayApart) {
    for (const float gap : {1e-6f, 1e-3f, 0.005f}) {
        Organ back = plane(20.0, 20);  // facing down
        for (std::size_t i = 0; i < back.indices.size(); i += 3) std::swap(back.indices[i], back.indices[i + 1]);
        for (const bool turned : {false, true}) {
            Organ organ = plane(20.0, 20);
            add(organ, turned ? back : plane(20.0, 20), glm::vec3(0.0f, -gap, 0.0f));
            EXPECT_EQ(sewn(organ), 0u) << gap << (turned ? ", back to back" : "");
        }
    }
}

TEST(Weld, WhatOnlyComesNearStaysApart) {
    Organ beside = plane(20.0, 20);  // a slit as wide as 3 % of an edge
    add(beside, plane(20.0, 20), glm::vec3(20.03f, 0.0f, 0.0f));
    EXPECT_EQ(sewn(beside), 0u);
    Organ shifted = plane(20.0, 20);  // open edges on one another, their vertices not
    add(shifted, plane(20.0, 20), glm::vec3(20.0f, 0.0f, 0.4f));
    EXPECT_EQ(sewn(shifted), 0u);
    Organ closed = sphere(10.0, 3);  // two closed bodies that touch
    add(closed, sphere(10.0, 3), glm::vec3(1e-5f, 0.0f, 0.0f));
    EXPECT_EQ(sewn(closed), 0u);
}

TEST(Weld, NoEdgeLosesItsLength) {
    // A fan of needles whose tips are closer together than any tolerance of their long sides.
    Organ organ;
    for (int i = 0; i < 200; ++i) {
        const float x = static_cast<float>(i);
        organ.positions.insert(organ.positions.end(),
                               {{x, 0.0f, 0.0f}, {x + 1.0f, 0.0f, 1e-7f * x}, {x + 0.5f, 0.0f, 50.0f + 1e-6f * x}});
        const auto base = static_cast<std::uint32_t>(3 * i);
        organ.indices.insert(organ.indices.end(), {base, base + 1, base + 2});
    }
    const organ::Weld weld = organ::weld_surface(organ.positions, organ.indices);
    for (std::size_t i = 0; i < organ.indices.size(); i += 3)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NE(weld.point[organ.indices[i + c]], weld.point[organ.indices[i + (c + 1) % 3]]);
}

TEST(Weld, AChainOfNearEdgesDoesNotCollapseATriangle) {
    // Each edge is close to the next; the first and the last are the length of a triangle's edge apart.
    Organ organ;
    constexpr int steps = 125;
    for (int i = 0; i <= steps; ++i) {
        const float y = static_cast<float>(i) / steps;
        organ.positions.insert(organ.positions.end(),
                               {{0.0f, y, 0.0f}, {1.0f, y, 0.0f}, {0.5f, y + (i % 2 == 0 ? 1.0f : -1.0f), 0.0f}});
    }
    organ.positions.insert(organ.positions.end(), {{0.0f, 0.0f, 0.0f}, {-1.0f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}});
    for (std::uint32_t i = 0; i < organ.positions.size(); ++i) organ.indices.push_back(i);
    const organ::Weld weld = organ::weld_surface(organ.positions, organ.indices);
    const std::size_t last = organ.positions.size();
    EXPECT_NE(weld.point[last - 3], weld.point[last - 1]);
    EXPECT_EQ(weld.point[last - 3], weld.point[0]) << "they are one place";
    EXPECT_EQ(weld.point[1], weld.point[3 * steps + 1]) << "the other ends are joined: no edge is lost there";
}

TEST(Weld, AFileSaysHowManyWereJoined) {
    const TemporaryFolder folder;
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 2e-17\nv 1 1 0\nv 2e-17 1 0\nf 1 2 3\nf 4 5 6\n";
    const Organ organ = load_organ(folder.write("m.obj", text), {.scale = 100.0});
    EXPECT_TRUE(has_warning(organ.warnings, "gaps along seams closed: 2 vertices moved by up to 2e-15 mm"))
        << testing::PrintToString(organ.warnings);
    EXPECT_EQ(report(organ).boundary_edges, 4u);
    EXPECT_EQ(organ.positions[3], organ.positions[1]);
    EXPECT_FALSE(has_warning(load_organ(folder.write("m.obj", cube_obj)).warnings, "seams"));
}

}  // namespace
}  // namespace lapfx::test
