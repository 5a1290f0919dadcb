#include "bleeding/front.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lapfx/authoring/reach.h"
#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

using test::Cut;

constexpr glm::dvec3 down{0.0, -1.0, 0.0};

/// A whole front at once, on smooth ground, without gravity and creases.
std::vector<Reached> march(const Surface& surface, const glm::dvec3& contact, double limit) {
    FrontRoom room(surface, down);
    return bleeding::march(room, {}, contact, limit);
}

/// Largest error of march(), relative to the true distances, farther than `from` mm away.
template <class Truth>
double worst_error(const Surface& surface, glm::dvec3 contact, double limit, double from, Truth truth) {
    double worst = 0.0;
    std::size_t compared = 0;
    for (const Reached& r : march(surface, contact, limit)) {
        const double wanted = truth(surface.positions[r.vertex]);
        if (wanted < from) continue;
        ++compared;
        worst = std::max(worst, std::abs(r.distance - wanted) / wanted);
    }
    EXPECT_GT(compared, 100u);
    return worst;
}

double worst_on_plane(Cut cut, glm::dvec3 contact, std::uint32_t n = 60) {
    const Surface surface(test::plane(60.0, n, cut));
    return worst_error(surface, contact, 25.0, 0.1, [&](glm::dvec3 p) { return glm::distance(p, contact); });
}

TEST(Front, OnAPlaneTravelDistanceIsTheStraightLine) {
    EXPECT_LT(worst_on_plane(Cut::regular, {0.3, 0.0, 0.2}), 1e-6);
    EXPECT_LT(worst_on_plane(Cut::regular, {-3.61, 0.0, 2.85}), 1e-6);
    EXPECT_LT(worst_on_plane(Cut::regular, {0.0, 0.0, 0.0}), 1e-6) << "contact on a vertex";
    EXPECT_LT(worst_on_plane(Cut::regular, {0.5, 0.0, 0.0}), 1e-6) << "contact on an edge";
}

TEST(Front, AnIrregularMeshChangesDistancesByLessThanOnePercent) {
    for (const glm::dvec3 contact :
         {glm::dvec3(0.3, 0.0, 0.2), glm::dvec3(-3.61, 0.0, 2.85), glm::dvec3(5.5, 0.0, -4.1)})
        EXPECT_LT(worst_on_plane(Cut::irregular, contact), 0.01) << contact.x;
}

TEST(Front, OnASphereItIsTheGreatCircle) {
    constexpr double radius = 30.0;
    const Surface surface(test::sphere(radius, 5));
    const glm::dvec3 contact = radius * glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
    const auto great_circle = [&](glm::dvec3 p) {
        return radius * std::acos(std::clamp(glm::dot(glm::normalize(p), glm::normalize(contact)), -1.0, 1.0));
    };
    EXPECT_LT(worst_error(surface, contact, 90.0, 3.0, great_circle), 0.02);
}

TEST(Front, ReachesAllWithinTheLimitAndNothingBeyond) {
    const Surface surface(test::plane(40.0, 40));
    const glm::dvec3 contact(0.2, 0.0, 0.4);
    const std::vector<Reached> reached = march(surface, contact, 10.0);
    std::vector<char> found(surface.positions.size(), false);
    for (const Reached& r : reached) {
        EXPECT_LE(r.distance, 10.0);
        EXPECT_FALSE(found[r.vertex]) << "reached twice";
        found[r.vertex] = true;
    }
    for (std::size_t v = 0; v < found.size(); ++v) {
        const double distance = glm::distance(surface.positions[v], contact);
        if (std::abs(distance - 10.0) > 1e-6) {
            EXPECT_EQ(found[v], distance < 10.0) << v;
        }
    }
}

TEST(Front, TheLimitDoesNotChangeWhatLiesWithinIt) {
    const Surface surface(test::plane(40.0, 30, Cut::irregular));
    std::vector<double> far(surface.positions.size(), 0.0);
    for (const Reached& r : march(surface, {1.3, 0.0, -2.1}, 40.0)) far[r.vertex] = r.distance;
    for (double limit = 2.0; limit < 16.0; limit += 0.25)
        for (const Reached& r : march(surface, {1.3, 0.0, -2.1}, limit)) EXPECT_NEAR(r.distance, far[r.vertex], 1e-6);
}

