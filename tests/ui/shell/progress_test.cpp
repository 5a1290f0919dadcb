#include "ui/shell/progress.h"

#include <gtest/gtest.h>

#include "ui/core/node.h"
#include "ui/shell/status_bar.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TEST(Progress, DurationsAreReadAsPeopleSayThem) {
    Harness ui([](Ui& u) {
        EXPECT_EQ(duration_text(u, 0), "1 s");
        EXPECT_EQ(duration_text(u, 3.2), "4 s");
        EXPECT_EQ(duration_text(u, 60), "1 min 00 s");
        EXPECT_EQ(duration_text(u, 79.5), "1 min 20 s");
        EXPECT_EQ(duration_text(u, 7500), "2 h 05 min");
        EXPECT_EQ(duration_text(u, -1), "");
        EXPECT_EQ(duration_text(u, unknown), "");
        EXPECT_EQ(duration_text(u, std::numeric_limits<double>::infinity()), "");
    });
}

TEST(Progress, TellsThatItMayEndSooner) {
    Harness ui([&](Ui& u) { progress(u, "Fit", 0.5, {.seconds_left = 80, .at_most = true}); });
    EXPECT_EQ(ui.text("Fit"), "50 %, up to 1 min 20 s left");
}

TEST(Progress, TellsHowFarAndHowLong) {
    double fraction = 0.426;
    Harness ui([&](Ui& u) { progress(u, "Fit", fraction, {.seconds_left = 80, .text = "3 of 7"}); });
    EXPECT_EQ(ui.text("Fit"), "42 %, 3 of 7, 1 min 20 s left");
    EXPECT_DOUBLE_EQ(ui.value("Fit"), 0.426);
    EXPECT_EQ(ui.node("Fit").role, Role::progress);
    EXPECT_EQ(ui.output().wake_at, never);
    fraction = 0.9999;
    EXPECT_EQ(ui.frame().text("Fit").substr(0, 4), "99 %") << "100 % is done";
    fraction = 7;
    EXPECT_EQ(ui.frame().value("Fit"), 1);
}

TEST(Progress, WhatNobodyKnowsRunsToAndFroUnlessMotionIsReduced) {
    Harness ui([](Ui& u) { progress(u, "Reading", unknown); });
    EXPECT_TRUE(ui.is("Reading", Is::busy));
    EXPECT_EQ(ui.text("Reading"), "");
    EXPECT_NEAR(ui.output().wake_at, ui.time + 1.0 / 30, 1e-6);
    EXPECT_TRUE(ui.frame(0.1).output().changed);
    ui.ui().set_reduced_motion(true);
    ui.frame();
    EXPECT_EQ(ui.output().wake_at, never);
    EXPECT_FALSE(ui.frame(0.1).output().changed);
}

TEST(Progress, CanBeGivenUpByPointerAndKeys) {
    int cancelled = 0;
    Harness ui([&](Ui& u) { cancelled += progress(u, "Fit", 0.5, {.cancellable = true}) ? 1 : 0; });
    ui.click("Cancel Fit");
    ui.focus("Cancel Fit").key(Key::enter);
    EXPECT_EQ(cancelled, 2);
    EXPECT_EQ(ui.tip("Cancel Fit"), "Cancel Fit");
}

TEST(StatusBar, TextsAreLiveAndCutOnesAreWholeInTheirTooltip) {
    std::string text = "Ready";
    Harness ui(
        [&](Ui& u) {
            StatusBar bar(u);
            status_text(u, "State", text);
            spacer(u);
            status_text(u, "Frame time", "8.1 ms", {.number = true, .width = 6, .tip = "Median of 60"});
        },
        {300, 100});
    EXPECT_EQ(ui.node("Status bar/State").role, Role::status);
    EXPECT_EQ(ui.text("Status bar/State"), "Ready");
    EXPECT_EQ(ui.tip("Status bar/State"), "");
    EXPECT_EQ(ui.tip("Status bar/Frame time"), "Median of 60");
    EXPECT_EQ(ui.rect("Status bar/Frame time").w, 84);
    text = "Decoding a plate with a very long name that does not fit into the window";
    ui.frame().frame();
    EXPECT_EQ(ui.tip("Status bar/State"), text);
    EXPECT_LE(ui.rect("Status bar/State").right(), ui.rect("Status bar/Frame time").x);
    EXPECT_EQ(ui.rect("Status bar/Frame time").w, 84) << "numbers stay whole";
}

}  // namespace
}  // namespace lapfx::ui
