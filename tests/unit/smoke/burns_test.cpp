#include "smoke/burns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cautery/recorder.h"

namespace lapfx::smoke {
namespace {

ToolContact contact(double from, double to, double x_from, double x_to, ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = from, .duration = to - from, .position = {x_from, 0, 0}, .to = {x_to, 0, 0}};
}

std::vector<std::pair<double, double>> spans(const std::vector<ToolContact>& contacts, double after = -1e9) {
    BurnList burns;
    burns.set(contacts, std::vector<double>(contacts.size(), 0.0));
    std::vector<std::pair<double, double>> all;
    for (const Burn& burn : burns.after(after)) all.emplace_back(burn.start, burn.end);
    return all;
}

using Spans = std::vector<std::pair<double, double>>;

TEST(Burns, JoinContactsThatGoOnInTimeAndPlace) {
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2, 5), contact(2, 4, 5, 5)}), (Spans{{0, 4}}));
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1 + 1e-7, 2, 2.3, 5)}), (Spans{{0, 2}})) << "rounded, one sample on";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1.01, 2, 2, 5)}), (Spans{{0, 1}, {1.01, 2}})) << "a pause";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2.6, 5)}), (Spans{{0, 1}, {1, 2}})) << "elsewhere";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2, 5, ToolAction::coagulate)}), (Spans{{0, 1}, {1, 2}}));
}

// What a haptic thread sends becomes many contacts, and they are one burn: also where the pedal gives another power.
TEST(Burns, ARecordedStayIsOne) {
    cautery::Recorder recorder;
    for (int i = 0; i <= 2000; ++i) {
        const double time = 5.0 + 0.001 * i, angle = 2.0 * (time - 5.0);
        recorder.add({.time = time,
                      .position = {20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0},
                      .touching = true,
                      .action = ToolAction::cauterise,
                      .power = i < 1200 ? 0.5 : 0.9});
    }
    const std::span<const ToolContact> contacts = recorder.contacts();
    EXPECT_GT(contacts.size(), 18u);
    const auto found = spans({contacts.begin(), contacts.end()});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].first, 5.0, 1e-9);
    EXPECT_NEAR(found[0].second, 7.0, 1e-9);
}

TEST(Burns, KeepTwoToolsApart) {
    EXPECT_EQ(spans({contact(0, 1, 0, 1), contact(0, 1, 50, 51), contact(1, 2, 1, 2), contact(1, 3, 51, 52)}),
              (Spans{{0, 2}, {0, 3}}));
}

TEST(Burns, LeaveOutWhatIsColdOrCannotBe) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(
        spans({contact(0, 1, 0, 1, ToolAction::cut), contact(0, 1, 0, 1, ToolAction::suction), contact(nan, 1, 0, 1),
               contact(0, 1, nan, 1), contact(1, 0, 0, 1), contact(0, INFINITY, 0, 1), contact(3, 4, 0, 1)}),
        (Spans{{3, 4}}));
}

TEST(Burns, FindTheirPartAtATime) {
    const std::vector<ToolContact> contacts{contact(0, 1, 0, 2), contact(1, 2, 2, 5), contact(2, 4, 5, 9)};
    BurnList burns;
    burns.set(contacts, std::vector{0.1, 0.2, 0.3});
    const Burn& burn = burns.after(0.0).front();
    for (const auto& [time, fat] : {std::pair{-1.0, 0.1}, {0.5, 0.1}, {1.0, 0.2}, {1.9, 0.2}, {2.0, 0.3}, {9.0, 0.3}})
        EXPECT_EQ(burn.at(time).fat, fat) << time;
}

TEST(Burns, ThatAreLongOverAreSkipped) {
    std::vector<ToolContact> contacts;
    for (int i = 0; i < 100; ++i) contacts.push_back(contact(i, i + 0.5, 0, 0));
    EXPECT_EQ(spans(contacts, 97.6), (Spans{{98, 98.5}, {99, 99.5}}));
    contacts[3].duration = 200.0;
    EXPECT_EQ(spans(contacts, 97.6).size(), 97u) << "one that still goes on, and those that come after it";
    EXPECT_TRUE(spans(contacts, 300.0).empty());
}

TEST(Burns, KeepTheirNumberWhileTheyGoOn) {
    std::vector<ToolContact> contacts{contact(0, 1, 0, 2), contact(3, 4, 2, 5)};
    BurnList burns;
    for (int i = 0; i < 50; ++i) {
        burns.set(contacts, std::vector<double>(contacts.size(), 0.0));
        ASSERT_EQ(burns.after(3.0).size(), 1u);
        EXPECT_EQ(burns.after(3.0).front().number, 1u);
        contacts.push_back(contact(4 + 0.1 * i, 4.1 + 0.1 * i, 5, 5));
    }
}

}  // namespace
}  // namespace lapfx::smoke
