// The bleed field on shapes that are not flat, with every parameter on, and with the faults of real files.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

#include "bleeding/bleed_cpu.h"
#include "support/logged.h"
#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

using test::Cut;

constexpr glm::dvec3 down{0.0, -1.0, 0.0};

BleedingParameters plain() {
    BleedingParameters b;
    b.speed = 4.0;
    b.max_extent = 16.0;
    b.threshold = 0.0;
    b.gravity_bias = b.crease_bias = 0.0;
    return b;
}

double area_after(const Surface& surface, glm::dvec3 contact, const BleedingParameters& b, double time) {
    BleedField field(surface, down);
    field.set(std::vector<Wound>{{.position = contact}}, b);
    field.update(time);
    return field.amount().area;
}

/// A lumpy organ about 80 mm wide: a sphere pushed in and out by smooth waves.
Organ lumpy(int cuts) {
    Organ organ = test::sphere(40.0, cuts);
    for (glm::vec3& p : organ.positions) {
        const glm::vec3 n = glm::normalize(p);
        p = n * (36.0f + 4.0f * std::sin(3.0f * n.x + 1.0f) * std::cos(2.5f * n.z) + 2.0f * std::sin(5.0f * n.y));
    }
    return organ;
}

TEST(Field, OnASphereTheCapFollowsTheGreatCircle) {
    constexpr double radius = 30.0;
    const Surface surface(test::sphere(radius, 6));
    const glm::dvec3 contact = radius * glm::normalize(glm::dvec3(0.3, 1.0, 0.2));
    for (const double time : {1.0, 2.0, 3.0, 9.0}) {
        const double reached = std::min(4.0 * time, 16.0);
        const double area = area_after(surface, contact, plain(), time);
        // The radius of a cap of this area, along the surface.
        const double measured = radius * std::acos(1.0 - area / (2.0 * std::numbers::pi * radius * radius));
        EXPECT_NEAR(measured, reached, 0.02 * reached) << time;
    }
}

TEST(Field, ALumpyOrganBleedsTheSameAreaAtEveryResolution) {
    BleedingParameters b;  // the defaults: gravity, creases, threshold
    for (const glm::dvec3 direction :
         {glm::dvec3(0.2, 0.3, 1.0), glm::dvec3(1.0, -0.4, 0.1), glm::dvec3(0.1, 1.0, 0.0)}) {
        double finest = 0.0;
        for (const int cuts : {6, 5, 4}) {  // 81,920, 20,480 and 5,120 triangles
            const Surface surface(lumpy(cuts));
            SurfacePoint contact;
            ASSERT_TRUE(surface.intersect_ray(100.0 * direction, -direction, contact));
            const double area = area_after(surface, contact.position, b, 3.5);
            if (finest == 0.0) finest = area;
            EXPECT_NEAR(area, finest, 0.05 * finest) << surface.triangles.size() << " triangles";
        }
        EXPECT_GT(finest, 400.0);
    }
}

TEST(Field, ObtuseTrianglesDoNotDelayBlood) {
    // Squashed to a tenth, the squares' triangles have angles up to 174 degrees.
    Organ organ = test::plane(200.0, 200, Cut::irregular);
    for (glm::vec3& p : organ.positions) p.x = 0.2f * p.x + 0.19f * p.z;
    const Surface surface(organ);
    const double area = area_after(surface, {0.1, 0.0, 0.3}, plain(), 2.5);
    EXPECT_NEAR(area, 100.0 * std::numbers::pi, 0.02 * 100.0 * std::numbers::pi);
}

