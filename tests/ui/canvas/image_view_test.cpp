#include "ui/canvas/image_view.h"

#include <gmock/gmock.h>

#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

/// Red is the column, green the row, blue half a level, alpha full.
struct Ramp : PickSource {
    glm::vec4 pixel(glm::ivec2 at) const override { return {at.x, at.y, 0.5F, 255}; }
};
const Ramp ramp;

TEST(MeanOf, AveragesWhatIsInside) {
    const glm::ivec2 size(20, 10);
    EXPECT_EQ(mean_of(ramp, size, {5, 4}, 1), glm::vec4(5, 4, 0.5F, 255));
    EXPECT_EQ(mean_of(ramp, size, {5, 4}, 3), glm::vec4(5, 4, 0.5F, 255));
    EXPECT_EQ(mean_of(ramp, size, {0, 0}, 3), glm::vec4(0.5F, 0.5F, 0.5F, 255));
    EXPECT_EQ(mean_of(ramp, size, {19, 9}, 5), glm::vec4(18, 8, 0.5F, 255));
    EXPECT_EQ(mean_of(ramp, size, {10, 5}, 11), glm::vec4(10, 4.5F, 0.5F, 255)) << "rows 0 to 9";
    EXPECT_EQ(mean_of(ramp, size, {-50, 5}, 3), glm::vec4(0));
}

TEST(Beside, TheBoxCoversNothingOfWhatIsMeasuredWhereThereIsRoom) {
    const Rect area{10, 20, 400, 300};
    const glm::vec2 size(150, 60);
    for (float x = 10; x <= 370; x += 40)
        for (float y = 20; y <= 280; y += 40) {
            const Rect measured{x, y, 40, 40};
            const glm::vec2 at = beside(area, measured, size);
            const Rect box{at.x, at.y, size.x, size.y}, both = intersect(box, measured);
            EXPECT_FALSE(both.w > 0 && both.h > 0) << x << ", " << y;
            EXPECT_EQ(intersect(box, area), box) << x << ", " << y;
        }
    EXPECT_EQ(beside(area, {100, 100, 40, 40}, size), glm::vec2(140, 140)) << "right of and below it";
    EXPECT_EQ(beside({0, 0, 200, 100}, {80, 30, 40, 40}, {190, 30}), glm::vec2(10, 70)) << "below it, at the edge";
}

/// A picture of 200 x 100 pixels in 400 x 300 px: when fitted, its scale is 2 and its upper left corner is at 0, 50.
struct Viewed {
    ViewState state;
    Picture picture{.image = 7, .size = {200, 100}, .pixels = &ramp};
    ImageViewOptions options{.width = px(400), .height = px(300)};
    bool disabled = false;
    ImageViewResult last;
    int moved = 0, picked = 0;
    glm::vec4 taken{0};
    Harness ui{[this](Ui& u) {
        u.push_disabled(disabled);
        last = image_view(u, "Clip", picture, state, options);
        u.pop_disabled();
        moved += last.view_changed;
        if (last.picked) ++picked, taken = last.value;
    }};
    std::size_t drawn(InstanceKind kind) const {
        std::size_t count = 0;
        for (const Instance& each : ui.output().list->instances) count += each.kind == kind ? 1 : 0;
        return count;
    }
};

TEST(Readout, TheRoomBesideWhatIsKeptOffHasNothingOfIt) {
    const Rect area{0, 0, 400, 300};
    EXPECT_EQ(room_beside(area, {}, {100, 100}), area) << "nothing is kept off";
    EXPECT_EQ(room_beside(area, {500, 0, 50, 50}, {100, 100}), area) << "it lies elsewhere";
    EXPECT_EQ(room_beside(area, {100, 260, 200, 30}, {100, 100}), (Rect{0, 0, 400, 260})) << "above";
    EXPECT_EQ(room_beside(area, {100, 10, 200, 30}, {100, 100}), (Rect{0, 40, 400, 260})) << "below";
    EXPECT_EQ(room_beside(area, {150, 150, 240, 30}, {100, 200}), (Rect{0, 0, 150, 300})) << "left: too low elsewhere";
    EXPECT_EQ(room_beside(area, {10, 100, 240, 100}, {100, 200}), (Rect{250, 0, 150, 300})) << "right";
    EXPECT_TRUE(room_beside(area, {50, 100, 300, 100}, {100, 200}).empty());
}

