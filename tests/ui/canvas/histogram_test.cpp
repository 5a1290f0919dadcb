#include "ui/canvas/histogram.h"

#include <gmock/gmock.h>

#include "ui/canvas/drag_handle.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

TEST(FullCount, LeavesOutTheEnds) {
    EXPECT_EQ(full_count(std::vector<std::uint32_t>{900, 3, 7, 2, 500}), 7U);
    EXPECT_EQ(full_count(std::vector<std::uint32_t>{900, 0, 0, 500}), 900U) << "nothing but ends";
    EXPECT_EQ(full_count(std::vector<std::uint32_t>{4, 5}), 5U);
    EXPECT_EQ(full_count({}), 0U);
}

TEST(BarHeight, IsLinearOrLogarithmicAndCut) {
    EXPECT_EQ(bar_height(25, 100, false), 0.25F);
    EXPECT_EQ(bar_height(300, 100, false), 1);
    EXPECT_EQ(bar_height(0, 100, true), 0);
    EXPECT_EQ(bar_height(5, 0, false), 0);
    EXPECT_NEAR(bar_height(9, 99, true), 0.5, 1e-6);
    for (std::uint32_t n = 1; n < 100; ++n) EXPECT_LT(bar_height(n - 1, 100, true), bar_height(n, 100, true));
}

struct Shown {
    std::vector<std::uint32_t> bins = std::vector<std::uint32_t>(256, 10);
    HistogramData data{.bins = bins};
    Levels levels{.low = 51, .high = 204};
    HistogramOptions options{.reset = {.low = 20, .high = 230}, .width = px(562)};
    bool log = false, disabled = false;
    HistogramResult last;
    Edit low, high;  ///< everything that was reported for each handle
    int began = 0, changed = 0, committed = 0, cancelled = 0;
    Harness ui{[this](Ui& u) {
        options.log_counts = &log;
        u.push_disabled(disabled);
        last = histogram(u, "Luma", data, &levels, options);
        u.pop_disabled();
        low |= last.low, high |= last.high;
        const Edit any = last.any();
        began += any.began, changed += any.changed, committed += any.committed, cancelled += any.cancelled;
    }};
    std::string text_after_move(glm::vec2 to) { return ui.move(to).text("Luma"); }
};
constexpr float plot_left = 26, plot_width = 510;  // px: a grip has room on both sides; a level is 2 px wide

TEST(Histogram, HandlesStandAtTheirValues) {
    Shown s;
    EXPECT_EQ(s.ui.rect("Luma/Low").right(), plot_left + 102);
    EXPECT_EQ(s.ui.rect("Luma/High").x, plot_left + 408);
    EXPECT_EQ(s.ui.value("Luma/Low"), 51);
    EXPECT_EQ(s.ui.node("Luma/Low").number->maximum, 203);
    EXPECT_EQ(s.ui.node("Luma/High").number->minimum, 52);
}

TEST(Histogram, HandlesAreDraggedAlongTheAxis) {
    Shown s;
    s.ui.drag("Luma/Low", {20, 50});
    EXPECT_NEAR(s.levels.low, 61, 1e-4);
    s.ui.drag("Luma/High", {-40, 0}, Mods::shift);
    EXPECT_NEAR(s.levels.high, 202, 1e-4);
    EXPECT_EQ(s.began, 2);
    EXPECT_EQ(s.committed, 2);
    s.ui.drag("Luma/Low", {7, 0}, Mods::command);
    EXPECT_EQ(s.levels.low, std::round(s.levels.low)) << "Ctrl: whole steps";
}

TEST(Histogram, LowNeverPassesHigh) {
    Shown s;
    s.ui.drag("Luma/Low", {1000, 0});
    EXPECT_EQ(s.levels.low, 203);
    s.ui.drag("Luma/Low", {-2000, 0});
    EXPECT_EQ(s.levels.low, 0);
    s.levels.low = 100;
    s.ui.frame().drag("Luma/High", {-2000, 0});
    EXPECT_EQ(s.levels.high, 101);
}

