#include "organ/moved_surface.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace lapfx {
namespace {

std::vector<glm::vec3> shifted_and_stretched(const Organ& organ) {
    std::vector<glm::vec3> moved = organ.positions;
    for (glm::vec3& p : moved) p = {2.0f * p.x + 5.0f, p.y + 10.0f, p.z};
    return moved;
}

TEST(MovedSurface, AtRestUntilItIsMoved) {
    const Surface rest(test::plane(20.0, 20));
    const MovedSurface moved(rest);
    EXPECT_FALSE(moved.moved());
    EXPECT_EQ(moved.to_rest({3, 4, 5}), glm::dvec3(3, 4, 5));
    SurfacePoint hit;
    ASSERT_TRUE(moved.intersect_ray({1, 9, 1}, {0, -1, 0}, hit));
    EXPECT_NEAR(hit.distance, 9.0, 1e-12);
}

TEST(MovedSurface, PlacesComeBackToRestAndRaysMeetTheMovedShape) {
    const Organ organ = test::plane(20.0, 20);
    const Surface rest(organ);
    MovedSurface moved(rest);
    moved.move(shifted_and_stretched(organ));
    const glm::dvec3 at_rest = moved.to_rest({5.0 + 2.0 * 3.3, 10.4, -4.7});
    EXPECT_NEAR(glm::distance(at_rest, {3.3, 0.4, -4.7}), 0.0, 1e-5);
    SurfacePoint hit;
    ASSERT_TRUE(moved.intersect_ray({20, 50, 1}, {0, -1, 0}, hit)) << "beyond the shape at rest";
    EXPECT_NEAR(hit.distance, 40.0, 1e-5);
    EXPECT_FALSE(moved.intersect_ray({-17, 50, 1}, {0, -1, 0}, hit));
}

TEST(MovedSurface, MovesAgainAndAgain) {
    const Organ organ = test::sphere(10.0, 3);
    const Surface rest(organ);
    MovedSurface moved(rest);
    for (const float shift : {50.0f, -30.0f, 0.0f}) {
        std::vector<glm::vec3> positions = organ.positions;
        for (glm::vec3& p : positions) p.x += shift;
        moved.move(positions);
        SurfacePoint hit;
        ASSERT_TRUE(moved.intersect_ray({shift, 0.1, 100}, {0, 0, -1}, hit));
        EXPECT_NEAR(hit.distance, 90.0, 0.1);
    }
}

TEST(MovedSurface, NormalsAreThoseOfTheShapeAndSmoothOverSeams) {
    const Organ sphere = test::sphere(10.0, 3);
    Organ split;  // every triangle with vertices of its own
    for (const std::uint32_t i : sphere.indices) {
        split.indices.push_back(static_cast<std::uint32_t>(split.positions.size()));
        split.positions.push_back(sphere.positions[i]);
    }
    const Surface rest(split);
    MovedSurface moved(rest);
    std::vector<glm::vec3> positions = split.positions, normals(split.positions.size());
    for (glm::vec3& p : positions) p.y *= 2.0f;
    moved.move(positions);
    moved.normals(normals);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const glm::vec3 wanted = glm::normalize(glm::vec3(positions[v].x, positions[v].y / 4.0f, positions[v].z));
        ASSERT_GT(glm::dot(normals[v], wanted), 0.99f) << v;
    }
}

}  // namespace
}  // namespace lapfx
