#include "cautery/wound_list.h"

#include <gtest/gtest.h>

#include "bleeding/wound.h"
#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

constexpr glm::dvec3 here{0.0}, beside{0.8, 0.0, 0.0};

/// The possible wounds before the tool arrives at 2 s.
struct Before {
    const char* name;
    std::vector<ToolContact> contacts;
};
std::vector<Before> all_before() {
    return {{"whole tissue", {}},
            {"a cut", {at(here, 0.0, 0.0, ToolAction::cut)}},
            {"a tear", {at(here, 0.0, 0.0, ToolAction::tear)}},
            {"a tear, then a cut", {at(here, 0.0, 0.0, ToolAction::tear), at(here, 0.5, 0.0, ToolAction::cut)}},
            {"a cut beside it", {at(beside, 0.0, 0.0, ToolAction::cut)}},
            {"a cut at the same time", {at(here, 2.0, 0.0, ToolAction::cut)}},
            {"a cut a moment before", {at(here, 1.999, 0.0, ToolAction::cut)}},
            {"a cut while it clots", {at(here, 0.0, 0.0, ToolAction::cut), at(here, 1.0, 0.4, ToolAction::coagulate)}},
            {"a burn", {at(here, -9.0, 2.0)}}};
}

TEST(WoundRecord, StopsByHeatOrByAClipWhicheverIsFirstAndEitherMayBeTakenBack) {
    double held = never;
    WoundList list([&](const glm::dvec3&) { return held; });
    ASSERT_TRUE(list.add({.wound = {.position = here, .start = 1.0}}, 0));
    const auto told = [&] { return std::pair(list.wounds()[0].stop, list.wounds()[0].sealed); };
    EXPECT_EQ(told(), std::pair(never, never));
    held = 5.0;
    list.seal();
    EXPECT_EQ(told(), std::pair(5.0, 5.0));
    EXPECT_FALSE(list.is_closed(0)) << "a clip is no heat";
    EXPECT_TRUE(list.close(0, 7.0, 1)) << "heat does, whatever a clip does before it";
    EXPECT_TRUE(list.is_closed(0));
    EXPECT_EQ(told(), std::pair(5.0, 5.0));
    held = never;
    list.seal();
    EXPECT_EQ(told(), std::pair(7.0, never)) << "the clip is gone";
    held = 9.0;
    list.seal();
    EXPECT_EQ(told(), std::pair(7.0, 9.0));
    list.truncate(1);
    EXPECT_EQ(told(), std::pair(9.0, 9.0)) << "the heat is gone";
    EXPECT_FALSE(list.is_closed(0));
    ASSERT_TRUE(list.add({.wound = {.position = here, .start = 9.0}}, 2)) << "what a clip holds counts for no other";
    EXPECT_EQ(list.wounds()[1].sealed, 9.0);
}

class Divisions : public testing::TestWithParam<HeatModel> {
  protected:
    std::vector<Wound> wounds(std::vector<ToolContact> contacts, std::initializer_list<ToolContact> then) {
        contacts.insert(contacts.end(), then);
        CauteryParameters parameters;
        parameters.model = GetParam();
        LoggedCautery cautery(flat(), {});
        cautery.set(contacts, parameters);
        cautery.update(16.0);
        return {cautery.wounds().begin(), cautery.wounds().end()};
    }
    /// Of those that never close.
    static int open(const std::vector<Wound>& wounds) {
        int count = 0;
        for (const Wound& wound : wounds) count += wound.stop == never ? 1 : 0;
        return count;
    }
};

TEST_P(Divisions, ABurnOpensWhateverWasThere) {
    const Wound fresh = wounds({}, {at(here, 2.0, 3.0)}).at(0);
    for (const Before& before : all_before()) {
        const std::vector<Wound> found = wounds(before.contacts, {at(here, 2.0, 3.0)});
        ASSERT_EQ(open(found), 1) << before.name;
        for (const Wound& wound : found) {
            if (wound.stop != never) continue;
            // Warm tissue divides sooner.
            EXPECT_GE(wound.start, 2.0) << before.name;
            EXPECT_LE(wound.start, fresh.start + 1e-9) << before.name;
            EXPECT_EQ(wound.strength, fresh.strength) << before.name;
        }
    }
}

