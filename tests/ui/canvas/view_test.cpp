#include "ui/canvas/view.h"

#include <gmock/gmock.h>

#include <random>

#include "ui/core/node.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

constexpr Rect area{10, 20, 400, 300};
constexpr glm::ivec2 size{200, 100};

TEST(View, ANewOneShowsAllInTheMiddle) {
    const View view = view_of({}, area, size);
    EXPECT_EQ(view.zoom, 2);
    EXPECT_EQ(view.rect(), (Rect{10, 70, 400, 200}));
    EXPECT_EQ(view.pixel_at({10, 70}), glm::ivec2(0, 0));
    EXPECT_EQ(view.pixel_at({409, 269}), glm::ivec2(199, 99));
    EXPECT_EQ(view.pixel_at({9, 69}), glm::ivec2(-1, -1));
    EXPECT_FALSE(view.has_pixel({-1, 0}));
    EXPECT_TRUE(view.has_pixel({199, 99}));
    EXPECT_FALSE(view.has_pixel({200, 0}));
}

TEST(View, AFittedOneFollowsItsArea) {
    EXPECT_EQ(view_of({}, {0, 0, 100, 300}, size).zoom, 0.5);
    EXPECT_EQ(view_of({}, {0, 0, 800, 300}, size).zoom, 3);
    EXPECT_EQ(view_of({}, {0, 0, 0, 0}, size).zoom, 1);
    EXPECT_EQ(view_of({}, area, {0, -5}).size, glm::ivec2(1, 1));
}

TEST(View, ZoomingKeepsWhatIsUnderThePointer) {
    std::mt19937 random(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    for (int i = 0; i < 2000; ++i) {
        ViewState state{
            .fitted = i % 2 == 0, .zoom = between(0.5, 60), .center = {between(0.4, 0.6), between(0.4, 0.6)}};
        const glm::vec2 at(between(150, 270), between(110, 230));
        const glm::dvec2 before = view_of(state, area, size).to_picture(at);
        const double coarse = std::min(view_of(state, area, size).zoom, 2.0);
        set_zoom(state, area, size, between(1, 64), at);
        if (state.center.x <= 0 || state.center.x >= 1 || state.center.y <= 0 || state.center.y >= 1) continue;
        const View after = view_of(state, area, size);
        EXPECT_LE(glm::distance(after.to_picture(at), before), 1 / coarse + 1 / after.zoom) << i;
    }
}

TEST(View, ZoomsFromAQuarterOfTheSmallerToTheMost) {
    ViewState state;
    set_zoom(state, area, size, 1e9, {100, 100});
    EXPECT_EQ(state.zoom, most_zoom);
    set_zoom(state, area, size, 1e-9, {100, 100});
    EXPECT_EQ(state.zoom, 0.25);
    set_zoom(state, area, {4000, 3000}, 0, {100, 100});
    EXPECT_EQ(state.zoom, 0.025);
    state = {};
    set_zoom(state, area, {2, 2}, 1e9, {100, 100});
    EXPECT_EQ(state.zoom, 150) << "a tiny picture is fitted larger than the most";
}

TEST(View, StepsArePowersOfTwo) {
    ViewState state{.fitted = false, .zoom = 3};
    step_zoom(state, area, size, 1, area.center());
    EXPECT_EQ(state.zoom, 4);
    step_zoom(state, area, size, 1, area.center());
    EXPECT_EQ(state.zoom, 8);
    step_zoom(state, area, size, -1, area.center());
    EXPECT_EQ(state.zoom, 4);
    state.zoom = 0.7;
    step_zoom(state, area, size, -1, area.center());
    EXPECT_EQ(state.zoom, 0.5);
}

TEST(View, EdgesNeverPassTheMiddle) {
    ViewState state;
    pan(state, area, size, {0, 0});
    EXPECT_TRUE(state.fitted) << "no way is no pan";
    pan(state, area, size, {20, -10});
    EXPECT_FALSE(state.fitted);
    EXPECT_EQ(state.zoom, 2);
    EXPECT_EQ(view_of(state, area, size).rect(), (Rect{30, 60, 400, 200}));
    pan(state, area, size, {1e6, -1e6});
    EXPECT_EQ(state.center, glm::dvec2(0, 1));
}

TEST(View, APixelOutsideIsBroughtInByTheShortestWay) {
    ViewState state{.fitted = false, .zoom = 8};
    const ViewState before = state;
    show_pixel(state, area, size, {100, 50});
    EXPECT_EQ(state, before);
    show_pixel(state, area, size, {199, 50});
    EXPECT_EQ(view_of(state, area, size).pixel_rect({199, 50}, {1, 1}).right(), area.right());
    EXPECT_EQ(state.center.y, 0.5);
    show_pixel(state, area, size, {100, 0});
    EXPECT_EQ(view_of(state, area, size).pixel_rect({100, 0}, {1, 1}).y, area.y);
}

TEST(View, PicturesLieOnWholePixels) {
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        const auto any = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
        const View view = view_of({.fitted = false, .zoom = 0.1 + 10 * any(), .center = {any(), any()}}, area, size);
        EXPECT_EQ(view.corner, glm::round(view.corner));
        const glm::ivec2 p(i % 200, i % 100);
        EXPECT_EQ(view.pixel_at(glm::vec2(view.to_screen(glm::dvec2(p) + 0.5))), p);
    }
}

