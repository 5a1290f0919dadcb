#include "render/clip_mesh.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace lapfx::render {
namespace {

TEST(ClipMesh, IsAsLongAsItIsToBeAndAMillimetreThick) {
    for (const double length : {5.0, 9.0, 14.0}) {
        const ClipMesh mesh = clip_mesh(length);
        glm::vec3 low(1e9f), high(-1e9f);
        for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
        EXPECT_NEAR(high.x - low.x, length, 0.02) << length;
        EXPECT_NEAR(high.y - low.y, 1.0, 0.01) << length;
        EXPECT_NEAR(high.z - low.z, 1.7, 0.1) << "two jaws";
        EXPECT_LT(low.y, 0.0f) << "pressed into the tissue";
    }
}

TEST(ClipMesh, FacesOutwardsAndHasAGap) {
    const ClipMesh mesh = clip_mesh(9.0);
    ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        const glm::vec3 face = glm::cross(b - a, c - a);
        volume += glm::dot(glm::dvec3(a), glm::cross(glm::dvec3(b), glm::dvec3(c))) / 6.0;
        if (glm::length(face) < 1e-4f) continue;
        for (int k = 0; k < 3; ++k)
            EXPECT_GT(glm::dot(glm::normalize(face), mesh.normals[mesh.indices[i + static_cast<std::size_t>(k)]]),
                      -0.2f);
    }
    EXPECT_GT(volume, 7.0) << "mm3, and turned outwards";
    EXPECT_LT(volume, 13.0);
    for (const glm::vec3& p : mesh.positions)
        EXPECT_TRUE(p.x <= -3.0f || std::abs(p.z) > 0.05f) << "the jaws do not meet";
}

}  // namespace
}  // namespace lapfx::render
