// What a fit may change: keys, bounds, and where the search is.
#include "match/fit/free_parameter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lapfx::match {
namespace {

std::vector<FreeParameter> of(std::vector<std::string> keys, const document::Content& tuned = {}) {
    return free_parameters(tuned, keys);
}

/// All that is said about `keys`.
std::vector<std::string> faults_of(std::vector<std::string> keys, const document::Content& tuned = {}) {
    try {
        of(std::move(keys), tuned);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        std::vector<std::string> reasons;
        for (const Fault& fault : error.faults()) {
            EXPECT_EQ(fault.place, "--parameters");
            reasons.push_back(fault.reason);
        }
        return reasons;
    }
    return {};
}

document::Content with_event() {
    document::Content tuned;
    tuned.scene.events = {{.time = 2.0}};
    return tuned;
}

TEST(FreeParameter, IsOfThePresetOrOfTheScene) {
    document::Content tuned = with_event();
    const auto found = of({"bleeding.speed", "events.0.time"}, tuned);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_FALSE(found[0].of_scene);
    EXPECT_TRUE(found[1].of_scene);
    EXPECT_EQ(found[0].get(tuned), 4.0);
    EXPECT_EQ(found[1].get(tuned), 2.0);
    found[0].set(tuned, 7.5), found[1].set(tuned, 3.25);
    EXPECT_EQ(tuned.preset.bleeding.speed, 7.5);
    EXPECT_EQ(tuned.scene.events[0].time, 3.25);
}

TEST(FreeParameter, StaysWithinTheBoundsOfItsRow) {
    document::Content tuned;
    const FreeParameter speed = of({"bleeding.speed"})[0];
    EXPECT_EQ(speed.minimum, 0.0);
    EXPECT_EQ(speed.maximum, 60.0);
    speed.set(tuned, 1000.0);
    EXPECT_EQ(tuned.preset.bleeding.speed, 60.0);
}

TEST(FreeParameter, MayHaveBoundsOfItsOwn) {
    const FreeParameter speed = of({"bleeding.speed=2..8.5"})[0];
    EXPECT_EQ(speed.key, "bleeding.speed");
    EXPECT_EQ(speed.minimum, 2.0);
    EXPECT_EQ(speed.maximum, 8.5);
    document::Content tuned;
    speed.set(tuned, 1.0);
    EXPECT_EQ(tuned.preset.bleeding.speed, 2.0);
}

TEST(FreeParameter, OfALogarithmHasEqualStepsForEqualFactors) {
    const FreeParameter extent = of({"bleeding.max_extent"})[0];  // its row has steps of 0.5 mm
    EXPECT_NEAR(extent.coordinate(40.0 - 0.5) - extent.coordinate(20.0 - 0.5), std::log(2.0), 1e-12);
    for (const double value : {0.0, 0.5, 16.0, 200.0})
        EXPECT_NEAR(extent.value(extent.coordinate(value)), value, 1e-9 * std::max(value, 1.0));
    EXPECT_EQ(extent.value(1e3), 200.0);
    EXPECT_EQ(extent.value(-1e3), 0.0);
}

TEST(FreeParameter, OfATimeIsInSeconds) {
    const FreeParameter time = of({"events.0.time"}, with_event())[0];
    EXPECT_NEAR(time.coordinate(7.0) - time.coordinate(2.0), 5.0, 1e-12);
}

TEST(FreeParameter, EveryFaultIsTold) {
    using testing::ElementsAre;
    using testing::HasSubstr;
    EXPECT_THAT(faults_of({"bleeding.sped", "bleeding.color_thin", "bleeding.speed", "bleeding.speed"}),
                ElementsAre(HasSubstr("bleeding.speed"), HasSubstr("is no number"), HasSubstr("is named twice")));
    EXPECT_THAT(faults_of({}), ElementsAre(HasSubstr("nothing is free")));
    EXPECT_THAT(faults_of({"bleeding.speed=8..2"}), ElementsAre(HasSubstr("not below the upper")));
    EXPECT_THAT(faults_of({"bleeding.speed=2..90"}), ElementsAre(HasSubstr("leaves what is allowed: 0 to 60 mm/s")));
    EXPECT_THAT(faults_of({"bleeding.speed=5..8"}), ElementsAre(HasSubstr("is 4, outside of the bounds 5..8")));
    for (const char* bounds : {"bleeding.speed=", "bleeding.speed=2", "bleeding.speed=2..", "bleeding.speed=2..x",
                               "bleeding.speed=nan..3", "bleeding.speed=2..8 "})
        EXPECT_THAT(faults_of({bounds}), ElementsAre(HasSubstr("is not LOW..HIGH"))) << bounds;
}

}  // namespace
}  // namespace lapfx::match
