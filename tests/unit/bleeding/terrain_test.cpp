#include "bleeding/terrain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

using test::Cut;

constexpr glm::dvec3 down{0.0, -1.0, 0.0};

std::uint32_t nearest(const Surface& surface, glm::dvec3 place) {
    std::uint32_t best = 0;
    for (std::uint32_t v = 0; v < surface.positions.size(); ++v)
        if (glm::distance(surface.positions[v], place) < glm::distance(surface.positions[best], place)) best = v;
    return best;
}

/// A sheet bent into a valley (slope above 0) or a ridge along x = 0.
Organ bent(double slope, std::uint32_t n = 60) {
    Organ organ = test::plane(60.0, n);
    for (glm::vec3& p : organ.positions) p.y = static_cast<float>(slope * std::abs(p.x));
    return organ;
}

TEST(Terrain, FlatAndEvenlyCurvedTissueHasNoCreases) {
    const Surface flat(test::plane(60.0, 60, Cut::irregular)), round(test::sphere(30.0, 5));
    Terrain on_flat(flat, down), on_round(round, down);
    for (std::uint32_t v = 0; v < flat.positions.size(); v += 7) EXPECT_NEAR(on_flat.crease(v), 0.0, 1e-6);
    for (std::uint32_t v = 0; v < round.positions.size(); v += 7) EXPECT_NEAR(on_round.crease(v), 0.0, 0.02);
    EXPECT_EQ(on_round.slowness(17, 1.0), 1.0);
}

TEST(Terrain, AValleyIsACreaseAndARidgeItsOpposite) {
    constexpr double slope = 0.7;
    const Surface valley(bent(slope)), ridge(bent(-slope));
    Terrain in_valley(valley, down), on_ridge(ridge, down);
    const std::uint32_t bottom = nearest(valley, {0, 0, 0}), top = nearest(ridge, {0, 0, 0});
    // Height of the section at length L and angle a from the crease: L slope |sin a| / sqrt(1 + slope^2 sin^2 a); at L
    // and at 2 L with a quarter of the weight, half of the height at L remains.
    double wanted = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double s = slope * std::abs(std::sin((i + 0.5) * std::acos(-1.0) / 3.0));
        wanted += 0.5 * 2.5 * s / std::sqrt(1.0 + s * s) / 3.0;
    }
    EXPECT_NEAR(in_valley.crease(bottom), wanted, 0.02 * wanted);
    EXPECT_NEAR(on_ridge.crease(top), -wanted, 0.02 * wanted);
    EXPECT_LT(in_valley.slowness(bottom, 1.0), 0.45);
    EXPECT_GT(on_ridge.slowness(top, 1.0), 1.25);
    EXPECT_NEAR(in_valley.crease(nearest(valley, {12, 8.4, 3})), 0.0, 1e-6) << "on its slope";
}

TEST(Terrain, ACreaseIsTheSameOnACoarseAndAFineMesh) {
    const Surface coarse(bent(0.5, 40)), fine(bent(0.5, 240));
    Terrain on_coarse(coarse, down), on_fine(fine, down);
    EXPECT_NEAR(on_coarse.crease(nearest(coarse, {0, 0, 0})), on_fine.crease(nearest(fine, {0, 0, 0})), 0.01);
}

TEST(Terrain, NearAnEdgeNothingIsKnownOfCreases) {
    const Surface surface(bent(0.7));
    Terrain terrain(surface, down);
    EXPECT_EQ(terrain.crease(nearest(surface, {0, 0, 30})), 0.0);
}

TEST(Terrain, BridgesLeadToTheNearestOtherPartWithinFiveMillimetres) {
    const Organ sheet = test::plane(20.0, 20);
    const Surface near(test::joined(sheet, sheet, {0.0f, 3.0f, 0.0f})),
        far(test::joined(sheet, sheet, {0.0f, 6.0f, 0.0f})), alone(sheet);
    Terrain on_near(near, down), on_far(far, down), on_alone(alone, down);
    const SurfacePoint* place = on_near.bridge(0);
    ASSERT_NE(place, nullptr);
    EXPECT_NEAR(place->distance, 3.0, 1e-6);
    EXPECT_NE(near.component[near.triangles[place->triangle][0]], near.component[0]);
    EXPECT_EQ(on_far.bridge(0), nullptr);
    EXPECT_EQ(on_alone.bridge(0), nullptr);
}

}  // namespace
}  // namespace lapfx::bleeding