TEST(Field, BloodIsDrawnAlongACrease) {
    Organ organ = test::plane(80.0, 80);
    for (glm::vec3& p : organ.positions) p.y = 0.8f * std::abs(p.x);
    const Surface surface(organ);
    BleedingParameters even = plain(), drawn = plain();
    drawn.crease_bias = 1.0;
    const auto along_and_across = [&](const BleedingParameters& b) {
        BleedField field(surface, {0.0, 0.0, 1.0});
        BleedingParameters level = b;
        level.gravity_bias = 0.0;
        field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}}}, level);
        field.update(2.0);
        double along = 0.0, across = 0.0;
        for (std::uint32_t v = 0; v < surface.positions.size(); ++v) {
            if (field.surface_values()[v].x <= 0.0f) continue;
            along = std::max(along, std::abs(surface.positions[v].z));
            across = std::max(across, std::abs(surface.positions[v].x) * std::hypot(1.0, 0.8));
        }
        return glm::dvec2(along, across);
    };
    const glm::dvec2 without = along_and_across(even), with = along_and_across(drawn);
    EXPECT_NEAR(without.x, without.y, 1.5);
    EXPECT_GT(with.x, 1.6 * without.x);
    EXPECT_LT(with.y, 1.4 * without.y);
}

TEST(Field, BloodCrossesNarrowGapsAndNoWideOnes) {
    const Organ sheet = test::plane(40.0, 40);
    const Surface surface(test::joined(sheet, sheet, {0.0f, 0.8f, 0.0f}));
    BleedingParameters b = plain();
    const auto other_sheet_at_contact = [&](double gap) {
        b.bridge_gap = gap;
        BleedField field(surface, down);
        field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}}}, b);
        field.update(2.0);
        const float value = field.surface_values()[surface.positions.size() / 2 + 20 * 41 + 20].x;
        return value == field.dry() ? -1.0f : value;
    };
    EXPECT_NEAR(other_sheet_at_contact(1.0), 8.0 - 0.8, 1e-4);
    EXPECT_EQ(other_sheet_at_contact(0.5), -1.0f);
    EXPECT_EQ(other_sheet_at_contact(0.0), -1.0f);
}

TEST(Field, TheVolumeOfAConeOfBlood) {
    BleedingParameters b = plain();
    b.deep_at = 20.0;  // deeper than any of it: the layer is a cone
    b.thickness = 0.5;
    const Surface surface(test::plane(44.0, 220));
    BleedField field(surface, down);
    field.set(std::vector<Wound>{{.position = {0.07, 0.0, 0.11}}}, b);
    field.update(3.0);
    const double wanted = std::numbers::pi * std::pow(12.0, 3) / 3.0 * b.thickness / b.deep_at;
    EXPECT_NEAR(field.amount().volume, wanted, 0.02 * wanted);
    b.deep_at = 0.1;  // everything except a rim has full thickness
    field.set(std::vector<Wound>{{.position = {0.07, 0.0, 0.11}}}, b);
    EXPECT_NEAR(field.amount().volume, 0.5 * field.amount().area, 0.03 * field.amount().area);
}

TEST(Field, SeekEqualsSteppingAtAnyFrameRateWithEverythingOn) {
    const Surface surface(test::joined(lumpy(4), test::sphere(20.0, 3), {0.0f, 0.0f, 55.0f}));
    BleedingParameters b;
    b.gravity_bias = 0.6;
    b.pulse_rate = 1.2;
    b.pulse_strength = 0.7;
    b.bridge_gap = 2.0;
    const std::vector<Wound> wounds{{.position = {0, 0, 36}},
                                    {.position = {10, 5, 33}, .start = 0.5, .strength = 2.0, .stop = 2.0},
                                    {.position = {-36, 0, 0}, .start = 1.0}};
    const std::vector<ToolContact> suction{
        {.action = ToolAction::suction, .time = 2.2, .duration = 0.6, .position = {0, 0, 36}, .to = {8, 0, 36}}};
    BleedField direct(surface, down);
    direct.set(wounds, b);
    direct.set_clearing(test::log_of(suction));
    for (const double rate : {13.0, 60.0}) {
        BleedField stepped(surface, down);
        stepped.set(wounds, b);
        stepped.set_clearing(test::log_of(suction));
        for (int frame = 0; frame <= static_cast<int>(6.0 * rate); ++frame) {
            stepped.update(frame / rate);
            if (frame % 11 != 0) continue;
            direct.update(frame / rate);
            ASSERT_TRUE(std::equal(direct.values().begin(), direct.values().end(), stepped.values().begin()))
                << rate << " fps, frame " << frame;
        }
        direct.update(0.0);
    }
}

