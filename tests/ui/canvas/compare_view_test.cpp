#include "ui/canvas/compare_view.h"

#include <gmock/gmock.h>

#include <glm/gtc/constants.hpp>

#include "ui/canvas/timeline.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

struct Flat : PickSource {
    explicit Flat(float v) : value(v) {}
    glm::vec4 pixel(glm::ivec2 at) const override { return {value, at.x, at.y, 255}; }
    float value;
};
const Flat one(10), two(30);

/// Pictures of 200 x 100 pixels in 400 x 300 px: when fitted, their scale is 2 and their upper left corner is at 0, 50.
struct Compared {
    CompareState state;
    CompareOptions options{.width = px(400), .height = px(300)};
    CompareResult last;
    int began = 0, changed = 0, committed = 0, cancelled = 0;
    int picks = 0, under = -1;  // by the eyedropper, and the picture it was in
    bool disabled = false;
    Harness ui{[this](Ui& u) {
        u.push_disabled(disabled);
        last = compare_view(u, "Takes", {.image = 7, .size = {200, 100}, .pixels = &one},
                            {.image = 8, .size = {200, 100}, .pixels = &two}, state, options);
        u.pop_disabled();
        if (last.picked) ++picks, under = last.under;
        began += last.edit.began, changed += last.edit.changed;
        committed += last.edit.committed, cancelled += last.edit.cancelled;
    }};
    const Batch* batch_of(InstanceKind kind, Instance* instance = nullptr) const {
        const DrawList& list = *ui.output().list;
        for (const Batch& batch : list.batches) {
            for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i) {
                if (list.instances[i].kind != kind) continue;
                if (instance != nullptr) *instance = list.instances[i];
                return &batch;
            }
        }
        return nullptr;
    }
};

TEST(CompareView, DrawsBothWithTheLineWhereItIsSet) {
    Compared c;
    c.state.position = 0.25;
    c.ui.frame();
    Instance drawn;
    const Batch* batch = c.batch_of(InstanceKind::compare, &drawn);
    ASSERT_NE(batch, nullptr);
    EXPECT_EQ(batch->images[0], 7U);
    EXPECT_EQ(batch->images[1], 8U);
    EXPECT_EQ((Rect{drawn.x, drawn.y, drawn.w, drawn.h}), (Rect{0, 50, 400, 200}));
    EXPECT_NEAR(drawn.uv[0], 0.25 * 65535, 1);
    EXPECT_EQ(drawn.radius, static_cast<int>(CompareMode::wipe));
}

TEST(CompareView, EachKindHasItsMode) {
    Compared c;
    for (const auto& [kind, mode] : {std::pair(CompareKind::onion, CompareMode::onion),
                                     std::pair(CompareKind::difference, CompareMode::difference)}) {
        c.state.kind = kind;
        c.ui.frame();
        Instance drawn;
        ASSERT_NE(c.batch_of(InstanceKind::compare, &drawn), nullptr);
        EXPECT_EQ(drawn.radius, static_cast<int>(mode));
        EXPECT_FALSE(c.ui.exists("Takes/Wipe"));
    }
}

TEST(CompareView, BesideEachOtherBothShowTheSamePart) {
    Compared c;
    c.state.kind = CompareKind::side_by_side;
    c.options.height = px(900);  // pictures of a tall view are larger one above the other
    c.ui.size = {640, 960};
    c.ui.frame();
    std::vector<Rect> images;
    for (const Instance& each : c.ui.output().list->instances) {
        if (each.kind == InstanceKind::image) images.push_back({each.x, each.y, each.w, each.h});
    }
    ASSERT_EQ(images.size(), 2U);
    EXPECT_EQ(images[0].size(), glm::vec2(400, 200));
    EXPECT_EQ(images[1].size(), glm::vec2(400, 200));
    EXPECT_EQ(images[0].x, images[1].x);
    EXPECT_EQ(images[1].y - images[0].y, 451);
    c.options.height = px(100);
    c.ui.frame();
    images.clear();
    for (const Instance& each : c.ui.output().list->instances) {
        if (each.kind == InstanceKind::image) images.push_back({each.x, each.y, each.w, each.h});
    }
    EXPECT_EQ(images[0].y, images[1].y) << "flat: side by side";
}

