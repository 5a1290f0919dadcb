#include "smoke/particles_cpu.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "support/contacts.h"
#include "unit/smoke/support.h"

namespace lapfx::smoke {
namespace {

constexpr glm::dvec3 up{0.0, 1.0, 0.0};

ParticleParameters parameters() {
    return {.rate = 20.0, .size = 0.5, .speed = 40.0, .lifetime = 1.0};
}

ToolContact contact(double time = 1.0, double duration = 4.0, glm::dvec3 place = {3, 4, 5}) {
    return test::contact(ToolAction::cauterise, time, duration, place);
}

std::vector<Particle> at(double time, const std::vector<ToolContact>& contacts = {contact()}, double fat = 1.0,
                         const ParticleParameters& p = parameters(), std::uint32_t seed = 7) {
    std::array<Particle, most_particles> room;
    const BurnList burns = burns_of(contacts, fat);
    const std::size_t count = particles_at(burns.parts(), p, up, seed, time, room);
    return {room.begin(), room.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// By shape, which distinguishes specks.
std::map<std::uint32_t, Particle> by_shape(double time, double fat = 1.0) {
    std::map<std::uint32_t, Particle> found;
    for (const Particle& p : at(time, {contact()}, fat)) found[p.shape] = p;
    return found;
}

/// All that ever are, counted by shape.
std::size_t ever(const std::vector<ToolContact>& contacts, double fat, const ParticleParameters& p = parameters()) {
    std::map<std::uint32_t, int> seen;
    for (double t = 0.0; t < 120.0; t += 0.02)
        for (const Particle& particle : at(t, contacts, fat, p)) ++seen[particle.shape];
    return seen.size();
}

TEST(Particles, AreThereWhileFatBurnsAndALifetimeLonger) {
    EXPECT_TRUE(at(1.0).empty());
    EXPECT_FALSE(at(1.2).empty());
    EXPECT_FALSE(at(5.1).empty());
    EXPECT_TRUE(at(6.0).empty());
    EXPECT_TRUE(at(3.0, {contact()}, 0.0).empty()) << "no fat";
    ToolContact cold = contact();
    cold.action = ToolAction::cut;
    EXPECT_TRUE(at(3.0, {cold}).empty());
    ParticleParameters none = parameters();
    none.rate = 0.0;
    EXPECT_TRUE(at(3.0, {contact()}, 1.0, none).empty());
}

TEST(Particles, TheirNumberFollowsRatePowerAndFat) {
    const std::vector<ToolContact> longer{contact(0.0, 100.0)};
    EXPECT_NEAR(static_cast<double>(ever(longer, 1.0)), 2000.0, 3.0);
    EXPECT_NEAR(static_cast<double>(ever(longer, 0.3)), 600.0, 60.0);
    std::vector<ToolContact> weak = longer;
    weak[0].power = 0.5;
    EXPECT_NEAR(static_cast<double>(ever(weak, 0.6)), 600.0, 60.0);
    std::vector<ToolContact> pieces;  // as a recorder cuts a moving tool's contact
    for (int i = 0; i < 1000; ++i) pieces.push_back(contact(0.1 * i, 0.1, {0.1 * i, 0, 0}));
    EXPECT_NEAR(static_cast<double>(ever(pieces, 1.0)), 2000.0, 120.0);
}

TEST(Particles, FlyByTheEquationOfDragAndSettling) {
    // Velocity from positions must obey dv/dt = -(v + s up) / drag_time, s = settling * size^2 for each.
    constexpr double h = 1e-2;
    int checked = 0;
    for (const double t : {2.0, 2.5, 3.3})
        for (const auto& [shape, now] : by_shape(t)) {
            const auto before = by_shape(t - h), after = by_shape(t + h);
            if (!before.contains(shape) || !after.contains(shape)) continue;
            const glm::dvec3 a(before.at(shape).position), b(now.position), c(after.at(shape).position);
            const glm::dvec3 velocity = (c - a) / (2.0 * h), acceleration = (c - 2.0 * b + a) / (h * h);
            const double size = static_cast<double>(now.diameter) / 0.5;
            const glm::dvec3 expected = -(velocity + settling * size * size * up) / drag_time;
            EXPECT_LT(glm::distance(acceleration, expected), 0.03 * glm::length(expected) + 0.5) << shape;
            ++checked;
        }
    EXPECT_GT(checked, 20);
}

TEST(Particles, LeaveTheTipUpwardsWithinTheirSpeed) {
    ToolContact moving = contact();
    moving.to = {23, 4, 5};
    int young = 0;
    for (double t = 1.0; t < 5.0; t += 0.01)
        for (const Particle& p : at(t, {moving})) {
            if (p.glow < std::exp(-0.02 / glow_time)) continue;
            const double age = -glow_time * std::log(static_cast<double>(p.glow));
            const double distance = glm::distance(glm::dvec3(p.position), moving.tip(t - age));
            EXPECT_LE(distance, 40.0 * age + 1e-3);
            EXPECT_GE(distance, 0.25 * 40.0 * age - 1e-3);
            EXPECT_GT(static_cast<double>(p.position.y), 4.0 - 1e-2);
            ++young;
        }
    EXPECT_GT(young, 50);
}

TEST(Particles, FlyToAllSides) {
    glm::dvec3 sum(0.0);
    double radius = 0.0;
    int count = 0;
    for (double t = 1.5; t < 5.0; t += 0.1)
        for (const Particle& p : at(t)) {
            const glm::dvec3 from_tip = glm::dvec3(p.position) - glm::dvec3(3, 4, 5);
            sum += from_tip;
            radius += std::hypot(from_tip.x, from_tip.z);
            ++count;
        }
    EXPECT_LT(std::hypot(sum.x, sum.z), 0.2 * radius);
    EXPECT_GT(radius / count, 2.0) << "mm";
}

TEST(Particles, AnyTimeInAnyOrderGivesTheSame) {
    const auto first = at(2.7);
    at(9.0);
    at(1.1);
    const auto again = at(2.7);
    ASSERT_EQ(first.size(), again.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].position, again[i].position);
    const auto other = at(2.7, {contact()}, 1.0, parameters(), 8);
    EXPECT_TRUE(other.size() != first.size() || other[0].position != first[0].position) << "another seed";
}

TEST(Particles, AContactThatGoesOnKeepsTheSpecksThatAreThere) {
    const auto shorter = at(2.0, {contact(1.0, 1.0)}), longer = at(2.0, {contact(1.0, 9.0)});
    ASSERT_EQ(shorter.size(), longer.size());
    for (std::size_t i = 0; i < shorter.size(); ++i) EXPECT_EQ(shorter[i].position, longer[i].position);
    const auto with_others = at(2.0, {contact(0.0, 0.5, {9, 9, 9}), contact(1.0, 1.0), contact(3.0, 1.0)});
    EXPECT_EQ(with_others[0].position, shorter[0].position) << "others before and after do not matter";
    // When the fat is measured again, there are more or fewer specks, but those of less fat are among those of more.
    const auto lean = by_shape(2.0, 0.5), fatter = by_shape(2.0, 0.6);
    EXPECT_GE(fatter.size(), lean.size());
    for (const auto& [shape, p] : lean) {
        ASSERT_TRUE(fatter.contains(shape));
        EXPECT_EQ(fatter.at(shape).position, p.position);
    }
}

TEST(Particles, SizeOpacityAndGlowAreWithinTheirRange) {
    float largest = 0.0f;
    for (double t = 1.0; t < 6.0; t += 0.05)
        for (const Particle& p : at(t)) {
            EXPECT_GE(p.diameter, 0.35f * 0.5f - 1e-6f);
            EXPECT_LE(p.diameter, 0.5f);
            EXPECT_GT(p.opacity, 0.0f);
            EXPECT_LE(p.opacity, 1.0f);
            EXPECT_GT(p.glow, 0.0f);
            EXPECT_LE(p.glow, 1.0f);
            largest = std::max(largest, p.diameter);
        }
    EXPECT_GT(largest, 0.4f);
}

TEST(Particles, OfMoreThanThereIsRoomForTheNewestAreKept) {
    const ParticleParameters many{.rate = 60.0, .size = 0.5, .speed = 40.0, .lifetime = 5.0};
    const std::vector<ToolContact> two{contact(0.0, 60.0), contact(0.0, 60.0, {9, 9, 9})};
    const auto found = at(30.0, two, 1.0, many);
    EXPECT_EQ(found.size(), most_particles);
    std::array<Particle, 3> room;
    EXPECT_EQ(particles_at(burns_of(two, 1.0).parts(), many, up, 7, 30.0, room), 3u);
    EXPECT_EQ(room[0].position, found[0].position);
}

TEST(Particles, WhatCannotBeGivesNone) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(at(nan).empty());
    EXPECT_TRUE(at(infinity).empty());
    EXPECT_TRUE(at(3.0, {contact(nan)}).empty());
    EXPECT_TRUE(at(3.0, {contact(-infinity, 9.0)}).empty());
    EXPECT_TRUE(at(3.0, {contact(-infinity, infinity)}).empty());
    EXPECT_TRUE(at(3.0, {contact(-1e300, 2e300)}).empty());
    EXPECT_TRUE(at(3.0, {contact()}, nan).empty());
}

}  // namespace
}  // namespace lapfx::smoke
