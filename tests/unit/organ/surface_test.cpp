#include "organ/surface.h"

#include <random>

#include "support/meshes.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

Surface cube() {
    const TemporaryFolder folder;
    return Surface(load_organ(folder.write("m.obj", cube_obj)));
}

/// A bumpy sheet of n * n squares, so that the tree has some depth.
Organ sheet(std::uint32_t n) {
    Organ organ;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x)
            organ.positions.emplace_back(
                x, y, std::sin(0.7f * static_cast<float>(x)) + std::cos(0.9f * static_cast<float>(y)));
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
            organ.indices.insert(organ.indices.end(), {a, b, d, a, d, c});
        }
    return organ;
}

TEST(Surface, WeldsAndFindsNeighbours) {
    Organ organ;  // two triangles with no common vertex, but with a common edge
    organ.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0f, 1, 0}};
    organ.indices = {0, 1, 2, 3, 4, 5};
    const Surface surface(organ);
    EXPECT_EQ(surface.weld, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(surface.positions.size(), 4u);
    const auto at = surface.triangles_at(1);
    EXPECT_EQ(std::vector<std::uint32_t>(at.begin(), at.end()), (std::vector<std::uint32_t>{0, 1}));
    const auto around = surface.neighbours_of(2);
    EXPECT_EQ(std::vector<std::uint32_t>(around.begin(), around.end()), (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Surface, NearestOnFaceEdgeAndCorner) {
    const Surface surface = cube();
    SurfacePoint p = surface.closest_point({5, 4, 13});
    EXPECT_EQ(p.position, glm::dvec3(5, 4, 10));
    EXPECT_DOUBLE_EQ(p.distance, 3.0);
    EXPECT_NEAR(p.weights.x + p.weights.y + p.weights.z, 1.0, 1e-12);
    p = surface.closest_point({13, 5, 14});
    EXPECT_EQ(p.position, glm::dvec3(10, 5, 10));
    EXPECT_DOUBLE_EQ(p.distance, 5.0);
    EXPECT_EQ(surface.closest_point({-1, -2, -2}).position, glm::dvec3(0));
    EXPECT_DOUBLE_EQ(surface.closest_point({5, 5, 9}).distance, 1.0);  // the place lies inside
}

TEST(Surface, RayHitsTheNearSide) {
    const Surface surface = cube();
    SurfacePoint hit;
    ASSERT_TRUE(surface.intersect_ray({3, 4, 50}, {0, 0, -2}, hit));
    EXPECT_EQ(hit.position, glm::dvec3(3, 4, 10));
    EXPECT_DOUBLE_EQ(hit.distance, 40.0);
    ASSERT_TRUE(surface.intersect_ray({3, 4, 5}, {0, 0, -1}, hit));  // from inside, the back of a face
    EXPECT_EQ(hit.position, glm::dvec3(3, 4, 0));
    EXPECT_FALSE(surface.intersect_ray({3, 4, 50}, {0, 0, 1}, hit));
    EXPECT_FALSE(surface.intersect_ray({30, 4, 50}, {0, 0, -1}, hit));
    EXPECT_FALSE(surface.intersect_ray({3, 4, 50}, {0, 0, 0}, hit));
    EXPECT_FALSE(Surface().intersect_ray({0, 0, 1}, {0, 0, -1}, hit));
}

TEST(Surface, TreeAgreesWithEveryTriangleTried) {
    const Organ organ = sheet(24);
    const Surface surface(organ);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-5.0, 29.0);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p(place(random), place(random), place(random) / 5);
        double best = 1e9;
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
            Organ one;
            for (const std::uint32_t point : surface.triangles[t])
                one.positions.push_back(glm::vec3(surface.positions[point]));
            one.indices = {0, 1, 2};
            best = std::min(best, Surface(one).closest_point(p).distance);
        }
        EXPECT_NEAR(surface.closest_point(p).distance, best, 1e-9);
        SurfacePoint hit;
        const glm::dvec3 above(p.x, p.y, 100.0);
        const bool inside = p.x > 0 && p.x < 24 && p.y > 0 && p.y < 24;
        EXPECT_EQ(surface.intersect_ray(above, {0, 0, -1}, hit), inside);
        if (inside) {
            glm::dvec3 at(0.0);
            for (int c = 0; c < 3; ++c)
                at += hit.weights[c] * surface.positions[surface.triangles[hit.triangle][static_cast<std::size_t>(c)]];
            EXPECT_NEAR(glm::length(at - hit.position), 0.0, 1e-9);
            EXPECT_NEAR(hit.position.x, p.x, 1e-12);
        }
    }
}

TEST(PointsWithin, FindsAllPointsOfAllPartsOnce) {
    const Surface surface(test::joined(test::plane(20.0, 20, test::Cut::irregular), test::sphere(5.0, 3), {3, 4, 0}));
    std::vector<std::uint32_t> found{99};
    for (const double radius : {0.0, 0.7, 3.0, 9.0, 100.0})
        for (const glm::dvec3 centre : {glm::dvec3(0.0), glm::dvec3(3.0, 1.0, 0.5), surface.positions[7]}) {
            surface.points_within(centre, radius, found);
            std::vector<std::uint32_t> wanted;
            for (std::uint32_t p = 0; p < surface.positions.size(); ++p)
                if (glm::distance(surface.positions[p], centre) <= radius) wanted.push_back(p);
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, wanted) << radius;
        }
    surface.points_within(glm::dvec3(0.0), -1.0, found);
    EXPECT_TRUE(found.empty());
    surface.points_within(glm::dvec3(0.0), std::nan(""), found);
    EXPECT_TRUE(found.empty());
    Surface().points_within(glm::dvec3(0.0), 10.0, found);
    EXPECT_TRUE(found.empty());
}

TEST(Surface, KnowsTheVerticesAtEachPoint) {
    const Organ organ = test::joined(test::plane(10.0, 3), test::plane(10.0, 3), {10.0f, 0.0f, 0.0f});
    const Surface surface(organ);
    ASSERT_LT(surface.positions.size(), organ.positions.size()) << "both sheets share an edge";
    std::size_t vertices = 0;
    for (std::uint32_t point = 0; point < surface.positions.size(); ++point) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t v = 0; v < surface.weld.size(); ++v)
            if (surface.weld[v] == point) expected.push_back(v);
        const auto found = surface.vertices_at(point);
        EXPECT_EQ(std::vector(found.begin(), found.end()), expected) << point;
        vertices += found.size();
    }
    EXPECT_EQ(vertices, organ.positions.size());
}

}  // namespace
}  // namespace lapfx::test
