#include "app/preview/events.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/contacts.h"

namespace lapfx::app {
namespace {

using lapfx::test::contact;

/// A path of three pieces, with another event between them in the list.
std::vector<ToolContact> path_and_cut() {
    return {contact(ToolAction::cauterise, 1, 0.5, {0, 0, 0}, {5, 0, 0}),
            contact(ToolAction::cut, 1.2, 0, {9, 9, 9}, {9, 9, 9}),
            contact(ToolAction::cauterise, 2, 1, {5, 5, 0}, {0, 5, 0}),
            contact(ToolAction::cauterise, 1.5, 0.5, {5, 0, 0}, {5, 5, 0})};
}

TEST(Events, ContactsThatGoOnFromEachOtherAreOneStroke) {
    const std::vector<Stroke> strokes = strokes_of(path_and_cut());
    ASSERT_EQ(strokes.size(), 2U);
    EXPECT_EQ(strokes[0].events, (std::vector<std::size_t>{0, 3, 2}));
    EXPECT_EQ(strokes[0].start, 1);
    EXPECT_EQ(strokes[0].end, 3);
    EXPECT_EQ(strokes[1].action, ToolAction::cut);
    EXPECT_EQ(strokes[1].end, 1.2);
}

TEST(Events, AGapInTimeOrPlacePartsThem) {
    std::vector<ToolContact> events = path_and_cut();
    events[2].time = 2.01;
    EXPECT_EQ(strokes_of(events).size(), 3U);
    events = path_and_cut();
    events[2].position.x = 5.6;
    EXPECT_EQ(strokes_of(events).size(), 3U);
}

TEST(Events, TwoToolsOfOneActionAtOnceAreTwoStrokes) {
    std::vector<ToolContact> events;
    for (int i = 0; i < 4; ++i)
        for (const double x : {0.0, 50.0})
            events.push_back({.action = ToolAction::cut,
                              .time = 1.0 * i,
                              .duration = 1.0,
                              .position = {x, i, 0},
                              .to = {x, i + 1.0, 0}});
    const std::vector<Stroke> strokes = strokes_of(events);
    ASSERT_EQ(strokes.size(), 2U);
    EXPECT_EQ(strokes[0].events, (std::vector<std::size_t>{0, 2, 4, 6}));
    EXPECT_EQ(strokes[1].events, (std::vector<std::size_t>{1, 3, 5, 7}));
    EXPECT_EQ(strokes[1].end, 4.0);
}

TEST(Events, AStrokeMovesWhole) {
    std::vector<ToolContact> events = path_and_cut();
    move_stroke(events, strokes_of(events)[0], 4);
    EXPECT_EQ(events[0].time, 4);
    EXPECT_EQ(events[3].time, 4.5);
    EXPECT_EQ(events[2].time, 5);
    EXPECT_EQ(events[1].time, 1.2) << "the cut stays";
    EXPECT_EQ(strokes_of(events).size(), 2U);
}

TEST(Events, AStrokeIsStretchedInProportion) {
    std::vector<ToolContact> events = path_and_cut();
    stretch_stroke(events, strokes_of(events)[0], 1, 5);
    EXPECT_DOUBLE_EQ(events[0].duration, 1);
    EXPECT_DOUBLE_EQ(events[3].time, 2);
    EXPECT_DOUBLE_EQ(events[2].time, 3);
    EXPECT_DOUBLE_EQ(events[2].end(), 5);
    EXPECT_EQ(strokes_of(events)[0].events.size(), 3U) << "still one stroke";
    stretch_stroke(events, strokes_of(events)[1], 1.2, 2.2);
    EXPECT_DOUBLE_EQ(events[1].duration, 1) << "also what lasted no time";
}

TEST(Events, TimesStayAllowed) {
    std::vector<ToolContact> events = path_and_cut();
    move_stroke(events, strokes_of(events)[0], -10);
    for (const ToolContact& event : events) EXPECT_GE(event.time, 0);
    move_stroke(events, strokes_of(events)[0], 1e9);
    for (const ToolContact& event : events) EXPECT_LE(event.time, last_event_time);
}

TEST(Events, ErasingKeepsTheOthersInOrder) {
    std::vector<ToolContact> events = path_and_cut();
    erase_events(events, std::vector<std::size_t>{0, 3, 77});
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].action, ToolAction::cut);
    EXPECT_EQ(events[1].time, 2);
}

TEST(Events, AStraightPathBecomesOneContact) {
    std::vector<ToolContact> recorded;
    for (int i = 0; i < 20; ++i)
        recorded.push_back(contact(ToolAction::cut, 1 + 0.1 * i, 0.1, {i, 0, 0}, {i + 1, 0, 0}));
    const std::vector<ToolContact> made = simplified(recorded);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_DOUBLE_EQ(made[0].time, 1);
    EXPECT_DOUBLE_EQ(made[0].duration, 2);
    EXPECT_EQ(made[0].to, glm::dvec3(20, 0, 0));
}

TEST(Events, ACurvedPathStaysWithinTheTolerance) {
    std::vector<ToolContact> recorded;
    const auto at = [](int i) { return 10.0 * glm::dvec3(std::cos(i * 0.05), std::sin(i * 0.05), 0); };
    for (int i = 0; i < 60; ++i) recorded.push_back(contact(ToolAction::cauterise, 0.1 * i, 0.1, at(i), at(i + 1)));
    const std::vector<ToolContact> made = simplified(recorded);
    EXPECT_LT(made.size(), 20U);
    EXPECT_GT(made.size(), 3U);
    EXPECT_EQ(strokes_of(made).size(), 1U) << "no gaps";
    for (int i = 0; i < 60; ++i) {
        const double t = 0.1 * i;
        double nearest = 1e9;
        for (const ToolContact& c : made)
            if (t >= c.time - 1e-6 && t <= c.end() + 1e-6) nearest = std::min(nearest, glm::distance(c.tip(t), at(i)));
        EXPECT_LE(nearest, 0.21) << t;
    }
}

}  // namespace
}  // namespace lapfx::app