TEST(Histogram, HandlesThatMeetCanBothBeTaken) {
    for (const double at : {0.0, 100.0, 254.0}) {
        Shown s;
        s.levels = {.low = at, .high = at + 1};
        s.ui.frame();
        EXPECT_FALSE(s.ui.rect("Luma/Low").overlaps(s.ui.rect("Luma/High"))) << at;
        EXPECT_GE(s.ui.rect("Luma/Low").x, 0);
        EXPECT_LE(s.ui.rect("Luma/High").right(), 562);
    }
}

TEST(Histogram, KeysStepFineAndToTheEnds) {
    Shown s;
    s.ui.focus("Luma/Low").key(Key::right).key(Key::up);
    EXPECT_EQ(s.levels.low, 53);
    s.ui.key(Key::left, Mods::shift);
    EXPECT_NEAR(s.levels.low, 52.9, 1e-9);
    s.ui.key(Key::page_up);
    EXPECT_NEAR(s.levels.low, 62.9, 1e-9);
    s.ui.key(Key::end);
    EXPECT_EQ(s.levels.low, 203);
    s.ui.key(Key::home);
    EXPECT_EQ(s.levels.low, 0);
}

TEST(Histogram, TabGoesFromLowToHigh) {
    Shown s;
    EXPECT_EQ(s.ui.key(Key::tab).focused(), "Luma/Low");
    EXPECT_EQ(s.ui.key(Key::tab).focused(), "Luma/High");
    EXPECT_EQ(s.ui.key(Key::tab).focused(), "Luma/Log");
}

TEST(Histogram, DoubleClickAndBackspaceReset) {
    Shown s;
    s.ui.click("Luma/Low", {.clicks = 2});
    EXPECT_EQ(s.levels.low, 20);
    s.ui.focus("Luma/High").key(Key::backspace);
    EXPECT_EQ(s.levels.high, 230);
    EXPECT_EQ(s.committed, 2);
}

TEST(Histogram, EscapeRestores) {
    Shown s;
    s.ui.press("Luma/High").drag_by({-60, 0});
    EXPECT_NEAR(s.levels.high, 174, 1e-4);
    s.ui.key(Key::escape);
    EXPECT_EQ(s.levels.high, 204);
    EXPECT_EQ(s.cancelled, 1);
    EXPECT_EQ(s.committed, 0);
}

TEST(Histogram, EditsSayWhichValue) {
    Shown s;
    s.ui.press("Luma/High").drag_by({-60, 0});
    EXPECT_TRUE(s.high.changed);
    EXPECT_FALSE(s.low.changed);
}

TEST(Histogram, ReadsOutTheBinUnderThePointer) {
    Shown s;
    s.bins[128] = 2550;
    s.data.bins = s.bins;
    s.ui.frame();
    EXPECT_EQ(s.text_after_move({plot_left + 128.5F / 256 * plot_width, 60}), "128   2550   50.0 %");
    EXPECT_EQ(s.text_after_move({plot_left + 2, 60}), "1   10   0.2 %");
    EXPECT_EQ(s.text_after_move({10, 60}), "");
}

TEST(Histogram, OtherAxesReadTheMiddleOfABin) {
    Shown s;
    s.bins.assign(10, 1);
    s.data = {.bins = s.bins, .minimum = 0, .maximum = 1};
    s.options.unit = " s";
    s.levels = {.low = 0.2, .high = 0.8};
    s.options.step = 0.01;
    s.ui.frame();
    EXPECT_EQ(s.text_after_move({plot_left + 0.35F * plot_width, 60}), "0.35 s   1   10.0 %");
    s.ui.focus("Luma/Low").key(Key::right);
    EXPECT_NEAR(s.levels.low, 0.21, 1e-12);
    EXPECT_EQ(s.ui.text("Luma/Low"), "0.21 s");
}