TEST_P(Divisions, BloodOfABurnDoesNotDependOnTheWoundBeforeIt) {
    BleedingParameters b;
    b.max_extent = 100.0;
    const auto extents = [&](ToolAction action) {
        double most = 0.0;
        for (const Wound& wound : wounds({at(here, 0.0, 0.0, action)}, {at(here, 2.0, 3.0)}))
            most = std::max(most, bleeding::source_value(wound, b, 7.0));
        return most;
    };
    EXPECT_NEAR(extents(ToolAction::cut), extents(ToolAction::tear), 1e-9);
    EXPECT_NEAR(extents(ToolAction::cut), 4.0 * (7.0 - 2.0 - 143.0 / 220.0), 0.4);
}

TEST_P(Divisions, CoagulationClosesWhateverIsThere) {
    for (const Before& before : all_before())
        EXPECT_EQ(open(wounds(before.contacts, {at(here, 2.0, 3.0, ToolAction::coagulate)})), 0) << before.name;
}

TEST_P(Divisions, ACutOpensWhateverHasClosedBefore) {
    for (const Before& before : all_before())
        for (const ToolAction action : {ToolAction::cut, ToolAction::tear}) {
            const std::vector<Wound> found =
                wounds(before.contacts, {at(here, 2.0, 1.0, ToolAction::coagulate), at(here, 12.0, 0.0, action)});
            ASSERT_EQ(open(found), 1) << before.name;
            EXPECT_EQ(found.back().start, 12.0) << before.name;
        }
}

TEST_P(Divisions, ACutIntoTissueThatAnotherToolHeatsIsSealedAsOneJustBefore) {
    for (const double time : {1.9, 2.0, 2.05, 2.5, 3.5})
        for (const ToolAction heat : {ToolAction::coagulate, ToolAction::cauterise}) {
            const std::vector<Wound> found = wounds({at(here, time, 0.0, ToolAction::cut)}, {at(here, 2.0, 3.0, heat)});
            for (const Wound& wound : found) {
                if (wound.start != time) continue;
                EXPECT_GE(wound.stop, std::max(time, 2.1)) << time;
                EXPECT_LE(wound.stop, std::max(time, 2.15) + 0.02) << time;
            }
            EXPECT_EQ(open(found), heat == ToolAction::cauterise ? 1 : 0) << time;
        }
}

INSTANTIATE_TEST_SUITE_P(Models, Divisions, testing::Values(HeatModel::radial, HeatModel::bioheat),
                         [](const auto& model) {
                             return std::string(model.param == HeatModel::radial ? "radial" : "bioheat");
                         });

TEST(WoundList, AnOpenWoundThatStandsForAHotDivisionIsThatBurnFromThenOn) {
    WoundList list;
    EXPECT_TRUE(list.add({.wound = {.start = 0.0}}, 1));
    EXPECT_EQ(list.burn_of(0).time, never);
    EXPECT_FALSE(list.add({.wound = {.start = 1.0}, .tip = beside, .by_heat = true}, 2));
    EXPECT_EQ(list.stands_for(), 0u);
    EXPECT_EQ(list.burn_of(0).time, 1.0);
    EXPECT_EQ(list.burn_of(0).tip, beside);
    list.truncate(2);  // as if the heat had never divided here
    EXPECT_EQ(list.burn_of(0).time, never);
    EXPECT_TRUE(list.close(0, 1.5, 2));
    EXPECT_FALSE(list.close(0, 1.6, 3)) << "it is closed already";
    EXPECT_TRUE(list.add({.wound = {.start = 1.6}}, 4)) << "a closed wound stands for nothing";
    EXPECT_EQ(list.stands_for(), WoundList::none);
}

TEST(WoundList, OfSeveralAtOneTimeTheStrongestComesFirst) {
    const Division weak{.wound = {.start = 1.0, .strength = 0.5}, .tip = {}, .by_heat = true};
    const Division strong{.wound = {.start = 1.0, .strength = 0.9}}, early{.wound = {.start = 0.5, .strength = 0.1}};
    EXPECT_TRUE(opens_before(strong, weak));
    EXPECT_FALSE(opens_before(weak, strong));
    EXPECT_TRUE(opens_before(early, strong));
    EXPECT_FALSE(opens_before(strong, strong));
}

}  // namespace
}  // namespace lapfx::cautery
