#include "ui/widgets/toolbar.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

/// A toolbar with a button and a toggle, so narrow that both are in the menu.
struct Tools {
    int runs = 0;
    bool loops = false;
    Harness ui{[this](Ui& u) {
        const std::array<ToolItem, 2> items = {ToolItem{.width = 200}, ToolItem{.width = 200}};
        toolbar(u, "Tools", 120, items, [this, &u](std::size_t item) {
            if (item == 0 && button(u, "Run")) ++runs;
            if (item == 1) toggle(u, "Loop", loops);
        });
    }};
};

TEST(Toolbar, WhatIsChosenInItsMenuClosesIt) {
    Tools t;
    t.ui.click("More...").frame();
    t.ui.click("Tools/Run").frame();
    EXPECT_EQ(t.runs, 1);
    EXPECT_FALSE(t.ui.exists("Tools/Run")) << t.ui.dump();
    t.ui.click("More...").frame();
    t.ui.focus("Tools/Run").key(Key::enter).frame();
    EXPECT_EQ(t.runs, 2);
    EXPECT_FALSE(t.ui.exists("Tools/Run")) << "by the keyboard, too";
}

TEST(Toolbar, WhatIsSetThereLeavesItOpen) {
    Tools t;
    t.ui.click("More...").frame();
    t.ui.click("Tools/Loop").frame();
    EXPECT_TRUE(t.loops);
    EXPECT_TRUE(t.ui.exists("Tools/Run"));
}

}  // namespace
}  // namespace lapfx::ui
