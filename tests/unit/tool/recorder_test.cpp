#include "tool/recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "unit/cautery/support.h"

namespace lapfx::tool {
namespace {

using cautery::along;
using cautery::at;

ToolSample sample(double time, glm::dvec3 position, ToolAction action = ToolAction::cauterise) {
    return {.time = time, .position = position, .touching = true, .action = action};
}
ToolSample lifted(double time, glm::dvec3 position = glm::dvec3(0.0)) {
    return {.time = time, .position = position};
}

/// 1 kHz samples of a path from `from` to `to` s.
template <class Path>
void feed(Recorder& recorder, double from, double to, Path path, ToolAction action = ToolAction::cauterise) {
    const int count = static_cast<int>(std::lround((to - from) * 1000.0));
    for (int i = 0; i <= count; ++i) {
        const double time = from + i * 0.001;
        recorder.add(sample(time, path(time), action));
    }
}

/// Where the tip is at `time` according to the contacts.
glm::dvec3 tip(std::span<const ToolContact> contacts, double time) {
    for (const ToolContact& contact : contacts)
        if (time <= contact.end()) return contact.tip(time);
    return contacts.back().to;
}

TEST(Recorder, AStandingTipIsOneContactThatGrows) {
    Recorder recorder;
    const auto place = [](double) { return glm::dvec3(1, 2, 3); };
    feed(recorder, 5.0, 6.5, place);
    ASSERT_EQ(recorder.contacts().size(), 1u);
    EXPECT_NEAR(recorder.contacts()[0].duration, 1.5, 1e-9);
    feed(recorder, 6.501, 9.0, place);
    ASSERT_EQ(recorder.contacts().size(), 1u);
    const ToolContact& contact = recorder.contacts()[0];
    EXPECT_EQ(contact.time, 5.0);
    EXPECT_NEAR(contact.duration, 4.0, 1e-9);
    EXPECT_EQ(contact.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(contact.to, glm::dvec3(1, 2, 3));
    recorder.add(lifted(9.01));
    EXPECT_NEAR(recorder.contacts()[0].end(), 9.01, 1e-9) << "until the sample that says so";
    feed(recorder, 9.02, 9.1, place);
    EXPECT_EQ(recorder.contacts().size(), 2u) << "touching again is a contact of its own";
    EXPECT_EQ(recorder.contacts()[1].time, 9.02);
}

TEST(Recorder, AStraightStrokeGoesOnEveryTenthOfASecond) {
    Recorder recorder;
    feed(recorder, 1.0, 2.0, [](double t) { return glm::dvec3(20.0 * (t - 1.0), 0, 0); });
    const auto contacts = recorder.contacts();
    ASSERT_GE(contacts.size(), 9u);
    ASSERT_LE(contacts.size(), 11u);
    for (std::size_t i = 1; i < contacts.size(); ++i) {
        EXPECT_EQ(contacts[i].time, contacts[i - 1].end());
        EXPECT_EQ(contacts[i].position, contacts[i - 1].to);
        EXPECT_TRUE(goes_on(contacts[i - 1], contacts[i]));
    }
    EXPECT_NEAR(contacts.back().end(), 2.0, 1e-9);
    EXPECT_NEAR(contacts.back().to.x, 20.0, 1e-9);
}

TEST(Recorder, ACurveIsFollowedWithinTheTolerance) {
    Recorder recorder;
    const auto circle = [](double t) {
        const double a = 2.0 * std::numbers::pi * t;  // 63 mm/s
        return glm::dvec3(10.0 * std::cos(a), 0.0, 10.0 * std::sin(a));
    };
    feed(recorder, 0.0, 2.0, circle);
    const auto contacts = recorder.contacts();
    EXPECT_GT(contacts.size(), 20u);
    EXPECT_LT(contacts.size(), 60u);
    for (int i = 0; i <= 2000; ++i)
        EXPECT_LE(glm::distance(tip(contacts, i * 0.001), circle(i * 0.001)), Recorder::tolerance + 1e-9) << i;
}

TEST(Recorder, AStopIsNotSmearedOut) {
    Recorder recorder;
    const auto path = [](double t) {
        return glm::dvec3(t < 1.0 ? 5.0 * t : t < 3.0 ? 5.0 : 5.0 - 5.0 * (t - 3.0), 0, 0);
    };
    feed(recorder, 0.0, 4.0, path);
    for (int i = 0; i <= 4000; ++i)
        EXPECT_LE(glm::distance(tip(recorder.contacts(), i * 0.001), path(i * 0.001)), Recorder::tolerance + 1e-9) << i;
}

TEST(Recorder, ActionPowerAndStrengthBeginAnotherContact) {
    Recorder recorder;
    recorder.add(sample(0.0, {0, 0, 0}));
    recorder.add(sample(0.05, {0, 0, 0}));
    recorder.add(sample(0.06, {0, 0, 0}, ToolAction::coagulate));
    ToolSample weaker = sample(0.10, {0, 0, 0}, ToolAction::coagulate);
    weaker.power = 0.5;
    recorder.add(weaker);
    weaker.time = 0.15;
    weaker.strength = 2.0;
    recorder.add(weaker);
    const auto contacts = recorder.contacts();
    ASSERT_EQ(contacts.size(), 4u);
    EXPECT_EQ(contacts[0].action, ToolAction::cauterise);
    EXPECT_NEAR(contacts[0].end(), 0.06, 1e-12);
    EXPECT_EQ(contacts[1].action, ToolAction::coagulate);
    EXPECT_NEAR(contacts[1].end(), 0.10, 1e-12);
    EXPECT_EQ(contacts[2].power, 0.5);
    EXPECT_EQ(contacts[3].strength, 2.0);
}

TEST(Recorder, AGapEndsTheContactBeforeIt) {
    Recorder recorder;
    recorder.add(sample(0.0, {0, 0, 0}));
    recorder.add(sample(0.09, {0, 0, 0}));
    recorder.add(sample(0.2, {0, 0, 0}));
    ASSERT_EQ(recorder.contacts().size(), 2u);
    EXPECT_NEAR(recorder.contacts()[0].end(), 0.09, 1e-12);
    EXPECT_EQ(recorder.contacts()[1].time, 0.2);
}

TEST(Recorder, DropsAndCountsBadSamples) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    Recorder recorder;
    EXPECT_TRUE(recorder.add(sample(1.0, {0, 0, 0})));
    std::uint64_t dropped = 0;
    const auto refused = [&](const ToolSample& s) {
        EXPECT_FALSE(recorder.add(s));
        EXPECT_EQ(recorder.dropped(), ++dropped);
    };
    for (const double bad : {nan, infinity, -infinity, 1e30}) {
        refused(sample(bad, {0, 0, 0}));
        refused(sample(1.01, {0, bad, 0}));
    }
    refused(sample(1.0, {0, 0, 0}));
    refused(sample(0.5, {0, 0, 0}));
    ToolSample s = sample(1.01, {0, 0, 0});
    s.power = nan;
    refused(s);
    s.power = -1.0;
    refused(s);
    s.power = 1.0;
    s.strength = infinity;
    refused(s);
    s.strength = 1.0;
    s.power = 9.0;
    EXPECT_TRUE(recorder.add(s)) << "as much as there is";
    ASSERT_EQ(recorder.contacts().size(), 1u);
    EXPECT_EQ(recorder.contacts()[0].power, 1.0);
    EXPECT_NEAR(recorder.contacts()[0].duration, 0.01, 1e-12);
}

TEST(Recorder, AGivenLogIsContinuedBehind) {
    Recorder recorder;
    feed(recorder, 0.0, 0.05, [](double) { return glm::dvec3(0.0); });
    const std::vector given{at({1, 0, 0}, 0.0, 1.0), at({2, 0, 0}, 1.0, 1.0)};
    recorder.set(given);
    ASSERT_EQ(recorder.contacts().size(), 2u);
    recorder.add(sample(3.0, {0, 0, 0}));
    recorder.add(sample(3.05, {0, 0, 0}));
    ASSERT_EQ(recorder.contacts().size(), 3u);
    EXPECT_NEAR(recorder.contacts()[2].duration, 0.05, 1e-12);
    EXPECT_EQ(recorder.contacts()[1].duration, 1.0);
}

TEST(Recorder, TellsHowManyContactsAreAsTheyWere) {
    Recorder recorder;
    EXPECT_FALSE(recorder.changed());
    recorder.add(sample(0.0, {0, 0, 0}));
    EXPECT_TRUE(recorder.changed());
    EXPECT_EQ(recorder.take_same(), 0u);
    EXPECT_FALSE(recorder.changed());
    recorder.add(sample(0.01, {0, 0, 0}));
    EXPECT_EQ(recorder.take_same(), 0u) << "the only one has grown";
    recorder.add(lifted(0.02));
    recorder.take_same();
    recorder.add(lifted(0.03));
    EXPECT_FALSE(recorder.changed());
    recorder.add(sample(0.04, {9, 0, 0}));
    EXPECT_TRUE(recorder.changed());
    EXPECT_EQ(recorder.take_same(), 1u);
    recorder.add(sample(0.05, {9, 0, 0}));
    recorder.add(sample(0.06, {9, 0, 0}, ToolAction::cut));
    EXPECT_EQ(recorder.take_same(), 1u) << "the second has grown before the third began";
    const std::vector<ToolContact> all(recorder.contacts().begin(), recorder.contacts().end());
    recorder.set(all);
    EXPECT_FALSE(recorder.changed());
    recorder.set(std::span(all).first(2));
    EXPECT_TRUE(recorder.changed()) << "fewer";
    EXPECT_EQ(recorder.take_same(), 2u);
    std::vector<ToolContact> other = all;
    other[1].power = 0.5;
    recorder.set(other);
    EXPECT_EQ(recorder.take_same(), 1u);
}

/// 1 kHz samples of a stroke have the effect of the stroke.
TEST(Recorder, RecordedHeatIsThatOfTheWholeContact) {
    const ToolContact whole = along({-8, 0, 0.3}, {8, 0, 0.3}, 1.0, 20.0);
    Recorder recorder;
    feed(recorder, whole.time, whole.end(), [&](double t) { return whole.tip(t); });
    cautery::LoggedCautery recorded(cautery::flat(), {}), exact(cautery::flat(), {});
    recorded.set(recorder.contacts(), cautery::simple_parameters());
    exact.set(std::vector{whole}, cautery::simple_parameters());
    recorded.update(30.0);
    exact.update(30.0);
    for (std::size_t v = 0; v < exact.marks().size(); ++v) {
        ASSERT_NEAR(recorded.marks()[v].x, exact.marks()[v].x, 1e-3);
        ASSERT_NEAR(recorded.marks()[v].y, exact.marks()[v].y, 1e-3);
    }
    ASSERT_EQ(recorded.wounds().size(), exact.wounds().size());
    EXPECT_GE(exact.wounds().size(), 5u);
    for (std::size_t w = 0; w < exact.wounds().size(); ++w) {
        EXPECT_NEAR(recorded.wounds()[w].start, exact.wounds()[w].start, 1e-3);
        EXPECT_LT(glm::distance(recorded.wounds()[w].position, exact.wounds()[w].position), 1e-3);
    }
}

}  // namespace
}  // namespace lapfx::tool
