#include "ui/canvas/plot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

using testing::HasSubstr;

/// y = x over 0..10 in steps of 1, and its negative.
struct Scene {
    std::vector<double> up, down;
    PlotData up_data, down_data;
    PlotState state;
    PlotOptions options{
        .x_name = "Time", .x_unit = "s", .y_unit = "mm", .height = {SizeKind::px, 300}, .tip = "What was measured"};
    PlotResult result;
    PlotResult all;  // results of all builds together
    bool disabled = false;

    Scene() {
        for (int i = 0; i <= 10; ++i) up.push_back(i), down.push_back(-i);
        up_data.set(up);
        down_data.set(down);
        options.state = &state;
    }
    void operator()(Ui& u) {
        const PlotSeries series[] = {{"Up", &up_data}, {"Down", &down_data}};
        u.push_disabled(disabled);
        result = plot(u, "Plot", series, options);
        u.pop_disabled();
        all.moved |= result.moved;
    }
};

class PlotTest : public testing::Test {
  protected:
    Scene scene;
    Harness ui{[this](Ui& u) { scene(u); }, {640, 400}};
    // The 640 px have a margin of 4 px and 50 px for labels (3.6 em) on the left, 8 and 4 px on the right (frame_of()).
    static constexpr float left = 54, right = 628, top = 25, bottom = 278;
    static float x_px(double x, double low, double high) {
        return left + static_cast<float>((x - low) / (high - low)) * (right - left);
    }
    glm::vec2 middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
    Harness& drag_from(glm::vec2 from, glm::vec2 by, Mods mods = Mods::none, Button button = Button::left) {
        ui.send({.kind = EventKind::press, .button = button, .mods = mods, .at = from});
        ui.drag_by(by, mods);
        return ui.send({.kind = EventKind::release, .button = button, .mods = mods, .at = from + by});
    }
};

TEST_F(PlotTest, BeginsFittedToItsData) {
    EXPECT_EQ(scene.state.x, (Span{0, 10}));
    EXPECT_NEAR(scene.state.y.low, -11.2, 1e-12) << "6 parts of 100 more on both sides";
    EXPECT_NEAR(scene.state.y.high, 11.2, 1e-12);
    EXPECT_TRUE(scene.state.fitted);
}

TEST_F(PlotTest, FollowsItsDataWhileFitted) {
    scene.up[10] = 100;
    scene.up_data.set(scene.up, 0, 2);
    ui.frame();
    EXPECT_EQ(scene.state.x.high, 20);
    EXPECT_GT(scene.state.y.high, 100);
}

TEST_F(PlotTest, DragPansAndEscapeGivesBack) {
    drag_from(middle(), {57.4F, 0});
    EXPECT_NEAR(scene.state.x.low, -1, 1e-6);
    EXPECT_NEAR(scene.state.x.high, 9, 1e-6);
    EXPECT_FALSE(scene.state.fitted);
    EXPECT_TRUE(scene.all.moved);
    const Span before = scene.state.x;
    ui.frame(0.5);  // otherwise it would be a double click
    ui.send({.kind = EventKind::press, .at = middle()});
    ui.drag_by({80, 30});
    EXPECT_NE(scene.state.x, before);
    ui.key(Key::escape);
    EXPECT_EQ(scene.state.x, before);
}

TEST_F(PlotTest, TheOtherButtonGivesBackWhatADragMoved) {
    ui.send({.kind = EventKind::press, .at = middle()});
    ui.drag_by({80, 30});
    ui.send({.kind = EventKind::press, .button = Button::right, .at = middle()});
    EXPECT_EQ(scene.state.x, (Span{0, 10}));
    EXPECT_TRUE(scene.state.fitted);
}

TEST_F(PlotTest, TheMiddleButtonPans) {
    drag_from(middle(), {-57.4F, 0}, Mods::none, Button::middle);
    EXPECT_NEAR(scene.state.x.low, 1, 1e-6);
}

TEST_F(PlotTest, APressAloneMovesNothing) {
    ui.click("Plot");
    EXPECT_TRUE(scene.state.fitted);
    EXPECT_FALSE(scene.all.moved);
}