TEST(CompareView, ThePointerPicksInEitherHalf) {
    Compared c;
    c.state.kind = CompareKind::side_by_side;
    c.options.height = px(100);
    c.ui.frame().move({199 / 2.0F, 50});
    EXPECT_TRUE(c.last.has_pick);
    const glm::ivec2 left = c.last.pick;
    c.ui.move({201 + 199 / 2.0F, 50});
    EXPECT_EQ(c.last.pick, left);
    EXPECT_EQ(c.last.first.x, 10);
    EXPECT_EQ(c.last.second.x, 30);
    EXPECT_EQ(c.ui.text("Takes"), "100, 50   A   R 10  G 100  B 50  A 255   B   R 30  G 100  B 50  A 255");
}

TEST(CompareView, TheLineIsDraggedByItsHandle) {
    Compared c;
    EXPECT_EQ(c.ui.value("Takes/Wipe"), 0.5);
    EXPECT_EQ(c.ui.rect("Takes/Wipe").center(), glm::vec2(200, 150));
    c.ui.drag("Takes/Wipe", {-100, 30});
    EXPECT_NEAR(c.state.position, 0.25, 1e-6);
    EXPECT_EQ(c.ui.rect("Takes/Wipe").center(), glm::vec2(100, 150));
    EXPECT_EQ(c.began, 1);
    EXPECT_EQ(c.committed, 1);
    c.ui.click("Takes/Wipe", {.clicks = 2});
    EXPECT_EQ(c.state.position, 0.5);
    EXPECT_EQ(c.state.view, ViewState{}) << "the pictures stay";
}

TEST(CompareView, TheLineIsDraggedWhereverItIsGrabbed) {
    Compared c;
    c.ui.move({202, 80});
    EXPECT_EQ(c.ui.output().cursor, Cursor::resize_x);
    c.ui.send({.kind = EventKind::press, .at = {202, 80}}).drag_by({-100, 30}).key('X');
    EXPECT_NEAR(c.state.position, 0.25, 1e-6);
    EXPECT_FALSE(c.state.swapped) << "one edit at a time";
    EXPECT_EQ(c.ui.output().cursor, Cursor::resize_x);
    c.ui.release();
    EXPECT_EQ(c.began, 1);
    EXPECT_EQ(c.committed, 1);
    EXPECT_EQ(c.state.view, ViewState{}) << "the pictures stay";
    c.ui.frame(1).send({.kind = EventKind::press, .at = {102, 80}}).drag_by({200, 0});
    c.ui.key(Key::escape).release();
    EXPECT_NEAR(c.state.position, 0.25, 1e-6);
    EXPECT_EQ(c.cancelled, 1);
    EXPECT_EQ(c.committed, 1);
}

TEST(CompareView, BesideTheLineThePicturesArePanned) {
    Compared c;
    c.state.view = {.fitted = false, .zoom = 4};
    c.ui.frame().move({208, 80});
    EXPECT_EQ(c.ui.output().cursor, Cursor::arrow);
    c.ui.send({.kind = EventKind::press, .at = {208, 80}}).drag_by({-40, 0}).release();
    EXPECT_EQ(c.state.position, 0.5);
    EXPECT_NE(c.state.view.center.x, 0.5);
}

TEST(CompareView, TheMagnifierShowsWhatIsSeenThere) {
    Compared c;
    c.options.magnifier = true;
    const auto magnified = [&] {
        ImageHandle last = 0;
        for (const Batch& batch : c.ui.output().list->batches) last = batch.images[0] != 0 ? batch.images[0] : last;
        return last;
    };
    c.ui.move({100, 80});
    EXPECT_EQ(magnified(), 7U);
    c.ui.move({300, 80});
    EXPECT_EQ(magnified(), 8U);
    EXPECT_EQ(c.last.pick, glm::ivec2(150, 15));
}