TEST(Field, SuctionTakesBloodAwayAndAnOpenWoundFillsThePlaceAgain) {
    const Surface surface(test::plane(60.0, 120));
    BleedField field(surface, down);
    BleedingParameters b = plain();
    b.suction_radius = 10.0;
    field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}}}, b);
    field.set_clearing(test::log_of(std::vector<ToolContact>{
        {.action = ToolAction::suction, .time = 10.0, .duration = 1.0, .position = {0, 0, 0}}}));
    const auto disc = [](double r) { return std::numbers::pi * r * r; };
    field.update(9.0);
    EXPECT_NEAR(field.amount().area, disc(16), 0.02 * disc(16));
    field.update(11.0);
    EXPECT_NEAR(field.amount().area, disc(16) - disc(10), 0.08 * disc(16)) << "a ring is left";
    field.update(12.0);
    EXPECT_NEAR(field.amount().area, disc(16) - disc(10) + disc(4), 0.08 * disc(16)) << "4 mm/s from the wound";
    field.update(30.0);
    EXPECT_NEAR(field.amount().area, disc(16), 0.02 * disc(16));
    EXPECT_FALSE((field.changed().take(), field.update(40.0), !field.changed().empty())) << "full again: settled";
}

TEST(Field, ClotsDarkenShrinkAndStayUnderFreshBlood) {
    const Surface surface(test::plane(60.0, 60));
    BleedField field(surface, down);
    BleedingParameters b = plain();
    std::vector<Wound> wounds{{.position = {0.0, 0.0, 0.0}, .stop = 2.0}};
    field.set(wounds, b);
    const std::size_t middle = 30 * 61 + 30;
    field.update(1.9);
    EXPECT_EQ(field.values()[middle].y, 0.0f);
    field.update(30.0);
    EXPECT_EQ(field.values()[middle].y, 1.0f);
    EXPECT_NEAR(field.values()[middle].x, (8.0 + 3.0) * 0.95, 1e-4);
    wounds.push_back({.position = {0.0, 0.0, 0.0}, .start = 31.0});
    field.set(wounds, b);
    field.update(31.0 + 12.0 / 4.0);
    EXPECT_EQ(field.values()[middle].y, 0.0f) << "more has flowed than lies there";
}

TEST(Field, WoundStatesAndExtents) {
    const Surface surface(test::plane(40.0, 20));
    BleedField field(surface, down);
    field.set(std::vector<Wound>{{.position = {0, 0, 0}, .start = 1.0, .stop = 3.0}, {.position = {5, 0, 0}}}, plain());
    const auto states = [&](double time) {
        field.update(time);
        return std::pair(field.wounds()[0].state, field.wounds()[1].state);
    };
    EXPECT_EQ(states(0.5), std::pair(WoundState::waiting, WoundState::bleeding));
    EXPECT_EQ(states(2.0), std::pair(WoundState::bleeding, WoundState::bleeding));
    EXPECT_NEAR(field.wounds()[0].extent, 4.0, 1e-9);
    EXPECT_EQ(states(3.5), std::pair(WoundState::clotting, WoundState::bleeding));
    EXPECT_EQ(states(9.0), std::pair(WoundState::closed, WoundState::spent));
    EXPECT_NEAR(field.wounds()[1].extent, 16.0, 1e-9);
}

TEST(Field, KeptBloodStaysUntilItIsCleared) {
    const Surface surface(test::plane(40.0, 40));
    BleedField field(surface, down);
    BleedingParameters b = plain();
    b.suction_radius = 6.0;
    field.set(std::vector<Wound>{}, b);
    std::vector<glm::vec2> kept(surface.positions.size(), glm::vec2(BleedField::none, 0.0f));
    const std::size_t middle = 20 * 41 + 20;
    kept[middle] = {3.0f, 0.5f};
    field.keep({kept, 5.0});
    field.update(6.0);
    EXPECT_EQ(field.values()[middle], glm::vec2(3.0f, 0.5f));
    field.set(std::vector<Wound>{{.position = {4, 0, 0}, .start = 6.0}}, b);
    field.update(8.0);
    EXPECT_EQ(field.values()[middle], glm::vec2(4.0f, 0.0f)) << "fresh blood over it: 8 - 4 mm";
    field.set(std::vector<Wound>{}, b);
    field.set_clearing(
        test::log_of(std::vector<ToolContact>{{.action = ToolAction::suction, .time = 9.0, .duration = 1.0}}));
    field.update(9.0);
    EXPECT_EQ(field.values()[middle].x, 3.0f);
    field.update(11.0);
    EXPECT_EQ(field.values()[middle].x, field.dry());
}

