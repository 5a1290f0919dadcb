#include "lapfx/amounts.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "lapfx/tool.h"
#include "support/contacts.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

/// Discs on a plane: no noise, no bias; every cut bleeds equally.
Preset plain() {
    Preset preset;
    BleedingParameters& b = preset.bleeding;
    b.speed = 4.0;
    b.max_extent = 16.0;
    b.noise_strength = b.gravity_bias = b.crease_bias = b.rivulets = 0.0;
    return preset;
}

using test::contact;

class AmountsOnAPlane : public testing::Test {
  protected:
    static AmountsModel& model() {
        static AmountsModel one(test::plane(80.0, 80), {.gravity = {0.0, -1.0, 0.0}});
        return one;
    }
    static int bleeding(double time) { return model().at(time).bleeding_wounds; }
    static double area(double time) { return model().at(time).blood_area; }
};

TEST(AmountRows, EachLeadsToItsMemberAndIsToldApart) {
    const Amounts amounts{.blood_area = 1.5,
                          .blood_volume = 2.5,
                          .wounds = 3,
                          .bleeding_wounds = 4,
                          .left_out_wounds = 5,
                          .lost_samples = 6,
                          .haze = 7.5,
                          .emission = 8.5,
                          .burnt_area = 9.5};
    std::set<double> values;
    std::set<std::string_view> keys, titles;
    for (const AmountRow& row : amount_rows) {
        values.insert(row.member.of(amounts));
        EXPECT_TRUE(keys.insert(row.key).second && titles.insert(row.title).second) << row.key;
        EXPECT_TRUE(row.help.ends_with('.')) << row.key;
    }
    EXPECT_EQ(values, (std::set{1.5, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5, 8.5, 9.5}));
}

TEST(AmountRows, MakeTheColumnsOfTheTable) {
    EXPECT_EQ(amounts_head(),
              "time_s,blood_area_mm2,blood_volume_mm3,wounds,bleeding_wounds,haze,burnt_area_mm2,emission\n");
    EXPECT_EQ(amounts_line(0.25, {.blood_area = 812.3456,
                                  .blood_volume = 1e6,
                                  .wounds = 12,
                                  .bleeding_wounds = 3,
                                  .left_out_wounds = 1,
                                  .lost_samples = 2,
                                  .haze = 0.123456,
                                  .emission = 1.5,
                                  .burnt_area = 20.0}),
              "0.2500,812.346,1000000.000,12,3,0.12346,20.000,1.5000\n");
}

TEST_F(AmountsOnAPlane, AWoundThatFillsAClearedPlaceAgainIsBleeding) {
    model().set(plain(), std::vector{contact(ToolAction::cut, 0.0, 0.0), contact(ToolAction::irrigation, 6.0, 2.0)});
    EXPECT_EQ(bleeding(3.9), 1);
    EXPECT_EQ(bleeding(5.0), 0) << "at its largest extent";
    EXPECT_EQ(bleeding(7.0), 1) << "it flows, and is rinsed away";
    const double whole = area(5.0);
    double before = area(8.0);
    EXPECT_LT(before, 0.2 * whole);
    for (const double time : {9.0, 10.0, 11.0, 11.9}) {
        EXPECT_GT(area(time), before + 20.0) << time;
        EXPECT_EQ(bleeding(time), 1) << time;
        before = area(time);
    }
    EXPECT_EQ(bleeding(12.3), 0);
    EXPECT_NEAR(area(12.3), whole, 0.01 * whole);
    EXPECT_EQ(area(60.0), area(12.3));
    EXPECT_EQ(bleeding(9.0), 1) << "in any order of times";
    EXPECT_EQ(bleeding(5.0), 0);
}

TEST_F(AmountsOnAPlane, WhatIsClearedElsewhereReopensNothing) {
    const glm::dvec3 aside{32.0, 0.0, 0.0};  // suction reaches 8 mm, the blood 16 mm
    model().set(plain(),
                std::vector{contact(ToolAction::cut, 0.0, 0.0), contact(ToolAction::suction, 6.0, 1.0, aside)});
    for (const double time : {5.0, 6.5, 7.5, 9.0}) EXPECT_EQ(bleeding(time), 0) << time;
}

TEST_F(AmountsOnAPlane, OnlyTheWoundWhoseBloodWasTakenBleedsAgain) {
    const glm::dvec3 a{-20.0, 0.0, 0.0}, b{20.0, 0.0, 0.0};
    Preset preset = plain();
    preset.bleeding.max_extent = 8.0;
    model().set(preset, std::vector{contact(ToolAction::cut, 0.0, 0.0, a), contact(ToolAction::cut, 0.0, 0.0, b),
                                    contact(ToolAction::suction, 4.0, 1.0, b)});
    EXPECT_EQ(bleeding(3.0), 0);
    EXPECT_EQ(bleeding(5.5), 1);
    EXPECT_EQ(bleeding(7.5), 0);
}

TEST_F(AmountsOnAPlane, AClosedWoundFillsNothingAgain) {
    model().set(plain(), std::vector{contact(ToolAction::cut, 0.0, 0.0), contact(ToolAction::coagulate, 6.0, 1.0),
                                     contact(ToolAction::irrigation, 7.0, 1.0)});
    EXPECT_EQ(bleeding(7.4), 1) << "clotting: what still flows comes to where it was rinsed away";
    const double left = area(9.0);
    EXPECT_EQ(bleeding(9.0), 0);
    EXPECT_EQ(area(20.0), left);
}

