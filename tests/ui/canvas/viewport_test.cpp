#include "ui/canvas/viewport.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

struct Shown {
    ViewportResult last;
    glm::vec2 dragged{0};
    float wheel = 0;
    int clicked = 0, context = 0, cancelled = 0, pressed = 0, released = 0, most_clicks = 0;
    Button button = Button::left;
    std::vector<Key> keys;
    bool disabled = false;
    Harness ui{[this](Ui& u) {
        u.push_disabled(disabled);
        last = viewport(u, "Scene", 3, "Turn with the left button", px(300), px(200));
        u.pop_disabled();
        dragged += last.drag;
        wheel += last.wheel;
        clicked += last.clicked, context += last.context, cancelled += last.cancelled;
        pressed += last.pressed, released += last.released;
        most_clicks = std::max<int>(most_clicks, last.clicks);
        if (last.dragging) button = last.button;
        for (const ViewportKey& key : last.keys) keys.push_back(key.key);
        last.keys = {};  // they are in this frame's arena
    }};
};

TEST(Viewport, KnowsItsSizeInTheFirstFrameAndAfterEveryChange) {
    glm::ivec2 rendered{0};
    Harness ui([&](Ui& u) { rendered = viewport(u, "Scene", 3).size; });
    EXPECT_EQ(rendered, glm::ivec2(640, 480));
    ui.size = {300, 500};
    ui.frame();
    EXPECT_EQ(rendered, glm::ivec2(300, 500)) << "in the frame of the change, not the next";
}

TEST(Viewport, DragsAreGivenWithTheirButton) {
    for (const Button button : {Button::left, Button::right, Button::middle}) {
        Shown s;
        s.ui.send({.kind = EventKind::press, .button = button, .at = {100, 50}});
        s.ui.send({.kind = EventKind::pointer, .mods = Mods::shift, .at = {120, 45}});
        EXPECT_EQ(s.last.mods, Mods::shift);
        EXPECT_EQ(s.dragged, glm::vec2(20, -5));
        EXPECT_EQ(s.last.pressed_at, glm::vec2(100, 50));
        s.ui.send({.kind = EventKind::release, .button = button, .at = {130, 45}});
        EXPECT_EQ(s.dragged, glm::vec2(30, -5)) << "nothing is lost, nothing counted twice";
        EXPECT_EQ(s.button, button);
        EXPECT_FALSE(s.last.dragging);
        EXPECT_EQ(s.clicked + s.context, 0);
        EXPECT_EQ(s.pressed, 1);
        EXPECT_EQ(s.released, 1);
    }
}

TEST(Viewport, AStillPressIsAClickOrAsksForTheMenu) {
    Shown s;
    s.ui.click("Scene");
    EXPECT_EQ(s.clicked, 1);
    EXPECT_EQ(s.context, 0);
    s.ui.right_click("Scene");
    EXPECT_EQ(s.context, 1);
    s.ui.click("Scene", {.clicks = 2});
    EXPECT_EQ(s.most_clicks, 2);
    EXPECT_EQ(s.last.pointer, glm::vec2(150, 100));
}

TEST(Viewport, TheWheelAndKeysAreHandedOn) {
    Shown s;
    s.ui.wheel("Scene", {0, -2});
    EXPECT_EQ(s.wheel, -2);
    s.ui.focus("Scene").key('G').key(Key::escape).key(Key::menu).key(Key::left);
    EXPECT_THAT(s.keys, testing::ElementsAre(key_of('G'), Key::escape, Key::menu, Key::left));
    EXPECT_EQ(s.context, 1);
    EXPECT_TRUE(s.last.focused);
    s.ui.key(Key::tab, Mods::shift).key('S', Mods::command);
    EXPECT_EQ(s.keys.size(), 4U);
}

TEST(Viewport, EscapeDuringADragCancelsIt) {
    Shown s;
    s.ui.press("Scene").drag_by({40, 0}).key(Key::escape);
    EXPECT_EQ(s.cancelled, 1);
    EXPECT_FALSE(s.last.dragging);
    s.ui.drag_by({40, 0}).release();
    EXPECT_EQ(s.dragged, glm::vec2(40, 0));
    EXPECT_EQ(s.released, 0);
}

TEST(Viewport, DisabledItTakesNothing) {
    Shown s;
    s.disabled = true;
    s.ui.frame().drag("Scene", {40, 0}).wheel("Scene", {0, 1}).click("Scene");
    EXPECT_EQ(s.dragged, glm::vec2(0));
    EXPECT_EQ(s.clicked, 0);
    EXPECT_EQ(s.wheel, 0);
    EXPECT_EQ(s.ui.tip("Scene"), "Turn with the left button");
}

}  // namespace
}  // namespace lapfx::ui