TEST(ImageView, ShowsAllOfThePictureAndSaysItsZoom) {
    Viewed v;
    EXPECT_EQ(v.ui.value("Clip"), 2);
    EXPECT_EQ(v.ui.node("Clip").role, Role::image);
    ASSERT_EQ(v.drawn(InstanceKind::image), 1U);
    for (const Instance& each : v.ui.output().list->instances) {
        if (each.kind != InstanceKind::image) continue;
        EXPECT_EQ((Rect{each.x, each.y, each.w, each.h}), (Rect{0, 50, 400, 200}));
        EXPECT_EQ(each.border, 0) << "smooth";
    }
}

TEST(ImageView, GivesTheExactValueUnderThePointer) {
    Viewed v;
    v.ui.move({101, 91});
    EXPECT_TRUE(v.last.has_pick);
    EXPECT_EQ(v.last.pick, glm::ivec2(50, 20));
    EXPECT_EQ(v.last.value, glm::vec4(50, 20, 0.5F, 255));
    EXPECT_EQ(v.ui.text("Clip"), "50, 20   R 50  G 20  B 0.5  A 255");
    v.ui.move({101, 20});
    EXPECT_FALSE(v.last.has_pick) << "beside the picture";
    v.ui.move({101, 91});
    v.ui.send({.kind = EventKind::pointer_out});
    EXPECT_FALSE(v.last.has_pick);
}

TEST(ImageView, AveragesASampleBox) {
    Viewed v;
    v.options.sample_box = 3;
    v.ui.move({0, 50});
    EXPECT_EQ(v.last.value, glm::vec4(0.5F, 0.5F, 0.5F, 255));
}

TEST(ImageView, ArrowsMoveThePickByAPixel) {
    Viewed v;
    v.ui.focus("Clip").move({101, 91});
    v.ui.key(Key::right).key(Key::down);
    EXPECT_EQ(v.last.pick, glm::ivec2(51, 21));
    v.ui.key(Key::left, Mods::shift).key(Key::up);
    EXPECT_EQ(v.last.pick, glm::ivec2(41, 20));
    v.ui.frame();
    EXPECT_TRUE(v.last.has_pick) << "it stays while the pointer does";
    v.ui.move({103, 91});
    EXPECT_EQ(v.last.pick, glm::ivec2(51, 20));
}

TEST(ImageView, TheFirstArrowShowsThePickInTheMiddleAndEscapeTakesItAway) {
    Viewed v;
    v.ui.focus("Clip").key(Key::right);
    EXPECT_EQ(v.last.pick, glm::ivec2(100, 50));
    v.ui.key(Key::escape);
    EXPECT_FALSE(v.last.has_pick);
}

TEST(ImageView, ThePickStaysInThePictureAndInSight) {
    Viewed v;
    v.state = {.fitted = false, .zoom = 16};
    v.ui.frame().focus("Clip").key(Key::right);
    for (int i = 0; i < 5; ++i) v.ui.key(Key::right, Mods::shift);
    EXPECT_EQ(v.last.pick, glm::ivec2(150, 50));
    EXPECT_GT(v.moved, 0);
    const Rect pixel = view_of(v.state, {0, 0, 400, 300}, {200, 100}).pixel_rect({150, 50}, {1, 1});
    EXPECT_LE(pixel.right(), 400);
    for (int i = 0; i < 10; ++i) v.ui.key(Key::right, Mods::shift);
    EXPECT_EQ(v.last.pick, glm::ivec2(199, 50));
}

TEST(ImageView, ThePixelGridComesWithLargePixelsAndSmoothingGoes) {
    Viewed v;
    v.state = {.fitted = false, .zoom = 7.9};
    v.ui.frame();
    const std::size_t before = v.drawn(InstanceKind::fill);
    v.state.zoom = 8;
    v.ui.frame();
    EXPECT_GE(v.drawn(InstanceKind::fill), before + 2 * (50 + 37)) << "400 / 8 columns, 300 / 8 rows";
    for (const Instance& each : v.ui.output().list->instances) {
        if (each.kind == InstanceKind::image) {
            EXPECT_EQ(each.border, 1);
        }
    }
    v.options.grid = false;
    v.ui.frame();
    EXPECT_EQ(v.drawn(InstanceKind::fill), before);
}