TEST(DragWay, CountsOnlyFromPressToRelease) {
    DragWay way;
    EXPECT_EQ(way.take({.kind = EventKind::pointer, .at = {5, 5}}), glm::vec2(0));
    way.take({.kind = EventKind::press, .button = Button::middle, .at = {10, 10}});
    EXPECT_TRUE(way.on);
    EXPECT_EQ(way.button, Button::middle);
    EXPECT_EQ(way.take({.kind = EventKind::pointer, .at = {13, 9}}), glm::vec2(3, -1));
    EXPECT_EQ(way.take({.kind = EventKind::release, .at = {14, 9}}), glm::vec2(1, 0));
    EXPECT_EQ(way.take({.kind = EventKind::pointer, .at = {50, 50}}), glm::vec2(0));
}

struct Steered {
    ViewState state;
    bool left_pans = true;
    int moved = 0;
    Harness ui{[this](Ui& u) {
        Node& node = u.leaf(Role::image, "Picture", view_sense);
        node.size[0] = px(400), node.size[1] = px(300);
        u.respond(node);
        moved += steer(u, node, state, u.rect_before(node.id), size, left_pans) ? 1 : 0;
    }};
    double zoom() const { return view_of(state, {0, 0, 400, 300}, size).zoom; }
    Steered& drag(Button button) {
        ui.send({.kind = EventKind::press, .button = button, .at = {100, 100}});
        ui.send({.kind = EventKind::pointer, .at = {130, 90}});
        ui.send({.kind = EventKind::release, .button = button, .at = {130, 90}});
        ui.frame(1);
        return *this;
    }
};

TEST(Steer, TheWheelZoomsAtThePointerAndStopsAtOneToOne) {
    Steered s;
    s.ui.send({.kind = EventKind::pointer, .at = {100, 150}});
    const glm::dvec2 under = view_of(s.state, {0, 0, 400, 300}, size).to_picture({100, 150});
    s.ui.send({.kind = EventKind::wheel, .delta = {0, 2}});
    EXPECT_EQ(s.zoom(), 4);
    EXPECT_LT(glm::distance(view_of(s.state, {0, 0, 400, 300}, size).to_picture({100, 150}), under), 0.5);
    s.ui.send({.kind = EventKind::wheel, .delta = {0, -5}});
    EXPECT_EQ(s.zoom(), 1) << "stops on the way";
    s.ui.send({.kind = EventKind::wheel, .delta = {0, -1}});
    EXPECT_NEAR(s.zoom(), std::exp2(-0.5), 1e-12);
    EXPECT_EQ(s.moved, 3);
}

TEST(Steer, LeftAndMiddlePan) {
    Steered s;
    s.drag(Button::left);
    EXPECT_LT(glm::distance(s.state.center, glm::dvec2(0.5 - 15.0 / 200, 0.5 + 5.0 / 100)), 1e-12);
    s.drag(Button::middle);
    EXPECT_LT(glm::distance(s.state.center, glm::dvec2(0.5 - 30.0 / 200, 0.5 + 10.0 / 100)), 1e-12);
    EXPECT_EQ(s.moved, 2);
}

TEST(Steer, WhereLeftHasOtherWorkItPansWithTheSpaceBar) {
    Steered s;
    s.left_pans = false;
    s.drag(Button::left);
    EXPECT_EQ(s.state, ViewState{});
    s.ui.send({.kind = EventKind::key, .key = Key::space});
    s.drag(Button::left);
    EXPECT_NE(s.state, ViewState{});
}

TEST(Steer, EscapePutsAPanBack) {
    Steered s;
    s.ui.press("Picture").drag_by({50, 50});
    EXPECT_NE(s.state, ViewState{});
    s.ui.key(Key::escape);
    EXPECT_EQ(s.state, ViewState{});
    s.ui.drag_by({50, 50});
    EXPECT_EQ(s.state, ViewState{}) << "the drag is over";
}

TEST(Steer, KeysFitAndStep) {
    Steered s;
    s.ui.focus("Picture").type("1");
    EXPECT_EQ(s.zoom(), 1);
    s.ui.type("+");
    EXPECT_EQ(s.zoom(), 2);
    s.ui.type("=");
    EXPECT_EQ(s.zoom(), 4);
    s.ui.type("-");
    EXPECT_EQ(s.zoom(), 2);
    EXPECT_FALSE(s.state.fitted);
    s.ui.type("0");
    EXPECT_TRUE(s.state.fitted);
    s.ui.key(Key::escape);
    EXPECT_EQ(s.ui.focused(), "") << "Esc leaves it";
}

TEST(Steer, ADoubleClickFits) {
    Steered s;
    s.state = {.fitted = false, .zoom = 5};
    s.ui.click("Picture");
    EXPECT_FALSE(s.state.fitted);
    s.ui.click("Picture", {.clicks = 2});
    EXPECT_TRUE(s.state.fitted);
}

}  // namespace
}  // namespace lapfx::ui