TEST_F(PlotTest, TheWheelZoomsAtThePointer) {
    ui.move({left + (right - left) / 4, middle().y});
    ui.send({.kind = EventKind::wheel, .delta = {0, 2}});
    EXPECT_NEAR(scene.state.x.length(), 10 * 0.85 * 0.85, 1e-9);
    EXPECT_NEAR(scene.state.x.low + scene.state.x.length() / 4, 2.5, 1e-6) << "what is under it stays";
    EXPECT_NEAR(scene.state.y.length(), 22.4 * 0.85 * 0.85, 1e-9);
    EXPECT_NEAR((scene.state.y.low + scene.state.y.high) / 2, 0, 1e-6);
}

TEST_F(PlotTest, TheWheelOnAnAxisZoomsItAlone) {
    const Span x = scene.state.x, y = scene.state.y;
    ui.move({middle().x, bottom + 8});
    ui.send({.kind = EventKind::wheel, .delta = {0, 1}});
    EXPECT_LT(scene.state.x.length(), x.length());
    EXPECT_EQ(scene.state.y, y);
    const Span x_now = scene.state.x;
    ui.move({left - 10, middle().y});
    ui.send({.kind = EventKind::wheel, .delta = {0, 1}});
    EXPECT_EQ(scene.state.x, x_now);
    EXPECT_LT(scene.state.y.length(), y.length());
}

TEST_F(PlotTest, ShiftDragZoomsToABox) {
    const glm::vec2 from{x_px(2, 0, 10), middle().y};
    drag_from(from, {x_px(7, 0, 10) - from.x, -(bottom - top) / 4}, Mods::shift);
    EXPECT_NEAR(scene.state.x.low, 2, 1e-4);
    EXPECT_NEAR(scene.state.x.high, 7, 1e-4);
    EXPECT_NEAR(scene.state.y.low, 0, 1e-4);
    EXPECT_NEAR(scene.state.y.high, 5.6, 1e-4);
    const Span x = scene.state.x;
    drag_from(middle(), {2, 50}, Mods::shift);
    EXPECT_EQ(scene.state.x, x) << "too narrow to be meant";
}

TEST_F(PlotTest, CtrlDragAsksForARange) {
    drag_from({x_px(2, 0, 10), middle().y}, {x_px(6, 0, 10) - x_px(2, 0, 10), 10}, Mods::command);
    EXPECT_TRUE(scene.state.has_range);
    EXPECT_NEAR(scene.state.range.low, 2, 1e-4);
    EXPECT_NEAR(scene.state.range.high, 6, 1e-4);
    EXPECT_EQ(scene.state.x, (Span{0, 10}));
    EXPECT_EQ(ui.text("Plot"), "mean 4.000  area 16.000  min 2.00  max 6.00");
    ui.key(Key::escape);
    EXPECT_FALSE(scene.state.has_range);
}

TEST_F(PlotTest, DoubleClickFAndHomeFit) {
    for (int way = 0; way < 3; ++way) {
        ui.wheel("Plot", {0, 3});
        EXPECT_FALSE(scene.state.fitted);
        if (way == 0) ui.click("Plot", {.clicks = 2});
        if (way == 1) ui.type("f");
        if (way == 2) ui.key(Key::home);
        EXPECT_TRUE(scene.state.fitted);
        EXPECT_EQ(scene.state.x, (Span{0, 10}));
    }
}

TEST_F(PlotTest, ArrowsPanAndSignsZoom) {
    ui.focus("Plot").key(Key::right);
    EXPECT_NEAR(scene.state.x.low, 1, 1e-12);
    ui.key(Key::up);
    EXPECT_NEAR(scene.state.y.low, -11.2 + 2.24, 1e-12);
    ui.type("+");
    EXPECT_NEAR(scene.state.x.length(), 8, 1e-12);
    ui.type("-");
    EXPECT_NEAR(scene.state.x.length(), 10, 1e-12);
}

TEST_F(PlotTest, CannotBeZoomedOutOfReach) {
    ui.move(middle());
    for (const float way : {1.0F, -1.0F}) {
        for (int i = 0; i < 400; ++i) ui.send({.kind = EventKind::wheel, .delta = {0, way}});
        EXPECT_GT(scene.state.x.length(), 1e-9);
        EXPECT_LT(scene.state.x.length(), 1e6);
        EXPECT_TRUE(std::isfinite(scene.state.y.low));
        ui.key(key_of('F'));
    }
}