TEST(CompareView, TheEyedropperTakesWhatIsSeenThereAndMovesNothing) {
    Compared c;
    c.options.eyedropper = true;
    const auto click = [&](glm::vec2 at) {
        c.ui.move(at);
        c.ui.send({.kind = EventKind::press, .at = at});
        c.ui.send({.kind = EventKind::release, .at = at});
    };
    c.ui.frame();
    EXPECT_EQ(c.last.zoom, 2.0);
    click({100, 150});
    EXPECT_EQ(c.picks, 1);
    EXPECT_EQ(c.under, 0);
    EXPECT_EQ(c.last.pick, glm::ivec2(50, 50));
    click({300, 150});
    EXPECT_EQ(c.picks, 2);
    EXPECT_EQ(c.under, 1);
    c.state.swapped = true;
    click({300, 150});
    EXPECT_EQ(c.under, 0) << "of the arguments, however they are shown";
    c.ui.press("Takes", {0.5F, 0.4F}).drag_by({40, 0}).release();
    EXPECT_EQ(c.state.position, 0.5);
    EXPECT_TRUE(c.state.view.fitted);
    EXPECT_EQ(c.changed, 0);
    EXPECT_EQ(c.picks, 4);
    click(c.ui.rect("Takes").center());
    EXPECT_EQ(c.picks, 5) << "on the line's handle, which rests meanwhile";
    EXPECT_FALSE(c.ui.exists("Takes/Wipe"));
    c.options.eyedropper = false;
    click({100, 150});
    EXPECT_EQ(c.picks, 5);
}

TEST(CompareView, TheEyedropperByKeysTakesTheFirstWhereverThePointerRests) {
    Compared c;
    c.state.kind = CompareKind::side_by_side;
    c.options.eyedropper = true;
    c.ui.focus("Takes").move({200, 225});  // one above the other
    EXPECT_EQ(c.last.under, 1);
    c.ui.key(Key::right).key(Key::enter);
    EXPECT_EQ(c.picks, 1);
    EXPECT_EQ(c.under, 0);
}

TEST(CompareView, TheLineMovesByKeysTheWayTheArrowsPoint) {
    Compared c;
    c.ui.focus("Takes/Wipe").key(Key::right);
    EXPECT_NEAR(c.state.position, 0.51, 1e-9);
    c.ui.key(Key::left, Mods::shift);
    EXPECT_NEAR(c.state.position, 0.509, 1e-9);
    c.state.angle = glm::half_pi<double>();  // the line is horizontal, the first picture above it
    c.state.position = 0.5;
    c.ui.frame().key(Key::down);
    EXPECT_NEAR(c.state.position, 0.51, 1e-9);
    c.ui.key(Key::home);
    EXPECT_EQ(c.state.position, 0);
}

TEST(CompareView, TheLineIsTurnedAboutItsHandle) {
    Compared c;
    c.state.position = 0.4;
    c.ui.frame();
    const glm::vec2 pivot = c.ui.rect("Takes/Wipe").center(), grip = c.ui.rect("Takes/Wipe angle").center();
    EXPECT_EQ(grip - pivot, glm::vec2(0, 75)) << "a quarter of the shorter side down the line";
    c.ui.drag("Takes/Wipe angle", {-75, -75});
    EXPECT_NEAR(c.state.angle, glm::half_pi<double>(), 1e-3);
    EXPECT_NEAR(c.ui.value("Takes/Wipe angle"), 90, 0.1);
    // The line is horizontal now. It goes through the pivot, which is in the middle of the height.
    EXPECT_NEAR(c.state.position, 0.5, 0.01);
    EXPECT_EQ(c.committed, 1);
}

TEST(CompareView, TurningGivenUpPutsLineAndAngleBack) {
    Compared c;
    c.state.position = 0.4;
    c.ui.frame().press("Takes/Wipe angle").drag_by({-75, -75});
    EXPECT_NE(c.state.position, 0.4);
    c.ui.key(Key::escape);
    EXPECT_EQ(c.state.position, 0.4);
    EXPECT_EQ(c.state.angle, 0);
    EXPECT_EQ(c.cancelled, 1);
    EXPECT_EQ(c.committed, 0);
}

TEST(CompareView, TurningALineFromOutOfSightBringsItToTheHandleUnlessGivenUp) {
    Compared c;
    c.state.position = 0.1;
    c.state.view = {.fitted = false, .zoom = 16};
    c.ui.frame().press("Takes/Wipe angle").drag_by({30, 0});
    EXPECT_GT(c.state.position, 0.4);
    c.ui.key(Key::escape);
    EXPECT_EQ(c.state.position, 0.1);
    EXPECT_EQ(c.state.angle, 0);
}

TEST(CompareView, ControlTurnsInStepsOf15Degrees) {
    Compared c;
    c.ui.drag("Takes/Wipe angle", {-40, 0}, Mods::command);
    EXPECT_NEAR(glm::degrees(c.state.angle), 30, 1e-9);
    c.ui.focus("Takes/Wipe angle").key(Key::left);
    EXPECT_NEAR(glm::degrees(c.state.angle), 15, 1e-9);
}