TEST(Field, KeptBloodClotsWithTheWoundsOfItsTimeAndIsNotThereBefore) {
    const Surface surface(test::plane(40.0, 40));
    BleedField field(surface, down);
    field.set(std::vector<Wound>{{.position = {15, 0, 0}, .stop = 5.0}}, plain());
    std::vector<glm::vec2> kept(surface.positions.size(), glm::vec2(BleedField::none, 0.0f));
    const std::size_t far = 20 * 41 + 2;
    kept[far] = {3.0f, 0.0f};
    field.keep({kept, 5.0});
    field.update(30.0);
    EXPECT_EQ(field.values()[far], glm::vec2(3.0f, 1.0f));
    field.update(5.5);
    EXPECT_LT(field.values()[far].y, 0.2f) << "back in time, from where its wound had clotted";
    field.update(4.0);
    EXPECT_EQ(field.values()[far].x, field.dry());
    field.update(5.5);
    EXPECT_EQ(field.values()[far].x, 3.0f);
    EXPECT_LT(field.values()[far].y, 0.2f);
}

TEST(Field, ContactsInOddPlacesGiveClearResults) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    // A sheet, a fin standing on it (a non-manifold edge), and a sliver.
    Organ organ = test::plane(40.0, 40);
    organ.positions.push_back({0.0f, 10.0f, 0.0f});
    organ.indices.insert(organ.indices.end(), {20 * 41 + 20, 20 * 41 + 21, 41 * 41});
    organ.positions.push_back({1e-6f, 10.0f, 0.0f});
    organ.indices.insert(organ.indices.end(), {20 * 41 + 20, 41 * 41, 41 * 41 + 1});
    const Surface surface(organ);
    BleedField field(surface, down);
    const auto area = [&](const Wound& wound) {
        field.set(std::vector<Wound>{wound}, plain());
        field.update(2.0);
        for (const glm::vec2 value : field.values()) EXPECT_FALSE(std::isnan(value.x));
        return field.amount().area;
    };
    const double whole = area({.position = {8.3, 0.0, 8.2}});
    EXPECT_NEAR(whole, 64.0 * std::numbers::pi, 0.03 * whole);
    EXPECT_NEAR(area({.position = {20.0, 0.0, 2.0}}), whole / 2.0, 0.03 * whole) << "on a boundary: half a disc";
    EXPECT_NEAR(area({.position = {20.0, 0.0, 20.0}}), whole / 4.0, 0.03 * whole) << "in a corner: a quarter";
    EXPECT_GT(area({.position = {0.0, 0.0, 0.0}}), 0.97 * whole) << "on a non-manifold edge: all its sheets";
    EXPECT_GT(area({.position = {0.0, 8.0, 0.0}}), 0.0) << "on a sliver";
    EXPECT_NEAR(area({.position = {8.3, -50.0, 8.2}}), whole, 0.03 * whole) << "off the surface: the nearest place";
    EXPECT_EQ(area({.position = {nan, 0.0, 0.0}}), 0.0);
    EXPECT_EQ(area({.position = {0.0, infinity, 0.0}}), 0.0);
    EXPECT_EQ(area({.position = {8.3, 0.0, 8.2}, .start = nan}), 0.0);
    EXPECT_EQ(area({.position = {8.3, 0.0, 8.2}, .strength = nan}), 0.0);
    EXPECT_EQ(area({.position = {8.3, 0.0, 8.2}, .stop = nan}), 0.0);
    EXPECT_EQ(area({.position = {8.3, 0.0, 8.2}, .strength = -1.0}), 0.0);
    EXPECT_EQ(area({.position = {8.3, 0.0, 8.2}, .strength = infinity}), 0.0);
}