/// For logs of everything that a tool does: where blood spreads, a wound reports it.
TEST_F(AmountsOnAPlane, BloodSpreadsOnlyWhileAWoundIsToldAsBleeding) {
    std::mt19937 random(15);
    const auto chance = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    constexpr ToolAction actions[] = {ToolAction::cut,       ToolAction::tear,    ToolAction::cauterise,
                                      ToolAction::coagulate, ToolAction::suction, ToolAction::irrigation};
    int spreading = 0, standing = 0;
    for (int log = 0; log < 25; ++log) {
        Preset preset = plain();
        preset.bleeding.max_extent = chance(3.0, 14.0);
        preset.bleeding.noise_strength = log % 3 == 0 ? 2.0 : 0.0;
        preset.bleeding.pulse_rate = log % 4 == 1 ? 1.2 : 0.0;
        preset.bleeding.pulse_strength = 0.6;
        std::vector<ToolContact> contacts{contact(ToolAction::cut, 0.0, 0.0)};
        double time = 0.0;
        for (int i = 0; i < 9; ++i) {
            time += chance(0.2, 2.5);
            ToolContact c = contact(actions[random() % 6], time, chance(0.3, 2.5), {chance(-9, 9), 0.0, chance(-9, 9)});
            if (random() % 2 == 0) c.to = {chance(-12, 12), 0.0, chance(-12, 12)};
            contacts.push_back(c);
        }
        Curves curves;
        if (log % 5 == 2) curves.bleeding_strength = {{3.0, 1.0}, {4.0, 0.0}, {6.0, 0.0}, {7.0, 1.5}};
        model().set(preset, contacts, curves);
        Amounts before = model().at(-0.05);
        for (double now = 0.0; now < 30.0; now += 0.05) {
            const Amounts after = model().at(now);
            const bool told = before.bleeding_wounds > 0 || after.bleeding_wounds > 0;
            if (after.blood_area > before.blood_area + 1e-9) {
                EXPECT_TRUE(told) << "log " << log << ", " << now << " s: " << before.blood_area << " to "
                                  << after.blood_area;
                ++spreading;
            } else if (!told) {
                ++standing;
            }
            before = after;
        }
        EXPECT_EQ(before.bleeding_wounds > 0, model().at(60.0).blood_area > before.blood_area) << "log " << log;
    }
    EXPECT_GT(spreading, 1000);
    EXPECT_GT(standing, 1000);
}

/// Continued heat widens the burn, and burnt tissue stays burnt; seeking back removes it.
TEST_F(AmountsOnAPlane, TheBurntAreaIsThatOfItsDisc) {
    Preset preset = plain();
    preset.cautery = {};
    model().set(preset, std::vector{contact(ToolAction::cauterise, 1.0, 3.0)});
    EXPECT_EQ(model().at(0.9).burnt_area, 0.0);
    const double half = model().at(2.5).burnt_area, whole = model().at(4.0).burnt_area;
    EXPECT_GT(half, 3.0);
    EXPECT_GT(whole, 1.1 * half);
    EXPECT_EQ(model().at(60.0).burnt_area, whole);
    // The number of browned vertices, each for the 1 mm2 around it, except at the rim.
    EXPECT_LT(whole, std::numbers::pi * 36.0) << "a burn of 3 s is not 6 mm wide";
    EXPECT_EQ(model().at(2.5).burnt_area, half) << "to the last bit";
    model().set(preset, {});
    EXPECT_EQ(model().at(60.0).burnt_area, 0.0);
}

TEST_F(AmountsOnAPlane, SmokeComesWhileTissueBurnsTimesItsPowerAndTheScenesFactor) {
    Preset preset = plain();
    preset.smoke.clips.push_back({.file = "any.mp4"});
    std::vector contacts{contact(ToolAction::cauterise, 1.0, 2.0), contact(ToolAction::coagulate, 2.0, 2.0, {20, 0, 0}),
                         contact(ToolAction::cauterise, 1.0, 9.0, {0, 60, 0})};
    contacts[1].power = 0.5;
    model().set(preset, contacts);
    for (const auto& [time, expected] : {std::pair{0.5, 0.0}, {1.5, 1.0}, {2.5, 1.5}, {3.5, 0.5}, {4.5, 0.0}})
        EXPECT_NEAR(model().at(time).emission, expected, 1e-12) << time;
    Curves curves;
    curves.emission = {{1.0, 1.0}, {2.0, 3.0}};
    model().set(preset, contacts, curves);
    EXPECT_NEAR(model().at(1.5).emission, 2.0, 1e-12);
    EXPECT_NEAR(model().at(2.5).emission, 4.5, 1e-12);
    preset.smoke.clips.clear();
    model().set(preset, contacts);
    EXPECT_EQ(model().at(1.5).emission, 0.0) << "no clips, no smoke";
}

TEST_F(AmountsOnAPlane, WoundsTellWhatTheyDo) {
    model().set(plain(),
                std::vector{contact(ToolAction::cut, 1.0, 0.0), contact(ToolAction::cut, 3.0, 0.0, {20, 0, 0})});
    model().at(2.0);
    ASSERT_EQ(model().wounds().size(), 2u);
    EXPECT_EQ(model().wounds()[0].state, WoundState::bleeding);
    EXPECT_NEAR(model().wounds()[0].extent, 4.0, 1e-9);
    EXPECT_EQ(model().wounds()[1].state, WoundState::waiting);
}

}  // namespace
}  // namespace lapfx