TEST(Histogram, FullEndsAreMarkedAndTold) {
    Shown s;
    const auto warned = [&] {
        int count = 0;
        for (const Instance& each : s.ui.output().list->instances) count += each.color == s.ui.ui().theme().series[1];
        return count;
    };
    EXPECT_EQ(warned(), 0);
    s.bins[255] = 2550;
    s.data.bins = s.bins;
    s.ui.frame();
    EXPECT_EQ(warned(), 1);
    EXPECT_EQ(s.ui.text("Luma"), "clipped: 0.2 % at the low end, 50.0 % at the high end");
    s.options.clip_share = 0.6;
    s.ui.frame();
    EXPECT_EQ(warned(), 0);
}

TEST(Histogram, TheSwitchShowsRareValues) {
    Shown s;
    s.bins[100] = 10000;
    s.data.bins = s.bins;
    s.ui.frame();
    const auto tallest_but_one = [&] {
        std::vector<float> heights;
        for (const Instance& each : s.ui.output().list->instances) {
            if (each.kind == InstanceKind::fill && each.w <= 2 && each.h > 0) heights.push_back(each.h);
        }
        std::sort(heights.begin(), heights.end());
        return heights[heights.size() / 2];
    };
    const float before = tallest_but_one();
    EXPECT_LE(before, 1);
    s.ui.click("Luma/Log");
    EXPECT_TRUE(s.log);
    EXPECT_TRUE(s.ui.is("Luma/Log", Is::checked));
    EXPECT_GT(tallest_but_one(), 10);
}

TEST(Histogram, MoreBinsThanPixelsLoseNoPeak) {
    Shown s;
    s.bins.assign(100000, 0);
    s.bins[77777] = 5;
    s.data.bins = s.bins;
    s.ui.frame();
    const Color bar = canvas_ink(s.ui.ui().theme(), 0.5F);
    std::vector<Rect> bars;
    for (const Instance& each : s.ui.output().list->instances) {
        if (each.color == bar) bars.push_back({each.x, each.y, each.w, each.h});
    }
    ASSERT_EQ(bars.size(), 1U);
    EXPECT_NEAR(bars[0].x, plot_left + 0.77777 * plot_width, 1.01);
}

TEST(Histogram, EmptyAndDegenerateDataHold) {
    Shown s;
    s.data = {.bins = {}, .minimum = 0, .maximum = 0};
    s.levels = {.low = 5, .high = 5};
    EXPECT_NO_THROW(s.ui.frame().move({100, 60}).drag("Luma/Low", {30, 0}));
    EXPECT_TRUE(std::isfinite(s.levels.low));
}

TEST(Histogram, DisabledHandlesTakeNothing) {
    Shown s;
    s.disabled = true;
    s.ui.frame().drag("Luma/Low", {20, 0}).click("Luma/Log");
    EXPECT_EQ(s.levels.low, 51);
    EXPECT_FALSE(s.log);
}

TEST(Histogram, NothingIsUnnamedAndHandlesHaveTips) {
    Shown s;
    EXPECT_THAT(faults_of(s.ui.ui().tree()), testing::IsEmpty());
    EXPECT_NE(s.ui.tip("Luma/Low"), "");
    EXPECT_NE(s.ui.tip("Luma/High"), "");
}

TEST(Histogram, SteadyFramesAndDragsAllocateNothing) {
    Shown s;
    s.ui.press("Luma/Low").drag_by({20, 0});
    const auto steps = [&] {
        for (int i = 0; i < 50; ++i) {
            s.ui.ui().push({.kind = EventKind::pointer, .at = {150 + i % 7, 150}});
            s.ui.frame();
        }
    };
    steps();
    const std::size_t before = lapfx::test::allocations_so_far();
    steps();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
}

}  // namespace
}  // namespace lapfx::ui
