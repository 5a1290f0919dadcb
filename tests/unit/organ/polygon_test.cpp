// Polygons become triangles that cover them exactly once.
#include "organ/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace lapfx::organ {
namespace {

double area_of(std::span<const glm::vec3> ring) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += glm::cross(glm::dvec3(ring[i]), glm::dvec3(ring[(i + 1) % ring.size()]));
    return 0.5 * glm::length(sum);
}

/// n - 2 triangles, `flat` of them without area; none reversed; their areas add up to that of the ring.
void expect_covered(const std::vector<glm::vec3>& ring, std::size_t flat = 0) {
    std::vector<std::uint32_t> corners;
    EXPECT_TRUE(triangulate(ring, corners));
    ASSERT_EQ(corners.size(), 3 * (ring.size() - 2));
    double sum = 0.0;
    std::size_t without_area = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 a(ring[corners[i]]), b(ring[corners[i + 1]]), c(ring[corners[i + 2]]);
        const double z = glm::cross(b - a, c - a).z / 2.0;
        EXPECT_GE(z, 0.0) << "turned round";
        const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        without_area += z <= 0.5e-7 * longest * longest;  // organ::mend() would leave it out
        sum += z;
    }
    EXPECT_EQ(without_area, flat);
    EXPECT_NEAR(sum, area_of(ring), 1e-5 * area_of(ring));
}

/// The corner at `share` of a circle.
glm::vec3 on_circle(double radius, double share) {
    const double angle = 2.0 * std::numbers::pi * share;
    return glm::vec3(glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), 0.0));
}

TEST(Polygon, RingCutOpenAroundAHole) {
    // As modellers write a ring: once round outside, over the cut, once round inside the other way, and back over the
    // cut.
    for (const int n : {3, 4, 32, 100}) {
        std::vector<glm::vec3> ring;
        for (int i = 0; i <= n; ++i) ring.push_back(on_circle(10.0, static_cast<double>(i % n) / n));
        for (int i = n; i >= 0; --i) ring.push_back(on_circle(4.0, static_cast<double>(i % n) / n));
        for (std::size_t turned = 0; turned < ring.size(); ++turned) {
            expect_covered(ring);
            std::rotate(ring.begin(), ring.begin() + 1, ring.end());
            if (n > 4) turned += ring.size() / 8;
        }
    }
}

TEST(Polygon, TwoHolesAtOneCut) {
    // Outside, to the first hole, half round it, to the second, round that, and back.
    expect_covered({{0, 0, 0},
                    {10, 0, 0},
                    {10, 6, 0},
                    {0, 6, 0},
                    {0, 0, 0},
                    {1, 1, 0},
                    {1, 3, 0},
                    {3, 3, 0},
                    {3, 1, 0},
                    {5, 1, 0},
                    {5, 3, 0},
                    {7, 3, 0},
                    {7, 1, 0},
                    {5, 1, 0},
                    {3, 1, 0},
                    {1, 1, 0}});
}

TEST(Polygon, CornersOnAnEdgeStayCorners) {
    // A fan from the first corner would skip the second one, and separate the surface from its neighbour there.
    expect_covered({{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}});
    expect_covered({{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {5, 5, 0}});
    std::vector<glm::vec3> square;
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i < 10; ++i) {
            const float t = static_cast<float>(i);
            square.push_back(side == 0   ? glm::vec3(t, 0, 0)
                             : side == 1 ? glm::vec3(10, t, 0)
                             : side == 2 ? glm::vec3(10 - t, 10, 0)
                                         : glm::vec3(0, 10 - t, 0));
        }
    expect_covered(square);
}

/// Rings for which cutting ears alone leaves triangles without area: corners on edges, also next to a hole and its cut.
const std::vector<std::vector<glm::vec3>> with_corners_on_edges{
    {{1, 2, 0}, {2, 2, 0}, {3, 2, 0}, {3, 3, 0}, {2, 3, 0}, {2, 4, 0}, {1, 4, 0}},
    {{1, 1, 0}, {4, 1, 0}, {4, 2, 0}, {3, 2, 0}, {3, 3, 0}, {2, 3, 0}, {2, 4, 0}, {1, 4, 0}},
    {{1, 1, 0},
     {5, 1, 0},
     {5, 4, 0},
     {4, 4, 0},
     {4, 3, 0},
     {4, 2, 0},
     {3, 2, 0},
     {3, 3, 0},
     {4, 3, 0},
     {4, 4, 0},
     {3, 4, 0},
     {3, 5, 0},
     {1, 5, 0},
     {1, 3, 0}},
    {{1, 1, 0},
     {3, 1, 0},
     {3, 2, 0},
     {3, 3, 0},
     {2, 3, 0},
     {2, 4, 0},
     {5, 4, 0},
     {5, 2, 0},
     {3, 2, 0},
     {3, 1, 0},
     {4, 1, 0},
     {5, 1, 0},
     {6, 1, 0},
     {6, 4, 0},
     {6, 5, 0},
     {4, 5, 0},
     {1, 5, 0}}};

TEST(Polygon, CornersOnEdgesLeaveNoTriangleWithoutArea) {
    for (std::vector<glm::vec3> ring : with_corners_on_edges) {
        for (glm::vec3& p : ring) p *= 0.1f;  // the corners are only almost on the edges, in floats
        for (std::size_t turned = 0; turned < ring.size(); ++turned) {
            expect_covered(ring);
            std::rotate(ring.begin(), ring.begin() + 1, ring.end());
        }
    }
}

