#include "cautery/heat_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lapfx::cautery {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// 200 degrees/s, cut at 177 (0.7 s), coagulate at 57 (0.1 s).
CauteryParameters parameters() {
    CauteryParameters c;
    c.heat_rate = 200.0;
    c.cut_temperature = 177.0;
    c.coagulation_temperature = 57.0;
    c.char_temperature = 137.0;
    c.heat_spread = 2.0;
    c.maximum_temperature = 400.0;
    return c;
}

ToolContact at(glm::dvec3 place, double time, double duration, ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = time, .duration = duration, .position = place, .to = place};
}

std::vector<Wound> wounds(std::initializer_list<ToolContact> contacts, const CauteryParameters& c = parameters()) {
    return wounds_of(std::vector<ToolContact>(contacts), c);
}

TEST(Heat, RisesWithTimeAndPowerUpToTheMaximum) {
    const CauteryParameters c = parameters();
    ToolContact contact = at({0, 0, 0}, 1.0, 5.0);
    EXPECT_EQ(peak_temperature(contact, c, {0, 0, 0}, 0.5), 37.0);
    EXPECT_EQ(peak_temperature(contact, c, {0, 0, 0}, 1.0), 37.0);
    EXPECT_DOUBLE_EQ(peak_temperature(contact, c, {0, 0, 0}, 1.5), 137.0);
    EXPECT_DOUBLE_EQ(peak_temperature(contact, c, {0, 0, 0}, 2.0), 237.0);
    EXPECT_DOUBLE_EQ(peak_temperature(contact, c, {0, 0, 0}, 4.0), 400.0);
    contact.power = 0.25;
    EXPECT_DOUBLE_EQ(peak_temperature(contact, c, {0, 0, 0}, 2.0), 87.0);
    contact.power = 0.0;
    EXPECT_EQ(peak_temperature(contact, c, {0, 0, 0}, 2.0), 37.0);
}

