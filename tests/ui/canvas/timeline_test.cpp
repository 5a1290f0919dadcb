#include "ui/canvas/timeline.h"

#include <gmock/gmock.h>

#include <random>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/support/texts.h"

namespace lapfx::ui {
namespace {

TEST(Timeline, WritesPositionsInThreeUnits) {
    char buffer[32];
    EXPECT_EQ(format_position(buffer, 61.48, 25, TimeUnit::frames), "1537");
    EXPECT_EQ(format_position(buffer, 61.48, 25, TimeUnit::timecode), "00:01:01:12");
    EXPECT_EQ(format_position(buffer, 61.48, 25, TimeUnit::seconds), "1:01.480");
    EXPECT_EQ(format_position(buffer, 3 * 0.04, 25, TimeUnit::frames), "3") << "in spite of rounding";
    EXPECT_EQ(format_position(buffer, 36000.5, 30, TimeUnit::timecode), "10:00:00:15");
    EXPECT_EQ(format_position(buffer, 30 / 29.97, 29.97, TimeUnit::timecode), "00:00:01:00");
    EXPECT_EQ(format_position(buffer, -1, 25, TimeUnit::timecode), "-00:00:01:00");
}

class TimelineTest : public testing::Test {
  protected:
    TimelineState state;
    std::vector<TimelineTrack> tracks{{"Events", {{"Cut", 2, 4}, {"Bleed", 6, 7}}}, {"Marks", {{"Start", 5, 5}}}};
    TimelineOptions options{.length = 10, .rate = 25, .tip = "When what happens"};
    TimelineEdit last;
    std::optional<TimelineEdit::Taken> taken;  ///< in any frame
    int began = 0, committed = 0, cancelled = 0;
    bool open = false, mistaken = false;  ///< a gesture is open; one began within another or ended twice
    bool disabled = false;
    Harness ui{[this](Ui& u) {
                   u.push_disabled(disabled);
                   last = timeline(u, "Time", state, tracks, options);
                   if (last.taken) taken = last.taken;
                   u.pop_disabled();
                   for (const Edit& e : {last.time, last.range, last.items}) {
                       began += e.began, committed += e.committed, cancelled += e.cancelled;
                       mistaken |= (e.began && open) || (e.committed && e.cancelled);
                       open = (open || e.began) && !e.committed && !e.cancelled;
                   }
               },
               {643, 300}};
    // Names take 143 of the 643 px (10.2 em), so that a second is 50 px. The ruler is 25 px high, a lane 27 px.
    static constexpr float left = 143, second = 50;
    static glm::vec2 at(double t, float y = 10) { return {left + static_cast<float>(t) * second, y}; }
    Harness& press_at(glm::vec2 place, Mods mods = Mods::none, Button button = Button::left) {
        ui.frame(0.5);
        ui.move(place);
        return ui.send({.kind = EventKind::press, .button = button, .mods = mods, .at = place});
    }
    const TimelineItem& cut() const { return tracks[0].items[0]; }
    const TimelineItem& bleed() const { return tracks[0].items[1]; }
};

TEST_F(TimelineTest, AGhostIsTakenByAClickAndNothingElse) {
    tracks[1].items.push_back({.name = "Proposed", .start = 3, .end = 3, .ghost = true});
    ui.frame().frame();
    press_at(ui.rect("Time/Marks/Proposed").center());
    ui.release();
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->track, 1U);
    EXPECT_EQ(taken->item, 1U);
    ui.drag("Time/Marks/Proposed", {40, 0});
    EXPECT_EQ(tracks[1].items[1].start, 3);
    EXPECT_FALSE(tracks[1].items[1].selected);
    EXPECT_EQ(began, 0);
}

TEST_F(TimelineTest, ItemsThatOverlapShareTheLaneAndNoneIsHidden) {
    tracks[0].items = {{"Long", 1, 5}, {"Inside", 2, 3}, {"Over its end", 4.5, 6}, {"Alone", 6, 7}, {"Same", 6.5, 6.5}};
    ui.frame().frame();
    const float lane = ui.rect("Time/Events/Alone").h;
    EXPECT_EQ(lane, 26);
    const Rect all = ui.rect("Time/Events/Long"), inside = ui.rect("Time/Events/Inside"),
               over = ui.rect("Time/Events/Over its end");
    EXPECT_EQ(all.h, lane / 2);
    EXPECT_EQ(inside.y, all.bottom());
    EXPECT_EQ(over.y, inside.y) << "a row is used again";
    EXPECT_EQ(ui.rect("Time/Events/Same").h, lane) << "marks have all of it";
    ui.click("Time/Events/Inside");
    EXPECT_TRUE(tracks[0].items[1].selected);
    EXPECT_FALSE(tracks[0].items[0].selected);
    tracks[0].items = {{"a", 0, 9}, {"b", 0, 9}, {"c", 0, 9}, {"d", 1, 2}};
    ui.frame().frame();
    EXPECT_NEAR(ui.rect("Time/Events/d").h, lane / 3, 1) << "three rows at most";
}

TEST_F(TimelineTest, ItemsAreNodesWhereTheyLie) {
    const Rect rect = ui.rect("Time/Events/Cut");
    EXPECT_EQ(rect.x, at(2).x);
    EXPECT_EQ(rect.w, 100);
    EXPECT_NEAR(ui.rect("Time/Marks/Start").center().x, at(5).x, 0.5);
    EXPECT_EQ(ui.text("Time/Events/Cut"), "00:00:02:00 - 00:00:04:00");
    EXPECT_EQ(ui.tip("Time/Events/Cut"), "Cut\n00:00:02:00 - 00:00:04:00");
    EXPECT_EQ(ui.value("Time/Events/Cut"), 2);
    EXPECT_EQ(ui.tip("Time"), "When what happens");
    EXPECT_TRUE(faults_of(ui.ui().tree()).empty());
}

TEST_F(TimelineTest, TheRulerScrubsOnFrames) {
    press_at(at(3.01));
    EXPECT_DOUBLE_EQ(state.time, 3.0);
    EXPECT_EQ(ui.text("Time"), "00:00:03:00");
    ui.drag_by({62, 200});
    EXPECT_DOUBLE_EQ(state.time, 4.24);
    ui.drag_by({9000, 0}).release();
    EXPECT_EQ(state.time, 10);
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
}

TEST_F(TimelineTest, EscapeGivesBackTheTimeAndTheItems) {
    press_at(at(3)).drag_by({50, 0});
    ui.key(Key::escape).release();
    EXPECT_EQ(state.time, 0);
    EXPECT_EQ(cancelled, 1);
    ui.press("Time/Events/Cut").drag_by({50, 0});
    EXPECT_EQ(cut().start, 3);
    ui.send({.kind = EventKind::press, .button = Button::right, .at = at(1)});
    EXPECT_EQ(cut().start, 2);
    EXPECT_EQ(cut().end, 4);
    EXPECT_EQ(cancelled, 2);
    EXPECT_EQ(committed, 0);
}

TEST_F(TimelineTest, KeysStepAndJump) {
    ui.focus("Time").key(Key::right);
    EXPECT_DOUBLE_EQ(state.time, 0.04);
    ui.key(Key::right, Mods::shift);
    EXPECT_DOUBLE_EQ(state.time, 0.44);
    ui.key(Key::left);
    EXPECT_DOUBLE_EQ(state.time, 0.4);
    ui.key(Key::end);
    EXPECT_EQ(state.time, 10);
    ui.key(Key::right);
    EXPECT_EQ(state.time, 10);
    ui.key(Key::home);
    EXPECT_EQ(state.time, 0);
    EXPECT_EQ(began, 5) << "at the end there is no step";
}

TEST_F(TimelineTest, JKLAndSpacePlay) {
    ui.focus("Time").type("l");
    EXPECT_EQ(state.speed, 1);
    ui.type("lll");
    EXPECT_EQ(state.speed, 8);
    ui.type("l");
    EXPECT_EQ(state.speed, 8);
    ui.type("j");
    EXPECT_EQ(state.speed, -1);
    ui.type("j");
    EXPECT_EQ(state.speed, -2);
    ui.type("k");
    EXPECT_EQ(state.speed, 0);
    ui.type(" ");
    EXPECT_EQ(state.speed, 1);
    ui.type(" ");
    EXPECT_EQ(state.speed, 0);
    ui.click("Time/Play");
    EXPECT_EQ(state.speed, 1);
    EXPECT_TRUE(ui.is("Time/Play", Is::checked));
    ui.click("Time/Loop");
    EXPECT_TRUE(state.loop);
}

TEST_F(TimelineTest, InAndOutAreSetAtThePlayheadAndDragged) {
    state.time = 2;
    ui.focus("Time").type("i");
    EXPECT_TRUE(state.has_range);
    EXPECT_EQ(state.range, (Span{2, 10}));
    state.time = 8;
    ui.type("o");
    EXPECT_EQ(state.range, (Span{2, 8}));
    EXPECT_EQ(committed, 2);
    ui.drag("Time/Out", {-50, 0});
    EXPECT_EQ(state.range, (Span{2, 7}));
    ui.drag("Time/In", {900, 0});
    EXPECT_DOUBLE_EQ(state.range.low, 6.96) << "a frame is left";
    ui.focus("Time/Out").key(Key::right);
    EXPECT_DOUBLE_EQ(state.range.high, 7.04);
    EXPECT_EQ(committed, 5);
    ui.focus("Time").type("x");
    EXPECT_FALSE(state.has_range);
    EXPECT_FALSE(ui.exists("Time/In"));
}

TEST_F(TimelineTest, AnInPointBehindOutMovesOutToTheEnd) {
    state.has_range = true, state.range = {1, 3}, state.time = 5;
    ui.focus("Time").type("i");
    EXPECT_EQ(state.range, (Span{5, 10}));
}

TEST_F(TimelineTest, ADragMovesAClipOnFramesInOneGesture) {
    ui.press("Time/Events/Cut").drag_by({28, 60}).release();
    EXPECT_DOUBLE_EQ(cut().start, 2.56);
    EXPECT_DOUBLE_EQ(cut().end, 4.56);
    EXPECT_TRUE(cut().selected);
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
    ui.drag("Time/Events/Cut", {2, 0});
    EXPECT_EQ(began, 1) << "too little to be meant";
}

TEST_F(TimelineTest, EndsStretchAndKeepAFrame) {
    press_at(at(4, 40) - glm::vec2(2, 0)).drag_by({28, 0}).release();
    EXPECT_EQ(cut().start, 2);
    EXPECT_DOUBLE_EQ(cut().end, 4.56);
    press_at(at(2, 40) + glm::vec2(2, 0)).drag_by({500, 0}).release();
    EXPECT_DOUBLE_EQ(cut().start, 4.52);
    EXPECT_DOUBLE_EQ(cut().end, 4.56);
}

TEST_F(TimelineTest, AnEndCannotPassItsStart) {
    press_at(at(4, 40) - glm::vec2(2, 0)).drag_by({-500, 0}).release();
    EXPECT_EQ(cut().start, 2);
    EXPECT_DOUBLE_EQ(cut().end, 2.04);
}

TEST_F(TimelineTest, EndsCatchWhatIsNearUnlessCtrlIsHeld) {
    ui.press("Time/Events/Cut").drag_by({95, 0}).release();
    EXPECT_DOUBLE_EQ(cut().end, 6) << "the start of the next one, 5 px away";
    EXPECT_DOUBLE_EQ(cut().start, 4);
    ui.press("Time/Events/Cut").drag_by({-46, 0}, Mods::command).release(Mods::command);
    EXPECT_DOUBLE_EQ(cut().start, 3.08);
    state.time = 2.5;
    ui.press("Time/Events/Cut").drag_by({-26, 0}).release();
    EXPECT_DOUBLE_EQ(cut().start, 2.5) << "the playhead, which need not be on a frame of this rate";
}

TEST_F(TimelineTest, SelectedItemsMoveTogetherAndStayInTime) {
    ui.click("Time/Events/Bleed").click("Time/Marks/Start", {.mods = Mods::shift});
    EXPECT_TRUE(ui.is("Time/Events/Bleed", Is::selected));
    ui.press("Time/Marks/Start").drag_by({400, 0}, Mods::command).release();
    EXPECT_DOUBLE_EQ(bleed().end, 10);
    EXPECT_DOUBLE_EQ(bleed().start, 9);
    EXPECT_DOUBLE_EQ(tracks[1].items[0].start, 8);
    EXPECT_DOUBLE_EQ(tracks[1].items[0].end, 8) << "a mark stays one";
    press_at(at(1, 40)).release();
    EXPECT_FALSE(bleed().selected);
}

TEST_F(TimelineTest, DeleteErasesWhatIsSelectedOrFocused) {
    ui.click("Time/Events/Cut").click("Time/Marks/Start", {.mods = Mods::shift}).key(Key::del);
    ASSERT_EQ(tracks[0].items.size(), 1U);
    EXPECT_EQ(tracks[1].items.size(), 0U);
    EXPECT_EQ(ui.focused(), "Time");
    EXPECT_EQ(committed, 1);
    ui.focus("Time/Events/Bleed").key(Key::backspace);
    EXPECT_EQ(tracks[0].items.size(), 0U);
    ui.key(Key::del);
    EXPECT_EQ(committed, 2);
}

TEST_F(TimelineTest, ArrowsMoveAClipAndWithCtrlItsEnd) {
    ui.focus("Time/Events/Cut").key(Key::right);
    EXPECT_DOUBLE_EQ(cut().start, 2.04);
    EXPECT_DOUBLE_EQ(cut().end, 4.04);
    ui.key(Key::left, Mods::shift);
    EXPECT_DOUBLE_EQ(cut().start, 1.64);
    ui.key(Key::right, Mods::command);
    EXPECT_DOUBLE_EQ(cut().start, 1.64);
    EXPECT_DOUBLE_EQ(cut().end, 3.68);
    ui.focus("Time/Marks/Start").key(Key::right, Mods::command);
    EXPECT_EQ(tracks[1].items[0].end, 5);
    EXPECT_EQ(committed, 3);
    ui.type("l");
    EXPECT_EQ(state.speed, 1) << "the other keys are the timeline's";
}

TEST_F(TimelineTest, KeysWaitForTheEndOfADragThatChangedSomething) {
    ui.press("Time/Events/Cut").drag_by({50, 0});
    ui.key(Key::del);
    ASSERT_EQ(tracks[0].items.size(), 2U);
    EXPECT_EQ(committed, 0);
    ui.key(Key::escape).release();
    EXPECT_EQ(cancelled, 1);
    EXPECT_EQ(cut().start, 2);
    press_at(at(3)).key(Key::right).key('I');
    EXPECT_DOUBLE_EQ(state.time, 3);
    ui.release();
    EXPECT_EQ(began, 2);
    EXPECT_EQ(committed, 1);
}

TEST_F(TimelineTest, AKeyEndsADragThatChangedNothing) {
    ui.press("Time/Events/Cut").key(Key::del);
    EXPECT_EQ(tracks[0].items.size(), 1U);
    ui.drag_by({50, 0}).release();
    EXPECT_EQ(began, 1);
    EXPECT_EQ(committed, 1);
}

TEST_F(TimelineTest, KeysBringThePlayheadIntoSight) {
    state.view = {4, 8}, state.fitted = false, state.time = 5;
    ui.focus("Time").key(Key::home);
    EXPECT_EQ(state.time, 0);
    EXPECT_NEAR(state.view.low, -0.2, 1e-9);
    EXPECT_NEAR(state.view.length(), 4, 1e-9);
    ui.key(Key::end);
    EXPECT_NEAR(state.view.high, 10.2, 1e-9);
    ui.key(Key::left);
    EXPECT_NEAR(state.view.high, 10.2, 1e-9) << "what is in sight stays where it is";
    EXPECT_FALSE(state.fitted);
}

TEST_F(TimelineTest, LabelsGiveWayToTheBrackets) {
    const auto glyphs = [&] {
        std::size_t count = 0;
        for (const Instance& i : ui.output().list->instances)
            count += i.kind == InstanceKind::glyph && i.y < 25 && i.x > left ? 1 : 0;
        return count;
    };
    const std::size_t all = glyphs();
    state.has_range = true, state.range = {5.5, 9.9};
    ui.frame();
    EXPECT_LT(glyphs(), all);
    state.range = {3.96, 9.9};
    ui.frame();
    EXPECT_EQ(glyphs(), all) << "beside the labels";
}

TEST_F(TimelineTest, TheTooltipSaysWhatAClickDoes) {
    EXPECT_EQ(ui.tip("Time/Play"), "Play");
    ui.click("Time/Play");
    EXPECT_EQ(ui.tip("Time/Play"), "Stop");
}

TEST_F(TimelineTest, TheWheelZoomsAtThePointerAndFFits) {
    ui.move(at(4));
    ui.send({.kind = EventKind::wheel, .delta = {0, 2}});
    EXPECT_NEAR(state.view.length(), 10 * 0.85 * 0.85, 1e-9);
    EXPECT_NEAR(state.view.low + 0.4 * state.view.length(), 4, 1e-6);
    const double low = state.view.low;
    ui.send({.kind = EventKind::wheel, .mods = Mods::shift, .delta = {0, -1}});
    EXPECT_NEAR(state.view.low - low, 0.1 * state.view.length(), 1e-9);
    for (int i = 0; i < 200; ++i) ui.send({.kind = EventKind::wheel, .delta = {0, 1}});
    EXPECT_GE(state.view.length(), 4 * 0.04 - 1e-9);
    ui.focus("Time").type("f");
    EXPECT_EQ(state.view, (Span{0, 10}));
    for (int i = 0; i < 50; ++i) ui.send({.kind = EventKind::wheel, .delta = {0, -1}});
    EXPECT_LE(state.view.length(), 11);
}

TEST_F(TimelineTest, TheMiddleButtonPansWithinTime) {
    state.view = {2, 6}, state.fitted = false;
    ui.frame();
    press_at(at(1), Mods::none, Button::middle).drag_by({125, 0});
    EXPECT_NEAR(state.view.low, 1, 1e-6);
    ui.drag_by({9000, 0});
    EXPECT_NEAR(state.view.low, -0.5, 1e-6);
    EXPECT_NEAR(state.view.length(), 4, 1e-9);
}

TEST_F(TimelineTest, WhatIsOutOfSightIsNotBuiltUnlessItHasTheKeyboard) {
    ui.focus("Time/Events/Cut");
    state.view = {5.5, 7.5}, state.fitted = false;
    ui.frame();
    EXPECT_TRUE(ui.exists("Time/Events/Cut"));
    EXPECT_TRUE(ui.exists("Time/Events/Bleed"));
    EXPECT_FALSE(ui.exists("Time/Marks/Start"));
    EXPECT_EQ(ui.focused(), "Time/Events/Cut");
}

TEST_F(TimelineTest, PlayingTurnsThePage) {
    state.view = {0, 4}, state.fitted = false, state.speed = 1, state.time = 4.1;
    ui.frame();
    EXPECT_NEAR(state.view.low, 4.1, 1e-12);
    state.speed = -1, state.time = 4;
    ui.frame();
    EXPECT_NEAR(state.view.high, 4, 1e-12);
}

TEST_F(TimelineTest, DisabledItTakesNothing) {
    disabled = true;
    ui.frame();
    press_at(at(3)).release();
    ui.drag("Time/Events/Cut", {60, 0});
    ui.wheel("Time", {0, 2});
    EXPECT_EQ(state.time, 0);
    EXPECT_EQ(cut().start, 2);
    EXPECT_TRUE(state.fitted);
    EXPECT_TRUE(ui.is("Time/Events/Cut", Is::disabled));
}

TEST_F(TimelineTest, TheProgramMayTakeAwayWhatIsDragged) {
    ui.press("Time/Events/Bleed").drag_by({20, 0});
    tracks[0].items.clear();
    ui.drag_by({20, 0}).release();
    EXPECT_EQ(committed, 0);
}

TEST_F(TimelineTest, SteadyFramesAllocateNothing) {
    state.has_range = true, state.range = {1, 9};
    ui.move(at(3, 40)).settle();
    ui.frame(2);
    const std::size_t before = test::allocations_so_far();
    for (int i = 0; i < 300; ++i) ui.frame();
    EXPECT_EQ(test::allocations_so_far(), before);
}

TEST_F(TimelineTest, AnyInputLeavesItemsInTime) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> x(0, 643), y(0, 90);
    const char letters[] = "jkliofx ";
    const Key keys[] = {Key::left, Key::right, Key::home, Key::end, Key::tab, Key::enter, Key::escape};
    const Mods mods[] = {Mods::none, Mods::shift, Mods::command, Mods::alt};
    for (int i = 0; i < 4000; ++i) {
        const glm::vec2 place{x(random), y(random)};
        const Mods with = mods[random() % 4];
        const auto button = static_cast<Button>(random() % 3);
        switch (random() % 7) {
            case 0:
                ui.send({.kind = EventKind::press, .button = button, .mods = with, .at = place});
                break;
            case 1:
                ui.send({.kind = EventKind::release, .button = button, .mods = with, .at = place});
                break;
            case 2:
                ui.key(keys[random() % 7], with);
                break;
            case 3:
                ui.key(key_of(letters[random() % 8]));
                break;
            case 4:
                ui.send({.kind = EventKind::wheel, .mods = with, .delta = {0, (random() % 2 == 0) ? 1.0F : -1.0F}});
                break;
            default:
                ui.send({.kind = EventKind::pointer, .mods = with, .at = place});
        }
        ASSERT_FALSE(mistaken) << i;
        ASSERT_TRUE(state.time >= 0 && state.time <= 10);
        ASSERT_TRUE(state.view.length() > 0.1 && state.view.length() < 11.001 && state.view.low > -2);
        ASSERT_TRUE(!state.has_range ||
                    (state.range.low >= 0 && state.range.length() > 0.03 && state.range.high <= 10));
        for (const TimelineTrack& track : tracks) {
            for (const TimelineItem& item : track.items)
                ASSERT_TRUE(item.start >= -1e-9 && item.start <= item.end && item.end <= 10 + 1e-9) << item.name;
        }
    }
}

TEST(Timeline, TheRulerCutsNoTime) {
    TimelineState state;
    state.view = {0, 12};
    for (int width = 420; width < 480; width += 7) {
        Harness ui(
            [&](Ui& u) { timeline(u, "Time", state, {}, {.length = 12, .rate = 25, .unit = TimeUnit::timecode}); },
            {width, 200});
        ui.frame();
        const std::vector<TextSeen> texts = texts_seen(*ui.output().list, Harness::fonts(), ui.ui().em(1));
        EXPECT_GE(texts.size(), 2U);
        for (const TextSeen& text : texts) EXPECT_LE(text.glyphs.back().right(), text.clip.right() + 0.5F) << width;
    }
}

}  // namespace
}  // namespace lapfx::ui