/// Settled wounds are not examined again while time advances. The result is the same, whatever is set and sought in
/// between.
TEST(Field, WhatHasSettledIsAsIfItWereWorkedOutAnew) {
    const Surface surface(test::plane(60.0, 40));
    std::mt19937 random(11);
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    BleedingParameters b = plain();
    b.coagulation_time = 1.0;
    std::vector<Wound> wounds;
    BleedField kept(surface, down);
    std::vector<ToolContact> suction;
    tool::Log log;
    double time = 0.0;
    for (int step = 0; step < 120; ++step) {
        if (step % 4 == 0) {
            const double start = number(0, 20),
                         stop = step % 8 == 0 ? start + number(-1, 6) : std::numeric_limits<double>::infinity();
            wounds.push_back({.position = {number(-25, 25), 0, number(-25, 25)},
                              .start = start,
                              .strength = number(0, 3),
                              .stop = stop});
            if (step % 40 == 20) wounds.erase(wounds.begin());
            kept.set(wounds, b);
        }
        if (step == 60 || step == 90) suction.clear();
        if (step == 50 || step == 70)
            suction.push_back({.action = ToolAction::suction, .time = time - 2.0, .duration = 2.0, .to = {10, 0, 0}});
        log.update(suction);
        kept.set_clearing(log);
        time = step % 13 == 12 ? number(0, 25) : time + number(0, 1);
        kept.update(time);
        BleedField fresh(surface, down);
        fresh.set(wounds, b);
        fresh.set_clearing(test::log_of(suction));
        fresh.update(time);
        ASSERT_TRUE(std::equal(fresh.values().begin(), fresh.values().end(), kept.values().begin())) << step;
        ASSERT_EQ(bleeding_wounds(fresh.wounds()), bleeding_wounds(kept.wounds())) << step;
        for (std::size_t i = 0; i < wounds.size(); ++i) {
            ASSERT_EQ(fresh.wounds()[i].state, kept.wounds()[i].state) << step << ": " << i;
            ASSERT_EQ(fresh.wounds()[i].extent, kept.wounds()[i].extent) << step << ": " << i;
        }
    }
}