TEST(Heat, FallsOffRadiallyWithARadiusThatGrowsWithTheRootOfTime) {
    const CauteryParameters c = parameters();
    const ToolContact contact = at({0, 0, 0}, 0.0, 5.0);
    // After 1 s R = 1.5 + 2; after 0.25 s R = 1.5 + 1.
    EXPECT_NEAR(peak_temperature(contact, c, {3.5, 0, 0}, 1.0), 37.0 + 200.0 * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(peak_temperature(contact, c, {0, 2.5, 0}, 0.25), 37.0 + 50.0 * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(peak_temperature(contact, c, {0, 0, 5.0}, 0.25), 37.0 + 50.0 * std::exp(-4.0), 1e-9);
}

TEST(Heat, ThePeakStaysWhenTheToolLeaves) {
    const ToolContact contact = at({0, 0, 0}, 1.0, 0.5);
    EXPECT_DOUBLE_EQ(peak_temperature(contact, parameters(), {0, 0, 0}, 99.0), 137.0);
}

TEST(Heat, ColdActionsHeatNothing) {
    for (const ToolAction action : {ToolAction::cut, ToolAction::tear}) {
        const ToolContact contact = at({0, 0, 0}, 0.0, 5.0, action);
        EXPECT_EQ(peak_temperature(contact, parameters(), {0, 0, 0}, 3.0), 37.0);
        EXPECT_EQ(heated_reach(contact, parameters()), 0.0);
    }
}

TEST(Heat, AMovingTipHeatsEachPlaceWhileItPassesOverIt) {
    const CauteryParameters c = parameters();
    // 30 mm in 2 s: over its own width of 3 mm in 0.2 s, so each place rises by 40 degrees.
    const ToolContact contact{.time = 1.0, .duration = 2.0, .position = {0, 0, 0}, .to = {30, 0, 0}};
    for (const double x : {0.0, 10.0, 30.0})
        EXPECT_NEAR(peak_temperature(contact, c, {x, 0, 0}, 50.0), 77.0, 1e-9) << x;
    EXPECT_EQ(peak_temperature(contact, c, {30, 0, 0}, 2.7), 37.0) << "not there yet";
    EXPECT_NEAR(peak_temperature(contact, c, {30, 0, 0}, 2.9), 57.0, 1e-9) << "half way over it";
    EXPECT_NEAR(peak_temperature(contact, c, {15, 0, 0}, 2.0), 57.0, 1e-9);
}

TEST(Char, FollowsThePeak) {
    const CauteryParameters c = parameters();
    EXPECT_EQ(char_of(37.0, c), 0.0);
    EXPECT_EQ(char_of(57.0, c), 0.0);
    EXPECT_NEAR(char_of(97.0, c), 0.35 * 0.5, 1e-12);
    EXPECT_NEAR(char_of(137.0, c), 0.35, 1e-12);
    EXPECT_NEAR(char_of(212.0, c), 0.35 + 0.65 * 0.5, 1e-12);
    EXPECT_NEAR(char_of(287.0, c), 1.0, 1e-12);
    EXPECT_NEAR(char_of(1000.0, c), 1.0, 1e-12);
}

TEST(Wounds, OpenWhenTheCutTemperatureIsReached) {
    const std::vector<Wound> found = wounds({at({1, 2, 3}, 5.0, 1.0)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].position, glm::dvec3(1, 2, 3));
    EXPECT_DOUBLE_EQ(found[0].start, 5.7);
    EXPECT_EQ(found[0].stop, never);
    EXPECT_EQ(found[0].strength, 1.0);
    EXPECT_TRUE(wounds({at({1, 2, 3}, 5.0, 0.69)}).empty()) << "too short";
}

TEST(Wounds, PowerDelaysThem) {
    ToolContact contact = at({0, 0, 0}, 0.0, 2.0);
    contact.power = 0.5;
    contact.strength = 0.3;
    const std::vector<Wound> found = wounds({contact});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_DOUBLE_EQ(found[0].start, 1.4);
    EXPECT_EQ(found[0].strength, 0.3);
    contact.power = 0.0;
    EXPECT_TRUE(wounds({contact}).empty());
}

TEST(Wounds, NotBelowTheMaximumTemperature) {
    CauteryParameters c = parameters();
    c.maximum_temperature = 170.0;
    EXPECT_TRUE(wounds({at({0, 0, 0}, 0.0, 60.0)}, c).empty());
}

TEST(Wounds, ColdActionsOpenAtOnceWhateverThePower) {
    for (const ToolAction action : {ToolAction::cut, ToolAction::tear}) {
        ToolContact contact = at({0, 0, 0}, 3.0, 0.01, action);
        contact.power = 0.0;
        const std::vector<Wound> found = wounds({contact});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_DOUBLE_EQ(found[0].start, 3.0);
    }
}

TEST(Wounds, CoagulatingOpensNone) {
    EXPECT_TRUE(wounds({at({0, 0, 0}, 0.0, 60.0, ToolAction::coagulate)}).empty());
}

TEST(Wounds, AMovingTipOpensARow) {
    // 10 mm in 2 s; the knife needs no time: 5 wounds 2.5 mm apart, each when the tip arrives.
    const ToolContact contact{
        .action = ToolAction::cut, .time = 1.0, .duration = 2.0, .position = {0, 0, 0}, .to = {10, 0, 0}};
    const std::vector<Wound> found = wounds({contact});
    ASSERT_EQ(found.size(), 5u);
    const double dwell = 2.0 * 3.0 / 10.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].position.x, 2.5 * static_cast<double>(i), 1e-12);
        EXPECT_NEAR(found[i].start, 1.0 + 0.25 * static_cast<double>(i) * (2.0 - dwell), 1e-12);
    }
}