TEST(ImageView, ACheckerboardLiesBehindATransparentPicture) {
    Viewed v;
    EXPECT_EQ(v.drawn(InstanceKind::checker), 0U);
    v.picture.transparent = true;
    v.ui.frame();
    EXPECT_EQ(v.drawn(InstanceKind::checker), 1U);
    v.ui.ui().set_theme(light_theme());
    v.ui.frame();
    for (const Instance& each : v.ui.output().list->instances) {
        if (each.kind != InstanceKind::checker) continue;
        EXPECT_GT(contrast(each.color, rgb(0xd0d0d0)), 4.5) << "light smoke is seen in either theme";
    }
}

TEST(ImageView, TheMagnifierIsASecondImage) {
    Viewed v;
    v.options.magnifier = true;
    v.ui.move({101, 91});
    EXPECT_EQ(v.drawn(InstanceKind::image), 2U);
    v.options.readout = false;
    v.ui.frame();
    EXPECT_EQ(v.drawn(InstanceKind::image), 1U);
    EXPECT_TRUE(v.last.has_pick);
}

TEST(ImageView, WithoutAPictureItSaysSoAndPicksNothing) {
    Viewed v;
    v.picture = {};
    v.ui.frame().move({200, 150});
    EXPECT_FALSE(v.last.has_pick);
    EXPECT_EQ(v.drawn(InstanceKind::image), 0U);
}

TEST(ImageView, TheEyedropperTakesAColourByClickAndEnter) {
    Viewed v;
    v.options.eyedropper = true;
    v.ui.send({.kind = EventKind::pointer, .at = {101, 91}});
    EXPECT_EQ(v.ui.output().cursor, Cursor::crosshair);
    v.ui.send({.kind = EventKind::press, .at = {101, 91}});
    EXPECT_EQ(v.picked, 1);
    EXPECT_EQ(v.taken, glm::vec4(50, 20, 0.5F, 255));
    v.ui.send({.kind = EventKind::pointer, .at = {151, 91}});
    v.ui.send({.kind = EventKind::release, .at = {151, 91}});
    EXPECT_EQ(v.picked, 1);
    EXPECT_EQ(v.state, ViewState{}) << "the left button does not pan";
    v.ui.key(Key::right).key(Key::enter);
    EXPECT_EQ(v.picked, 2);
    EXPECT_EQ(v.taken.x, 76);
}

TEST(ImageView, WithoutTheEyedropperAClickTakesNothing) {
    Viewed v;
    v.ui.click("Clip").key(Key::enter);
    EXPECT_EQ(v.picked, 0);
}

TEST(ImageView, LinkedViewsMoveTogether) {
    ViewState state;
    const Picture picture{.image = 7, .size = {200, 100}, .pixels = &ramp};
    Harness ui([&](Ui& u) {
        Row row(u);
        for (const char* name : {"Left", "Right"})
            image_view(u, name, picture, state, {.width = px(200), .height = px(200)});
    });
    ui.wheel("Left", {0, 2});
    EXPECT_EQ(ui.value("Left"), 2);
    ui.frame();
    EXPECT_EQ(ui.value("Right"), 2);
}

TEST(ImageView, DisabledItNeitherMovesNorPicks) {
    Viewed v;
    v.disabled = true;
    v.ui.frame().wheel("Clip", {0, 2}).drag("Clip", {50, 0});
    EXPECT_EQ(v.state, ViewState{});
    EXPECT_FALSE(v.last.has_pick);
}

TEST(ImageView, NothingIsUnnamedAndATipIsShown) {
    Viewed v;
    v.options.tip = "The clip as filmed";
    v.ui.frame();
    EXPECT_THAT(faults_of(v.ui.ui().tree()), testing::IsEmpty());
    EXPECT_EQ(v.ui.tip("Clip"), "The clip as filmed");
}

TEST(ImageView, SteadyFramesAndDragsAllocateNothing) {
    Viewed v;
    v.options.magnifier = true;
    v.state = {.fitted = false, .zoom = 10};
    v.ui.move({200, 150}).frame();
    const auto steps = [&] {
        for (int i = 0; i < 50; ++i) {
            v.ui.ui().push({.kind = EventKind::pointer, .at = {200 + i % 7, 150}});
            v.ui.frame();
        }
    };
    v.ui.send({.kind = EventKind::press, .button = Button::middle, .at = {200, 150}});
    steps();
    const std::size_t before = lapfx::test::allocations_so_far();
    steps();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
}

}  // namespace
}  // namespace lapfx::ui