TEST_F(PlotTest, LogarithmicAxisOfWhatIsPositive) {
    for (std::size_t i = 0; i < scene.up.size(); ++i) scene.up[i] = std::pow(10, static_cast<double>(i) - 5);
    scene.up_data.set(scene.up);
    ui.click("Plot/Down");
    ui.focus("Plot").type("l");
    ui.frame();
    EXPECT_TRUE(scene.state.log_y);
    EXPECT_NEAR(scene.state.y.low, -5.6, 1e-9);
    EXPECT_NEAR(scene.state.y.high, 5.6, 1e-9);
    ui.type("l");
    EXPECT_FALSE(scene.state.log_y);
}

TEST_F(PlotTest, NamesInTheLegendShowAndHide) {
    EXPECT_TRUE(ui.is("Plot/Down", Is::checked));
    ui.click("Plot/Down");
    EXPECT_EQ(scene.state.hidden, 2U);
    EXPECT_FALSE(ui.is("Plot/Down", Is::checked));
    EXPECT_NEAR(scene.state.y.low, -0.6, 1e-9) << "fits what is left";
    EXPECT_EQ(ui.tip("Plot/Down"), "Show");
    ui.focus("Plot/Down").key(Key::space);
    EXPECT_EQ(scene.state.hidden, 0U);
}

TEST_F(PlotTest, TheReadoutSnapsToTheNearestSample) {
    ui.move({x_px(3.3, 0, 10), top + 20});  // above: nearer to the rising series
    EXPECT_EQ(scene.result.series, 0);
    EXPECT_EQ(scene.result.index, 3U);
    EXPECT_EQ(ui.text("Plot"), "Up: 3.00 s, 3.00 mm");
    ui.move({x_px(6.8, 0, 10), bottom - 20});
    EXPECT_EQ(scene.result.series, 1);
    EXPECT_EQ(ui.text("Plot"), "Down: 7.00 s, -7.00 mm");
    ui.move({2, 390});
    EXPECT_EQ(scene.result.series, -1);
    EXPECT_EQ(ui.text("Plot"), "");
}

TEST_F(PlotTest, CopiesWhatIsInSightAsCsv) {
    drag_from({x_px(8, 0, 10) - 20, middle().y}, {400, 40}, Mods::shift);
    ui.key('C', Mods::command);
    EXPECT_THAT(ui.clipboard().text, testing::StartsWith("x,Up,Down\n8,8,-8\n9,9,-9\n10,"));
}

TEST_F(PlotTest, TellsWhatItIsFor) {
    EXPECT_EQ(ui.tip("Plot"), "What was measured");
    EXPECT_EQ(ui.node("Plot").role, Role::plot);
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
}

TEST_F(PlotTest, DisabledItTakesNothing) {
    scene.disabled = true;
    ui.frame();
    ui.wheel("Plot", {0, 3});
    ui.click("Plot/Down");
    drag_from(middle(), {50, 0});
    EXPECT_TRUE(scene.state.fitted);
    EXPECT_EQ(scene.state.hidden, 0U);
    EXPECT_TRUE(ui.is("Plot", Is::disabled));
}

TEST_F(PlotTest, SteadyFramesAndDragsAllocateNothing) {
    ui.move(middle()).settle();
    ui.send({.kind = EventKind::press, .mods = Mods::command, .at = middle()});
    ui.drag_by({40, 10}, Mods::command).drag_by({-40, 10}, Mods::command);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far(), before);
}

std::size_t lines_of(const DrawList& list) {
    return static_cast<std::size_t>(std::count_if(list.instances.begin(), list.instances.end(),
                                                  [](const Instance& i) { return i.kind == InstanceKind::line; }));
}

TEST(Plot, GapsInterruptTheLine) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> whole = {1, 2, 3, 4, 5, 6}, gaps = {1, 2, gap, 4, gap, 6};
    PlotData data;
    Harness ui([&](Ui& u) {
        const PlotSeries series[] = {{"", &data}};
        plot(u, "Plot", series);
    });
    data.set(whole);
    ui.frame();
    EXPECT_EQ(lines_of(*ui.output().list), 5U);
    data.set(gaps);
    ui.frame();
    EXPECT_EQ(lines_of(*ui.output().list), 3U) << "one piece, and a dot for each lonely sample";
}