TEST(Wounds, AHotTipThatMovesTooFastOpensNone) {
    // 30 mm: each place is heated for a tenth of the time, and needs 0.7 s.
    ToolContact contact{.time = 0.0, .duration = 6.9, .position = {0, 0, 0}, .to = {30, 0, 0}};
    EXPECT_TRUE(wounds({contact}).empty());
    contact.duration = 7.1;
    EXPECT_EQ(wounds({contact}).size(), 13u);
    EXPECT_NEAR(wounds({contact}).front().start, 0.7, 1e-9);
    EXPECT_NEAR(wounds({contact}).back().start, 7.1 * 0.9 + 0.7, 1e-9);
}

TEST(Wounds, CoagulatingStopsTheWoundsInReach) {
    const ToolContact knife = at({0, 0, 0}, 0.0, 0.1, ToolAction::cut);
    // Warm enough after 0.1 s; heated for 1 s, it reaches 1.5 + 2 mm, and 2.5 mm around.
    const auto stop_of = [&](double x, double duration = 1.0) {
        const std::vector<Wound> found = wounds({knife, at({x, 0, 0}, 4.0, duration, ToolAction::coagulate)});
        return found.at(0).stop;
    };
    EXPECT_DOUBLE_EQ(stop_of(0.0), 4.1);
    EXPECT_DOUBLE_EQ(stop_of(5.9), 4.1);
    EXPECT_EQ(stop_of(6.1), never);
    EXPECT_EQ(stop_of(0.0, 0.09), never) << "too short to get warm";
}

TEST(Wounds, TheFirstCoagulationCountsAndOnlyALaterOne) {
    const ToolContact knife = at({0, 0, 0}, 3.0, 0.1, ToolAction::cut);
    const auto coagulate = [](double time) { return at({0, 0, 0}, time, 1.0, ToolAction::coagulate); };
    EXPECT_DOUBLE_EQ(wounds({knife, coagulate(9.0), coagulate(6.0)}).at(0).stop, 6.1);
    EXPECT_EQ(wounds({coagulate(1.0), knife}).at(0).stop, never) << "the wound was not there yet";
}

TEST(Wounds, AMovingCoagulationStopsEachWoundWhenItHasBeenHeated) {
    const std::vector<ToolContact> contacts{
        at({0, 0, 0}, 0.0, 0.1, ToolAction::cut),
        at({20, 0, 0}, 0.0, 0.1, ToolAction::cut),
        {.action = ToolAction::coagulate, .time = 10.0, .duration = 10.0, .position = {0, 0, 0}, .to = {20, 0, 0}}};
    const std::vector<Wound> found = wounds_of(contacts, parameters());
    ASSERT_EQ(found.size(), 2u);
    // The tip stays 1.5 s at each place and arrives at the last one at 10 + 10 - 1.5.
    EXPECT_NEAR(found[0].stop, 10.1, 1e-9);
    EXPECT_NEAR(found[1].stop, 18.6, 1e-9);
    EXPECT_GT(peak_temperature(contacts[2], parameters(), found[1].position, found[1].stop + 1e-6), 57.0);
    EXPECT_LT(peak_temperature(contacts[2], parameters(), found[1].position, found[1].stop - 1e-6), 57.0);
}

TEST(Wounds, CauteryClosesTheWoundsThatWereOpenBeforeItAndNotItsOwn) {
    // 0.1 s at 200 degrees a second from 37 passes the coagulation temperature of these parameters.
    EXPECT_NEAR(wounds({at({0, 0, 0}, 0.0, 0.1, ToolAction::cut), at({0, 0, 0}, 4.0, 0.3)}).at(0).stop, 4.1, 1e-9);
    EXPECT_EQ(wounds({at({0, 0, 0}, 4.0, 3.0)}).at(0).stop, never);
    EXPECT_EQ(wounds({at({0, 0, 0}, 5.0, 0.1, ToolAction::cut), at({0, 0, 0}, 4.0, 0.3)}).at(0).stop, never);
}

}  // namespace
}  // namespace lapfx::cautery