TEST(CompareView, TheHandleStaysInReachWhenTheLineIsOutOfSight) {
    Compared c;
    c.state.position = 0.1;
    c.state.view = {.fitted = false, .zoom = 16};
    c.ui.frame();
    const Rect handle = c.ui.rect("Takes/Wipe");
    EXPECT_EQ(handle.x, 0);
    EXPECT_EQ(handle.center().y, 150);
}

TEST(CompareView, FHeldFlickersToTheSecond) {
    Compared c;
    c.ui.focus("Takes").send({.kind = EventKind::key, .key = key_of('F')});
    EXPECT_TRUE(c.last.flicker);
    ASSERT_NE(c.batch_of(InstanceKind::image), nullptr);
    EXPECT_EQ(c.batch_of(InstanceKind::image)->images[0], 8U);
    EXPECT_EQ(c.batch_of(InstanceKind::compare), nullptr);
    c.ui.send({.kind = EventKind::key_up, .key = key_of('F')});
    EXPECT_FALSE(c.last.flicker);
    EXPECT_NE(c.batch_of(InstanceKind::compare), nullptr);
}

TEST(CompareView, FFlickersThoughATimelineHasTheKeyboard) {
    CompareState state;
    TimelineState times;
    TimelineTrack track{"Events", {{"Cut", 2, 4}}};
    CompareResult last;
    Harness ui([&](Ui& u) {
        last = compare_view(u, "Takes", {.image = 7, .size = {200, 100}, .pixels = &one},
                            {.image = 8, .size = {200, 100}, .pixels = &two}, state,
                            {.width = px(400), .height = px(300)});
        timeline(u, "Time", times, {&track, 1}, {.length = 10, .rate = 25});
    });
    times.view = {0, 5};
    times.fitted = false;
    ui.frame().click("Time/Events/Cut").move_to("Takes").send({.kind = EventKind::key, .key = key_of('F')});
    EXPECT_TRUE(last.flicker);
    EXPECT_FALSE(times.fitted) << "the timeline's F is for when the pointer is elsewhere";
    ui.send({.kind = EventKind::key_up, .key = key_of('F')}).move_to("Time").key(key_of('F'));
    EXPECT_FALSE(last.flicker);
    EXPECT_TRUE(times.fitted);
}

TEST(CompareView, FFlickersOverTheHandlesOfTheLineAsWell) {
    for (const char* handle : {"Takes/Wipe", "Takes/Wipe angle"}) {
        Compared c;
        c.ui.move_to(handle).send({.kind = EventKind::key, .key = key_of('F')});
        EXPECT_TRUE(c.last.flicker) << handle;
        c.ui.frame().frame();
        EXPECT_TRUE(c.last.flicker) << "as long as it is held: " << handle;
        c.ui.send({.kind = EventKind::key_up, .key = key_of('F')});
        EXPECT_FALSE(c.last.flicker) << handle;
    }
}

TEST(CompareView, FElsewhereDoesNothing) {
    Compared c;
    c.ui.send({.kind = EventKind::key, .key = key_of('F')});
    EXPECT_FALSE(c.last.flicker);
}

TEST(CompareView, XSwapsPicturesAndValues) {
    Compared c;
    c.ui.focus("Takes").move({100, 100}).key('X');
    EXPECT_TRUE(c.state.swapped);
    EXPECT_EQ(c.committed, 1);
    EXPECT_EQ(c.last.first.x, 30);
    EXPECT_EQ(c.last.second.x, 10);
    EXPECT_EQ(c.batch_of(InstanceKind::compare)->images[0], 8U);
    EXPECT_THAT(c.ui.text("Takes"), testing::HasSubstr("B   R 30"));
}

TEST(CompareView, PageKeysSetGainAndMix) {
    Compared c;
    c.state.kind = CompareKind::difference;
    c.ui.frame().focus("Takes").key(Key::page_up);
    EXPECT_EQ(c.state.gain, 8);
    for (int i = 0; i < 10; ++i) c.ui.key(Key::page_up);
    EXPECT_EQ(c.state.gain, 100);
    c.state.kind = CompareKind::onion;
    c.ui.key(Key::page_down);
    EXPECT_NEAR(c.state.mix, 0.4, 1e-9);
    for (int i = 0; i < 10; ++i) c.ui.key(Key::page_down);
    EXPECT_EQ(c.state.mix, 0);
    EXPECT_EQ(c.began, c.committed);
    c.state.kind = CompareKind::wipe;
    const int before = c.committed;
    c.ui.key(Key::page_down);
    EXPECT_EQ(c.committed, before);
}