TEST(Polygon, NoNeedleWhereRoundingMovesCornersOffTheirEdge) {
    // Somewhere in space, in floats, no three of those corners are quite on a line: half a square is the smallest
    // triangle still.
    std::mt19937 random(3);
    std::normal_distribution<double> any;
    for (int trial = 0; trial < 200; ++trial)
        for (const std::vector<glm::vec3>& flat : with_corners_on_edges) {
            const glm::dvec3 x = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
            const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(any(random), any(random), any(random))));
            std::vector<glm::vec3> ring;
            for (const glm::vec3& p : flat)
                ring.push_back(glm::vec3(100.0 + x * static_cast<double>(p.x) + y * static_cast<double>(p.y)));
            std::vector<std::uint32_t> corners;
            EXPECT_TRUE(triangulate(ring, corners));
            double sum = 0.0;
            for (std::size_t i = 0; i < corners.size(); i += 3) {
                const glm::dvec3 a(ring[corners[i]]), b(ring[corners[i + 1]]), c(ring[corners[i + 2]]);
                const double area = glm::dot(glm::cross(b - a, c - a), glm::cross(x, y)) / 2.0;
                EXPECT_GT(area, 0.499) << trial;
                sum += area;
            }
            EXPECT_NEAR(sum, area_of(flat), 1e-3);
        }
}

TEST(Polygon, TrianglesAreAsEvenAsTheirCornersAllow) {
    // A strip of squares, and a wheel: the longest sides that even triangles need.
    std::vector<glm::vec3> strip, wheel;
    for (int i = 0; i <= 20; ++i) strip.push_back({i, 0, 0});
    for (int i = 20; i >= 0; --i) strip.push_back({i, 1, 0});
    std::vector<std::uint32_t> corners;
    EXPECT_TRUE(triangulate(strip, corners));
    ASSERT_EQ(corners.size(), 3 * 40u);
    for (std::size_t i = 0; i < corners.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT(glm::distance(strip[corners[i + k]], strip[corners[i + (k + 1) % 3]]), 1.5f);
    for (int i = 0; i <= 48; ++i) wheel.push_back(on_circle(10.0, i % 48 / 48.0));
    for (int i = 48; i >= 0; --i) wheel.push_back(on_circle(9.0, i % 48 / 48.0));
    corners.clear();
    EXPECT_TRUE(triangulate(wheel, corners));
    for (std::size_t i = 0; i < corners.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_LT(glm::distance(wheel[corners[i + k]], wheel[corners[i + (k + 1) % 3]]), 1.7f);
}

TEST(Polygon, RepeatedCornersGiveTrianglesWithoutArea) {
    expect_covered({{0, 0, 0}, {0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, 1);
    expect_covered({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 0}, {9, 9, 0}, {0, 9, 0}}, 2);
}

TEST(Polygon, AnySimpleRing) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 200; ++trial) {
        const int n = 4 + static_cast<int>(random() % 60);
        std::vector<glm::vec3> ring;
        for (int i = 0; i < n; ++i)
            ring.push_back(on_circle(1.0 + static_cast<double>(random() % 1000) / 100.0, static_cast<double>(i) / n));
        expect_covered(ring);
    }
}

TEST(Polygon, FarFromTheOrigin) {
    std::vector<glm::vec3> ring{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {5, 1, 0}, {0, 10, 0}};
    for (glm::vec3& p : ring) p += glm::vec3(100000, -200000, 0);
    expect_covered(ring);
}

TEST(Polygon, ARingThatCrossesItselfIsToldOf) {
    const std::vector<glm::vec3> bow{{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10, 0}, {-3, 5, 0}};
    std::vector<std::uint32_t> corners;
    EXPECT_FALSE(triangulate(bow, corners));
    EXPECT_EQ(corners.size(), 9u);
    std::vector<glm::vec3> star;
    for (int i = 0; i < 5; ++i) star.push_back(on_circle(10.0, 0.4 * i));
    corners.clear();
    EXPECT_FALSE(triangulate(star, corners)) << "all its corners turn left";
    std::vector<glm::vec3> many;
    for (int i = 0; i < 1100; ++i) many.push_back(on_circle(i % 2 == 0 ? 5.0 : 10.0, i / 1100.0));
    EXPECT_FALSE(triangulate(many, corners));
}

/* Once each of these took a comparison of all corners with all others for every triangle.  */
TEST(Polygon, NoRingTakesMoreThanTheSquareOfItsCorners) {
    constexpr std::size_t n = 1024;
    const auto looks_at = [](const std::vector<glm::vec3>& ring, bool simple) {
        std::vector<std::uint32_t> corners;
        std::size_t looks = 0;
        EXPECT_EQ(triangulate(ring, corners, &looks), simple);
        EXPECT_EQ(corners.size(), 3 * (ring.size() - 2));
        return looks;
    };
    // All corners turn left, and the last one is inside each of their triangles.
    std::vector<glm::vec3> round, triangle, star;
    for (std::size_t i = 0; i + 1 < n; ++i) {
        round.push_back(on_circle(10.0, static_cast<double>(i * (n / 3 + 1) % n) / n));
        triangle.push_back(on_circle(10.0, static_cast<double>(i % 3) / 3.0));
    }
    for (std::vector<glm::vec3>* ring : {&round, &triangle}) ring->push_back({0, 0, 0});
    EXPECT_LT(looks_at(round, false), 2 * n * n);
    std::vector<std::uint32_t> corners;
    std::size_t looks = 0;
    triangulate(triangle, corners, &looks);  // it crosses itself only at its corners
    EXPECT_LT(looks, 16 * n * n);
    for (std::size_t i = 0; i < n; ++i) star.push_back(on_circle(i % 2 == 0 ? 5.0 : 10.0, static_cast<double>(i) / n));
    EXPECT_LT(looks_at(star, true), 2 * n * n);
}

}  // namespace
}  // namespace lapfx::organ