TEST(Front, NearestFirst) {
    const Surface surface(test::plane(40.0, 30, Cut::irregular));
    const std::vector<Reached> reached = march(surface, {1.0, 0.0, 1.0}, 15.0);
    ASSERT_GT(reached.size(), 100u);
    EXPECT_TRUE(std::is_sorted(reached.begin(), reached.end(),
                               [](const Reached& a, const Reached& b) { return a.distance < b.distance; }));
}

TEST(Front, AnotherComponentIsNotReachedHoweverNear) {
    const Organ sheet = test::plane(20.0, 20);
    const auto count = static_cast<std::uint32_t>(sheet.positions.size());
    const Surface surface(test::joined(sheet, sheet, {0.0f, 0.5f, 0.0f}));
    const std::vector<Reached> reached = march(surface, {0.1, 0.0, 0.1}, 100.0);
    EXPECT_EQ(reached.size(), count);
    for (const Reached& r : reached) EXPECT_LT(r.vertex, count);
}

TEST(Front, AContactOffTheSurfaceIsMovedOntoIt) {
    const Surface surface(test::plane(20.0, 20));
    const std::vector<Reached> on = march(surface, {0.3, 0.0, 0.1}, 5.0), above = march(surface, {0.3, 2.0, 0.1}, 5.0);
    ASSERT_EQ(on.size(), above.size());
    for (std::size_t i = 0; i < on.size(); ++i) {
        EXPECT_EQ(on[i].vertex, above[i].vertex);
        EXPECT_DOUBLE_EQ(on[i].distance, above[i].distance);
    }
}

/// A strip folded by a right angle along x = 0: distances follow the fold and not the air.
TEST(Front, FollowsTheSurfaceOverAFold) {
    Organ organ = test::plane(40.0, 40);
    for (glm::vec3& p : organ.positions)
        if (p.x > 0.0f) p = {0.0f, p.x, p.z};
    const Surface surface(organ);
    const glm::dvec3 contact(-6.0, 0.0, 0.0);
    double worst = 0.0;
    for (const Reached& r : march(surface, contact, 15.0)) {
        const glm::dvec3 p = surface.positions[r.vertex];
        const double unfolded = glm::length(glm::dvec2(p.x + p.y + 6.0, p.z));
        worst = std::max(worst, std::abs(r.distance - unfolded));
    }
    EXPECT_LT(worst, 1e-6);
}

/// Blood of 21 mm runs 100 mm down a fold where gravity and the fold help it: that is what the biases say.
TEST(Front, NoReachIsExceeded) {
    BleedingParameters p;
    p.max_extent = 21.0;
    p.noise_strength = p.threshold = 0.0;
    p.gravity_bias = 0.35;
    p.crease_bias = 0.5;
    const BloodReach reach = blood_reach(p);
    EXPECT_DOUBLE_EQ(reach.level, 21.0);
    EXPECT_NEAR(reach.downhill, 32.3, 0.05);
    EXPECT_NEAR(reach.fold, 31.1, 0.05);
    EXPECT_NEAR(reach.down_fold, 64.6, 0.05);
    p.gravity_bias = 0.55;
    EXPECT_NEAR(blood_reach(p).down_fold, 168.0, 0.05);
    p.crease_bias = 1.0;
    EXPECT_NEAR(blood_reach(p).down_fold, 420.0, 0.05) << "each mm costs something";
    // A fold that leads straight down: the front comes close to that bound and does not exceed it.
    p.gravity_bias = 0.35, p.crease_bias = 0.5, p.max_extent = 10.0;
    Organ fold = test::plane(90.0, 180);
    for (glm::vec3& at : fold.positions)
        if (at.x > 0.0F) at = {0.0F, at.x, at.z};
    const Surface surface(fold);
    FrontRoom room(surface, {0.0, 0.0, 1.0});
    double farthest = 0.0;
    for (const Reached& r : bleeding::march(room, metric_of(p), {0.0, 0.0, -20.0}, p.max_extent))
        farthest = std::max(farthest, surface.positions[r.vertex].z + 20.0);
    EXPECT_LE(farthest, blood_reach(p).down_fold + 0.01);
    EXPECT_GT(farthest, blood_reach(p).downhill) << "farther than down a smooth wall";
}

TEST(Front, AnEmptySurfaceReachesNothing) {
    EXPECT_TRUE(march(Surface(), {0.0, 0.0, 0.0}, 10.0).empty());
}

}  // namespace
}  // namespace lapfx::bleeding