/// Like a session: time advances, wounds open and close, and a tool is held to the blood, all over blood that settled
/// long ago. Every frame equals, to the last bit, that of a new field.
TEST(Field, ALongSessionIsAtEachFrameAsIfItWereWorkedOutAnew) {
    const Surface surface(lumpy(4));
    for (const unsigned seed : {1u, 2u, 3u, 4u}) {
        std::mt19937 random(seed);
        const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        const auto place = [&] {
            return surface.positions[static_cast<std::size_t>(number(0, double(surface.positions.size()) - 1))];
        };
        BleedingParameters b = plain();
        b.coagulation_time = 1.0;
        b.max_extent = 9.0;
        b.gravity_bias = 0.3;
        if (seed % 2 == 0) b.pulse_rate = 1.2, b.pulse_strength = 0.9;
        const std::vector<CurvePoint> points = {{5.0, 1.0}, {20.0, 0.2}, {30.0, 1.6}};
        const FactorCurve strength = seed > 2 ? FactorCurve(points) : FactorCurve();
        std::vector<Wound> wounds;
        std::vector<ToolContact> contacts;
        tool::Log log;
        BleedField kept(surface, down);
        kept.set_strength(strength);
        KeptBlood blood{.values = std::vector(surface.positions.size(), glm::vec2(BleedField::none, 0.0f)),
                        .time = 4.0};
        for (int i = 0; i < 60; ++i) blood.values[static_cast<std::size_t>(7 * i)] = {number(-1, 4), number(0, 1)};
        double time = 0.0;
        int refilled = 0, emptied = 0;
        double before = 0.0;
        for (int step = 0; step < 120; ++step, time += number(0.0, 0.3)) {
            if (step % 6 == 0) wounds.push_back({.position = place(), .start = time, .strength = number(0, 2)});
            if (step % 11 == 5)
                wounds[static_cast<std::size_t>(number(0, double(wounds.size()) - 1))].stop = time - number(0, 1);
            if (step % 17 == 3)
                wounds[static_cast<std::size_t>(number(0, double(wounds.size()) - 1))].strength = number(0, 2);
            if (step % 37 == 30) b.noise_strength = number(0, 3);
            if (step % 41 == 40) b.coagulation_time = number(0.2, 4);
            if (step % 53 == 52) time = std::max(0.0, time - number(0, 6));
            const bool is_held = step % 15 > 7;
            if (is_held && step % 15 == 8)
                contacts.push_back({.action = step % 30 > 15 ? ToolAction::suction : ToolAction::irrigation,
                                    .time = time,
                                    .duration = 0.01,
                                    .position = place(),
                                    .to = contacts.empty() ? place() : contacts.front().to});
            else if (is_held)
                contacts.back().duration = std::max(time - contacts.back().time, 0.01);
            if (step == 60) kept.keep(blood);
            kept.set(wounds, b);
            log.update(contacts, contacts.size() - (is_held ? 1 : 0));
            kept.set_clearing(log);
            kept.update(time);
            BleedField fresh(surface, down);
            fresh.set_strength(strength);
            if (step >= 60) fresh.keep(blood);
            fresh.set(wounds, b);
            fresh.set_clearing(log);
            fresh.update(time);
            const auto differ = std::mismatch(fresh.values().begin(), fresh.values().end(), kept.values().begin());
            ASSERT_EQ(differ.first, fresh.values().end())
                << seed << ", step " << step << ", vertex " << differ.first - fresh.values().begin() << ": "
                << kept.values()[static_cast<std::size_t>(differ.first - fresh.values().begin())].x << ", not "
                << differ.first->x;
            ASSERT_EQ(fresh.amount().area, kept.amount().area) << seed << ", step " << step;
            ASSERT_EQ(fresh.amount().volume, kept.amount().volume) << seed << ", step " << step;
            for (std::size_t i = 0; i < wounds.size(); ++i) {
                ASSERT_EQ(fresh.wounds()[i].wound, wounds[i]);
                ASSERT_EQ(kept.wounds()[i].wound, wounds[i]);
                ASSERT_EQ(fresh.wounds()[i].state, kept.wounds()[i].state) << seed << ", " << step << ": " << i;
                ASSERT_EQ(fresh.wounds()[i].bleeds, kept.wounds()[i].bleeds) << seed << ", " << step << ": " << i;
                ASSERT_EQ(fresh.wounds()[i].extent, kept.wounds()[i].extent) << seed << ", " << step << ": " << i;
            }
            const double area = kept.amount().area;
            emptied += area < before;
            refilled += area > before;
            before = area;
        }
        EXPECT_GT(emptied, 10) << "the tool takes blood away";
        EXPECT_GT(refilled, 10);
    }
}