TEST(CompareView, ZoomAndPanAreOfBoth) {
    Compared c;
    c.ui.wheel("Takes", {0, 2});  // over the handle; the view below it takes the event
    EXPECT_EQ(c.ui.value("Takes"), 4);
    EXPECT_FALSE(c.state.view.fitted);
    c.ui.focus("Takes").type("0");
    EXPECT_TRUE(c.state.view.fitted);
}

TEST(CompareView, DisabledItTakesNothing) {
    Compared c;
    c.disabled = true;
    c.ui.frame().drag("Takes/Wipe", {-100, 0}).wheel("Takes", {0, 2});
    EXPECT_EQ(c.state.position, 0.5);
    EXPECT_EQ(c.state.view, ViewState{});
}

TEST(CompareView, SteadyFramesAndDragsAllocateNothing) {
    Compared c;
    c.ui.press("Takes/Wipe").drag_by({20, 0});
    const auto steps = [&] {
        for (int i = 0; i < 50; ++i) {
            c.ui.ui().push({.kind = EventKind::pointer, .at = {200 + i % 7, 150}});
            c.ui.frame();
        }
    };
    steps();
    const std::size_t before = lapfx::test::allocations_so_far();
    steps();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
    EXPECT_THAT(faults_of(c.ui.ui().tree()), testing::IsEmpty());
}

TEST(CompareView, FAndXWorkUnderThePointerAsItsTipSays) {
    Compared c;
    c.ui.frame().move({100, 100});
    ASSERT_EQ(c.ui.focused(), "");
    c.ui.send({.kind = EventKind::key, .key = key_of('F')});
    EXPECT_TRUE(c.last.flicker);
    c.ui.send({.kind = EventKind::key_up, .key = key_of('F')}).key('X');
    EXPECT_FALSE(c.last.flicker);
    EXPECT_TRUE(c.state.swapped);
    c.ui.move({-5, -5}).key('X');
    EXPECT_TRUE(c.state.swapped) << "not elsewhere";
}

TEST(CompareView, TheBoxOfValuesHasThePointerToItself) {
    Compared c;
    c.options.tip = "F held: the second alone";
    EXPECT_EQ(c.ui.frame().tip("Takes"), c.options.tip);
    c.ui.move({100, 100}).frame(2).frame(2);
    ASSERT_TRUE(c.last.has_pick);
    EXPECT_EQ(c.ui.tip("Takes"), "") << "no tooltip over it";
}

struct Overs {
    std::vector<Rect> areas;
    static void build(Ui& ui, const View& view, void* with) {
        static_cast<Overs*>(with)->areas.push_back(view.area);
        Node& node = ui.leaf(Role::handle, "Corner", Sense::hover | Sense::press);
        node.placed = true;
        node.placement = ui.arena().make(Placement{.offset = glm::vec2(view.to_screen({0, 0})) - view.area.at()});
        node.size[0] = node.size[1] = px(6);
    }
};

TEST(CompareView, WhatLiesOverThePicturesIsBuiltOverEach) {
    Compared c;
    Overs overs;
    c.options.over = Overs::build, c.options.over_with = &overs;
    c.state.kind = CompareKind::side_by_side;
    c.ui.frame().frame();
    overs.areas.clear();
    c.ui.frame();
    ASSERT_EQ(overs.areas.size(), 2U);
    // One above the other, where they are larger.
    const Rect first = c.ui.rect("Takes/First/Corner"), second = c.ui.rect("Takes/Second/Corner");
    EXPECT_EQ(first.y - overs.areas[0].y, second.y - overs.areas[1].y);
    EXPECT_GT(second.y, first.y + 100);
    EXPECT_EQ(second.x, first.x);
    c.state.kind = CompareKind::onion;
    c.ui.frame().frame();
    EXPECT_TRUE(c.ui.exists("Takes/First/Corner"));
    EXPECT_FALSE(c.ui.exists("Takes/Second"));
}

}  // namespace
}  // namespace lapfx::ui
