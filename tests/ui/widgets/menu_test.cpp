#include "ui/widgets/menu.h"

#include <gmock/gmock.h>

#include "ui/core/node.h"
#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"
#include "ui/widgets/basic.h"

namespace lapfx::ui {
namespace {

/// A bar with two menus, one of which has a submenu, and a field with a context menu.
class MenuTest : public testing::Test {
  protected:
    std::string chosen;
    bool can_save = true, shows_edit = false;
    void choose(Ui& u, const char* name, const MenuItemOptions& options = {}) {
        if (menu_item(u, name, options)) chosen += std::string(name) + ";";
    }
    void build(Ui& u) {
        {
            MenuBar bar(u);
            if (BarMenu file(u, "File"); file) {
                choose(u, "Open", {.shortcut = "Ctrl+O"});
                choose(u, "Save", {.tip = "Writes it", .enabled = can_save});
                menu_separator(u);
                if (Submenu recent(u, "Recent"); recent) {
                    choose(u, "One");
                    if (Submenu older(u, "Older"); older) choose(u, "Two");
                }
                choose(u, "Quit");
            }
            if (shows_edit) {
                if (BarMenu edit(u, "Edit"); edit) choose(u, "Undo", {.enabled = false});
            }
            if (BarMenu view(u, "View"); view) {
                choose(u, "Grid", {.checked = true});
                choose(u, "Guides");
                choose(u, "Gamut");
            }
        }
        Row row(u);
        if (button(u, "Field")) open_menu(u, "context", {.side = Placement::Side::pointer, .rect = {50, 200, 0, 0}});
        if (Menu menu(u, "context", "Field menu"); menu) choose(u, "Reset");
    }
    Harness ui{[this](Ui& u) { build(u); }};
};

TEST_F(MenuTest, APressOpensAndAnotherCloses) {
    ui.click("Menu bar/File");
    EXPECT_TRUE(ui.exists("File/Open"));
    EXPECT_TRUE(ui.is("Menu bar/File", Is::expanded));
    ui.click("Menu bar/File");
    EXPECT_FALSE(ui.exists("File/Open"));
}

TEST_F(MenuTest, AClickedItemIsChosenOnceAndClosesAll) {
    ui.click("Menu bar/File").click("File/Open");
    EXPECT_EQ(chosen, "Open;");
    EXPECT_EQ(ui.ui().overlay_count(), 0U);
    ui.frame();
    EXPECT_EQ(chosen, "Open;");
}

TEST_F(MenuTest, AMenuGivesTheKeyboardBackToWhatHadIt) {
    ui.focus("Field");
    ui.click("Menu bar/File").click("File/Open");
    EXPECT_EQ(ui.focused(), "Field");
    ui.click("Menu bar/File").key(Key::escape);
    EXPECT_EQ(ui.focused(), "Field");
}

TEST_F(MenuTest, ItemsAreSpokenOfWithTheirShortcutStateAndTip) {
    ui.click("Menu bar/File");
    EXPECT_EQ(ui.node("File/Open").role, Role::menu_item);
    EXPECT_EQ(ui.text("File/Open"), "Ctrl+O");
    EXPECT_EQ(ui.tip("File/Save"), "Writes it");
    EXPECT_EQ(ui.node("File").role, Role::menu);
    ui.move_to("Menu bar/View");
    EXPECT_TRUE(ui.is("View/Grid", Is::checked));
    EXPECT_FALSE(ui.is("View/Guides", Is::checked));
}

TEST_F(MenuTest, ADisabledItemIsNeitherReachedNorChosen) {
    can_save = false;
    ui.click("Menu bar/File");
    EXPECT_TRUE(ui.is("File/Save", Is::disabled));
    ui.click("File/Save");
    EXPECT_EQ(chosen, "");
    EXPECT_TRUE(ui.exists("File/Save")) << "and the menu stays";
    ui.key(Key::home).key(Key::down);
    EXPECT_EQ(ui.focused(), "File/Recent");
}

TEST_F(MenuTest, ArrowsGoRoundHomeAndEndToTheEnds) {
    ui.focus("Menu bar/File").key(Key::enter);
    EXPECT_EQ(ui.focused(), "File/Open");
    EXPECT_EQ(ui.key(Key::up).focused(), "File/Quit");
    EXPECT_EQ(ui.key(Key::down).focused(), "File/Open");
    EXPECT_EQ(ui.key(Key::end).focused(), "File/Quit");
    EXPECT_EQ(ui.key(Key::home).focused(), "File/Open");
    ui.key(Key::down).key(Key::enter);
    EXPECT_EQ(chosen, "Save;");
    EXPECT_EQ(ui.focused(), "Menu bar/File");
}

TEST_F(MenuTest, LettersGoToTheNextItemThatBeginsSoAndRound) {
    ui.focus("Menu bar/View").key(Key::down);
    EXPECT_EQ(ui.focused(), "View/Grid");
    EXPECT_EQ(ui.type("g").focused(), "View/Guides");
    EXPECT_EQ(ui.type("G").focused(), "View/Gamut");
    EXPECT_EQ(ui.type("g").focused(), "View/Grid");
    EXPECT_EQ(ui.type("x").focused(), "View/Grid");
    ui.type(" ");
    EXPECT_EQ(chosen, "Grid;");
}

TEST_F(MenuTest, LeftAndRightGoAlongTheBar) {
    ui.focus("Menu bar/File").key(Key::enter);
    EXPECT_EQ(ui.key(Key::right).focused(), "View/Grid");
    EXPECT_FALSE(ui.exists("File/Open"));
    EXPECT_EQ(ui.key(Key::right).focused(), "File/Open");
    EXPECT_EQ(ui.key(Key::left).focused(), "View/Grid");
    EXPECT_EQ(ui.ui().overlay_count(), 1U);
}

TEST_F(MenuTest, WhileOneIsOpenTheBarFollowsThePointer) {
    ui.move_to("Menu bar/View");
    EXPECT_FALSE(ui.exists("View/Grid"));
    ui.click("Menu bar/File").move_to("Menu bar/View");
    EXPECT_TRUE(ui.exists("View/Grid"));
    EXPECT_FALSE(ui.exists("File/Open"));
}

TEST_F(MenuTest, ASubmenuOpensByRightOrEnterAndClosesByLeftOrEscape) {
    ui.focus("Menu bar/File").key(Key::enter).type("r");
    EXPECT_EQ(ui.focused(), "File/Recent");
    EXPECT_EQ(ui.key(Key::right).focused(), "Recent/One");
    EXPECT_TRUE(ui.is("File/Recent", Is::expanded));
    EXPECT_EQ(ui.key(Key::left).focused(), "File/Recent");
    EXPECT_FALSE(ui.exists("Recent/One"));
    EXPECT_EQ(ui.key(Key::enter).focused(), "Recent/One");
    EXPECT_EQ(ui.key(Key::escape).focused(), "File/Recent");
    EXPECT_TRUE(ui.exists("File/Open"));
    ui.key(Key::right).key(Key::down).key(Key::right);
    EXPECT_EQ(ui.focused(), "Older/Two");
    ui.key(Key::enter);
    EXPECT_EQ(chosen, "Two;");
    EXPECT_EQ(ui.ui().overlay_count(), 0U);
    EXPECT_EQ(ui.focused(), "Menu bar/File");
}

TEST_F(MenuTest, RightInASubmenuGoesOnAlongTheBar) {
    ui.focus("Menu bar/File").key(Key::enter).type("r").key(Key::right).key(Key::right);
    EXPECT_EQ(ui.focused(), "View/Grid");
    EXPECT_EQ(ui.ui().overlay_count(), 1U);
}

TEST_F(MenuTest, ASubmenuOpensWhereThePointerStaysAndForgivesADiagonal) {
    ui.click("Menu bar/File").move_to("File/Recent");
    EXPECT_FALSE(ui.exists("Recent/One"));
    EXPECT_LT(ui.output().wake_at, ui.time + 0.2);
    ui.frame(0.15);
    ASSERT_TRUE(ui.exists("Recent/One"));
    ui.move_to("File/Quit").frame(0.1);
    EXPECT_TRUE(ui.exists("Recent/One")) << "on the way to it";
    ui.move_to("Recent/One").frame(0.5);
    EXPECT_EQ(ui.focused(), "Recent/One");
    ui.move_to("File/Quit").frame(0.3);
    EXPECT_FALSE(ui.exists("Recent/One"));
    EXPECT_EQ(ui.focused(), "File/Quit");
}

TEST_F(MenuTest, TheSubmenuLiesBesideItsItem) {
    ui.focus("Menu bar/File").key(Key::enter).type("r").key(Key::right);
    EXPECT_EQ(ui.rect("Recent").x, ui.rect("File/Recent").right());
    EXPECT_NEAR(ui.rect("Recent/One").y, ui.rect("File/Recent").y, 1);
}

TEST_F(MenuTest, APressOutsideClosesAllOfAChain) {
    ui.focus("Menu bar/File").key(Key::enter).type("r").key(Key::right);
    ui.send({.kind = EventKind::press, .at = {600, 450}}).send({.kind = EventKind::release, .at = {600, 450}});
    EXPECT_EQ(ui.ui().overlay_count(), 0U);
}

TEST_F(MenuTest, AContextMenuOpensAtThePointer) {
    ui.click("Field");
    EXPECT_EQ(ui.rect("Field menu").at(), glm::vec2(50, 200));
    ui.click("Field menu/Reset");
    EXPECT_EQ(chosen, "Reset;");
}

TEST_F(MenuTest, OpenedByThePointerNoItemIsMarkedUntilAKeyAsksForOne) {
    ui.click("Field").key(Key::enter);
    EXPECT_EQ(chosen, "");
    ui.key(Key::escape).click("Menu bar/File");
    EXPECT_EQ(ui.key(Key::down).focused(), "File/Open");
    EXPECT_TRUE(ui.is("File/Open", Is::ringed));
    ui.key(Key::escape).click("Menu bar/File");
    EXPECT_EQ(ui.key(Key::up).focused(), "File/Quit");
    ui.key(Key::escape).click("Menu bar/File");
    EXPECT_EQ(ui.type("r").focused(), "File/Recent");
    ui.key(Key::enter).key(Key::enter);
    EXPECT_EQ(chosen, "One;");
}

TEST_F(MenuTest, AMenuWithoutAnItemToChooseIsPassedAlongTheBar) {
    shows_edit = true;
    ui.frame().focus("Menu bar/File").key(Key::enter).key(Key::right);
    EXPECT_TRUE(ui.exists("Edit/Undo"));
    ui.key(Key::down);
    EXPECT_EQ(ui.key(Key::right).focused(), "View/Grid");
    ui.key(Key::left).key(Key::left);
    EXPECT_EQ(ui.focused(), "File/Open");
    EXPECT_EQ(ui.ui().overlay_count(), 1U);
}

TEST_F(MenuTest, AnOpenMenuAllocatesNothingAndComesToRest) {
    ui.click("Menu bar/File").move_to("File/Open").frame(1).frame(1);
    const auto steady = [](Harness& each) {
        const std::size_t before = test::allocations_so_far();
        for (int i = 0; i < 50; ++i) each.frame();
        return test::allocations_so_far() - before;
    };
    EXPECT_EQ(steady(ui), 0U);
    EXPECT_EQ(ui.output().wake_at, never);
    EXPECT_FALSE(ui.output().changed);
}

TEST(Menu, OneThatIsTallerThanTheWindowScrollsToTheItemOfTheKeyboard) {
    bool start = true;
    int chosen = -1;
    Harness ui(
        [&](Ui& u) {
            if (std::exchange(start, false)) open_menu(u, "long", {.side = Placement::Side::pointer});
            Menu menu(u, "long", "Long");
            for (int i = 0; menu && i < 40; ++i) {
                if (menu_item(u, "Item " + std::to_string(i))) chosen = i;
            }
        },
        {300, 200});
    EXPECT_LE(ui.rect("Long").bottom(), 200);
    EXPECT_EQ(ui.key(Key::end).focused(), "Long/Item 39");
    ui.frame();
    EXPECT_LE(ui.rect("Long/Item 39").bottom(), 200);
    ui.key(Key::enter);
    EXPECT_EQ(chosen, 39);
}

TEST_F(MenuTest, F10OpensTheFirstMenuAndClosesIt) {
    ui.focus("Field").key(Key::f10).frame();
    EXPECT_TRUE(ui.is("File/Open", Is::ringed)) << ui.focused();
    ui.key(Key::f10).frame();
    EXPECT_FALSE(ui.exists("File/Open"));
    EXPECT_EQ(ui.focused(), "Field");
    ui.key(Key::escape).key(Key::f10).frame();
    EXPECT_TRUE(ui.is("File/Open", Is::ringed)) << "also if nothing had the keyboard";
    ui.key(Key::enter);
    EXPECT_EQ(chosen, "Open;");
    EXPECT_FALSE(ui.exists("File/Open"));
}

TEST_F(MenuTest, AltAndALetterOpenAMenu) {
    ui.key('V', Mods::alt).frame();
    EXPECT_TRUE(ui.is("View/Grid", Is::ringed)) << ui.focused();
    ui.key('F', Mods::alt).frame();
    EXPECT_FALSE(ui.exists("View/Grid"));
    EXPECT_TRUE(ui.is("File/Open", Is::ringed)) << ui.focused();
    ui.key(Key::escape).key('X', Mods::alt).frame();
    EXPECT_EQ(ui.ui().overlay_count(), 0U) << "no menu has this letter";
}

TEST(Menu, TheFirstFreeLetterOfATitleOpensIt) {
    Harness ui([](Ui& u) {
        MenuBar bar(u);
        for (const char* name : {"Preset", "Play"})
            if (BarMenu menu(u, name); menu) menu_item(u, u.join({"In ", name}));
    });
    ui.key('P', Mods::alt).frame();
    EXPECT_TRUE(ui.exists("Preset/In Preset"));
    ui.key('L', Mods::alt).frame();
    EXPECT_TRUE(ui.exists("Play/In Play"));
}

TEST(Menu, ADialogKeepsItsKeysFromTheBar) {
    Harness ui([](Ui& u) {
        {
            MenuBar bar(u);
            if (BarMenu menu(u, "File"); menu) menu_item(u, "Open");
        }
        if (!u.overlay_open("box")) u.open_overlay("box", OverlayKind::modal, {});
        if (u.open_overlay_node("box", Role::dialog, "Box", Axis::y) != nullptr) {
            button(u, "Done");
            u.close_overlay_node();
        }
    });
    ui.frame().key('F', Mods::alt).key(Key::f10).frame();
    EXPECT_FALSE(ui.exists("File/Open"));
}

}  // namespace
}  // namespace lapfx::ui