TEST(Plot, AnIntervalIsABandAroundItsLine) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> y = {1, 2, 3, gap, 3}, low = {0, 1, 2, gap, 2}, high = {9, 9, 9, gap, 4};
    PlotData data, low_data, high_data;
    data.set(y), low_data.set(low), high_data.set(high);
    PlotState state;
    bool band = true;
    Harness ui([&](Ui& u) {
        const PlotSeries series[] = {
            {.name = "", .data = &data, .low = band ? &low_data : nullptr, .high = band ? &high_data : nullptr}};
        plot(u, "Plot", series, {.state = &state});
    });
    const auto bars = [&] {
        std::vector<Instance> found;
        const Color color = with_alpha(ui.ui().theme().series[0], 0.25F);
        for (const Instance& i : ui.output().list->instances)
            if (i.kind == InstanceKind::fill && i.color == color) found.push_back(i);
        return found;
    };
    EXPECT_GE(state.y.high, 9.0) << "it is in sight";
    EXPECT_LE(state.y.low, 0.0);
    const std::vector<Instance> shown = bars();
    ASSERT_GT(shown.size(), 50U);
    EXPECT_GT(shown.front().h, 3 * shown.back().h) << "from 0 to 9, but from 2 to 4 at the end";
    float widest = 0;
    for (std::size_t i = 1; i < shown.size(); ++i) widest = std::max(widest, shown[i].x - shown[i - 1].x);
    EXPECT_GT(widest, 100) << "nothing in the gap";
    band = false;
    ui.frame();
    EXPECT_TRUE(bars().empty());
}

TEST(Plot, AMillionSamplesAreALineForEachPixel) {
    std::vector<float> y(1000000);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = static_cast<float>(i % 1000) / 1000;
    y[654321] = 50;  // one sample that must not be lost
    PlotData data;
    data.set(y);
    Harness ui([&](Ui& u) {
        const PlotSeries series[] = {{"", &data}};
        plot(u, "Plot", series);
    });
    const DrawList& list = *ui.output().list;
    EXPECT_GT(lines_of(list), 500U);
    EXPECT_LT(lines_of(list), 640U);
    int tall = 0;
    for (const Instance& i : list.instances) tall += i.kind == InstanceKind::line && std::abs(i.h - i.y) > 100 ? 1 : 0;
    EXPECT_GE(tall, 1);
    EXPECT_LE(tall, 3) << "itself, and what touches it";
}

TEST(Plot, HoldsWithNoSeriesNoSamplesAndNoRoom) {
    PlotData empty, one, gap;
    const std::vector<double> single = {5}, nothing = {std::numeric_limits<double>::quiet_NaN()};
    one.set(single);
    gap.set(nothing);
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(30, 200), glm::ivec2(800, 600)}) {
        for (int count = 0; count < 4; ++count) {
            PlotState state;
            Harness ui(
                [&](Ui& u) {
                    const PlotSeries series[] = {{"A", &empty}, {"B", &one}, {"C", &gap}};
                    plot(u, "Plot", std::span(series).first(static_cast<std::size_t>(count)), {.state = &state});
                },
                size);
            ui.move({size.x / 2, size.y / 4}).send({.kind = EventKind::wheel, .delta = {0, 1}});
            EXPECT_TRUE(state.x.length() > 0 && state.y.length() > 0);
        }
    }
}

TEST_F(PlotTest, AClickOnTheGroundTellsItsPlaceAndADragDoesNot) {
    std::vector<double> clicks;
    Harness other{[&](Ui& u) {
                      const PlotSeries series[] = {{"Up", &scene.up_data}};
                      const PlotResult r = plot(u, "Plot", series, scene.options);
                      if (r.clicked) clicks.push_back(r.x);
                  },
                  {640, 400}};
    const auto press_and_release = [&](glm::vec2 from, glm::vec2 by, Button button = Button::left) {
        other.send({.kind = EventKind::press, .button = button, .at = from});
        if (by != glm::vec2(0)) other.drag_by(by);
        other.send({.kind = EventKind::release, .button = button, .at = from + by});
    };
    press_and_release({x_px(7, 0, 10), 100}, {0, 0});
    ASSERT_EQ(clicks.size(), 1U);
    EXPECT_NEAR(clicks[0], 7, 0.01);
    press_and_release({x_px(2, 0, 10), 100}, {60, 0});
    press_and_release({left - 20, 100}, {0, 0});
    press_and_release({x_px(2, 0, 10), 100}, {0, 0}, Button::right);
    EXPECT_EQ(clicks.size(), 1U) << "panned, on an axis, the other button";
}

}  // namespace
}  // namespace lapfx::ui