/// Wounds that have clotted are one layer. What a tool takes of them, long before, between and long after their ends,
/// and while one ends, is at each frame what it would take of each wound if it were alone.
TEST(Field, OldBloodOfManyWoundsIsTheLargestOfEach) {
    const Surface surface(test::plane(40.0, 40));
    BleedingParameters b = plain();
    b.coagulation_time = 1.0;
    b.max_extent = 9.0;
    b.noise_strength = 1.5;
    b.irrigation_radius = 3.0;
    std::vector<Wound> wounds;
    for (int i = 0; i < 9; ++i)
        wounds.push_back({.position = {3.0 * (i % 3) - 3.0, 0.0, 3.0 * std::floor(i / 3) - 3.0},
                          .start = 0.4 * i,
                          .strength = 0.5 + 0.1 * i,
                          .stop = i == 8 ? std::numeric_limits<double>::infinity() : 2.0 + 1.7 * i});
    std::vector<ToolContact> contacts = {
        {.action = ToolAction::suction, .time = 3.0, .duration = 1.0, .position = {-6, 0, 0}, .to = {-4, 0, 0}},
        {.action = ToolAction::irrigation, .time = 6.0, .duration = 0.1, .position = {-9, 0, 2}, .to = {40, 0, 2}},
        {.action = ToolAction::suction, .time = 12.0, .duration = 0.5, .position = {0, 0, 8}, .to = {3, 0, 8}},
        {.action = ToolAction::suction, .time = 30.0, .duration = 3.0, .position = {6, 0, 0}, .to = {-6, 0, 3}},
    };
    tool::Log log;
    BleedField all(surface, down);
    std::vector<std::unique_ptr<BleedField>> alone;
    for (std::size_t i = 0; i < wounds.size(); ++i) alone.push_back(std::make_unique<BleedField>(surface, down));
    int capped = 0;
    const auto compare_at = [&](double time) {
        all.update(time);
        for (const auto& one : alone) one->update(time);
        for (std::uint32_t v = 0; v < surface.positions.size(); ++v) {
            glm::vec2 largest = alone[0]->surface_values()[v];
            for (const auto& one : alone) {
                const glm::vec2 value = one->surface_values()[v];
                if (value.x > largest.x || (value.x == largest.x && value.y < largest.y)) largest = value;
            }
            ASSERT_EQ(all.surface_values()[v], largest) << time << ", vertex " << v;
            capped += largest.x > all.dry() && largest.y == 1.0f;
        }
    };
    const auto tell = [&](std::size_t known) {
        log.update(std::span(contacts).first(known));
        all.set(wounds, b);
        all.set_clearing(log);
        for (std::size_t i = 0; i < wounds.size(); ++i) {
            alone[i]->set(std::span(wounds).subspan(i, 1), b);
            alone[i]->set_clearing(log);
        }
    };
    for (double time = 0.0; time < 36.0; time += 0.3) {
        if (time > 6.0 && time < 16.0) contacts[1].duration = time - 6.0;  // held on, and slower and slower
        if (time > 25.0) wounds[0].sealed = wounds[8].sealed = 25.0;       // clips, on one that clotted long ago, too
        tell(time < 3.0 ? 0 : time < 6.1 ? 1 : time < 20.0 ? 2 : contacts.size());  // some are told of late
        ASSERT_NO_FATAL_FAILURE(compare_at(time));
        BleedField fresh(surface, down);
        fresh.set(wounds, b);
        fresh.set_clearing(log);
        fresh.update(time);
        ASSERT_TRUE(std::equal(fresh.values().begin(), fresh.values().end(), all.values().begin())) << time;
    }
    EXPECT_GT(capped, 1000) << "clotted blood is left";
    ASSERT_NO_FATAL_FAILURE(compare_at(9.0)) << "back to before some ended";
    ASSERT_NO_FATAL_FAILURE(compare_at(33.5));
}

TEST(Field, ThousandsOfWoundsEachCount) {
    const Surface surface(test::plane(200.0, 100));
    BleedField field(surface, down);
    BleedingParameters b = plain();
    b.max_extent = 1.2;
    std::vector<Wound> wounds;
    for (int i = 0; i < 4000; ++i)
        wounds.push_back({.position = {3.0 * (i % 64) - 95.0, 0.0, 3.0 * (i / 64) - 95.0}, .start = 0.001 * i});
    field.set(wounds, b);
    field.update(100.0);
    EXPECT_EQ(field.wounds().size(), 4000u);
    for (const WoundStatus& w : field.wounds()) ASSERT_EQ(w.state, WoundState::spent);
    // The distance of each vertex is that to its nearest wound.
    for (std::uint32_t v = 0; v < surface.positions.size(); v += 17) {
        double nearest = 1e9;
        for (const Wound& w : wounds) nearest = std::min(nearest, glm::distance(surface.positions[v], w.position));
        if (nearest < 1.2) {
            EXPECT_NEAR(field.surface_values()[v].x, 1.2 - nearest, 1e-3);
        } else {
            EXPECT_LE(field.surface_values()[v].x, 1e-3);
        }
    }
}

}  // namespace
}  // namespace lapfx::bleeding
