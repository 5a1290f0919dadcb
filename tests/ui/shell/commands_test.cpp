#include "ui/shell/commands.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"
#include "ui/widgets/menu.h"

namespace lapfx::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Chord ctrl(char key) {
    return {key_of(key), Mods::command};
}

TEST(Chord, TextGoesBothWays) {
    const std::pair<Chord, const char*> cases[] = {
        {{key_of('S'), Mods::command | Mods::shift}, "Ctrl+Shift+S"},
        {{Key::page_down, Mods::alt}, "Alt+PageDown"},
        {{Key::f1, Mods::none}, "F1"},
        {{key_of('='), Mods::command}, "Ctrl+="},
        {{Key::space, Mods::command | Mods::alt | Mods::shift}, "Ctrl+Alt+Shift+Space"},
        {{key_of('7'), Mods::none}, "7"},
    };
    for (const auto& [chord, text] : cases) {
        EXPECT_EQ(text_of(chord), text);
        EXPECT_EQ(chord_from(text), chord);
    }
    EXPECT_EQ(chord_from("shift+CTRL+s"), chord_from("Ctrl+Shift+S"));
    EXPECT_EQ(text_of({}), "");
}

TEST(Chord, WhatIsNoneIsRefused) {
    for (const char* text : {"", "Ctrl+", "+", "Hyper+S", "Ctrl", "Ctrl+SS", "Ctrl+\xc3\xa9", "Ctrl++", "F13", " "})
        EXPECT_EQ(chord_from(text), std::nullopt) << text;
}

TEST(Chord, EveryKeyComesBack) {
    for (int key = 1; key < 320; ++key) {
        const std::string text = text_of({static_cast<Key>(key), Mods::alt});
        const auto chord = chord_from(text);
        if (chord) {
            EXPECT_EQ(static_cast<int>(chord->key), key) << text;
        }
    }
}

TEST(Chord, WhatMovesTheFocusCannotBeBound) {
    for (const char* text : {"Tab", "Ctrl+Tab", "Esc", "F6", "Enter", "Menu", "Shift+Enter"})
        EXPECT_FALSE(bindable(*chord_from(text))) << text;
    for (const char* text : {"J", "Ctrl+Enter", "Space", "Left", "F1", "Delete"})
        EXPECT_TRUE(bindable(*chord_from(text))) << text;
    EXPECT_FALSE(bindable({}));
}

class CommandsTest : public testing::Test {
  protected:
    CommandsTest() {
        table.add({.id = "file.open", .title = "Open", .group = "File", .chord = ctrl('O'), .run = [this] {
                       ran += "open;";
                   }});
        table.add({.id = "file.save",
                   .title = "Save",
                   .group = "File",
                   .chord = ctrl('S'),
                   .icon = Icon::file,
                   .run = [this] { ran += "save;"; },
                   .enabled = [this] { return can_save; }});
        table.add({.id = "view.grid",
                   .title = "Grid",
                   .group = "View",
                   .chord = {key_of('G'), Mods::none},
                   .run = [this] { grid = !grid; },
                   .checked = [this] { return grid; },
                   .tip = "Lines over the picture"});
        table.add({.id = "help", .title = "Help", .run = [this] { ran += "help;"; }});
    }
    CommandTable table;
    std::string ran;
    bool can_save = true, grid = false;
};

TEST_F(CommandsTest, AChordRunsItsCommand) {
    EXPECT_TRUE(table.press(key_of('S'), Mods::command));
    EXPECT_FALSE(table.press(key_of('S'), Mods::command | Mods::shift));
    EXPECT_FALSE(table.press(Key::none, Mods::none)) << "those without a chord are not run by no key";
    EXPECT_EQ(ran, "save;");
}

TEST_F(CommandsTest, WhatIsDisabledDoesNotRun) {
    can_save = false;
    std::string refused;
    table.on_refused = [&](const Command& command) { refused += command.id + ';'; };
    EXPECT_FALSE(table.press(key_of('S'), Mods::command));
    EXPECT_EQ(refused, "file.save;") << "a key says nothing by itself, so that it is told";
    EXPECT_FALSE(table.run("file.save"));
    EXPECT_EQ(refused, "file.save;");
    EXPECT_EQ(ran, "");
    EXPECT_TRUE(table.run("file.open"));
}

TEST_F(CommandsTest, MistakesOfTheProgramAreThrown) {
    const auto run = [] {};
    EXPECT_THROW(table.add({.id = "help", .title = "Again", .run = run}), std::invalid_argument);
    EXPECT_THROW(table.add({.id = "x", .title = "X", .chord = ctrl('S'), .run = run}), std::invalid_argument);
    EXPECT_THROW(table.add({.id = "x", .title = "X", .chord = {Key::tab, Mods::none}, .run = run}),
                 std::invalid_argument);
    EXPECT_THROW(table.add({.id = "x", .title = "", .run = run}), std::invalid_argument);
    EXPECT_THROW(table.add({.id = "x", .title = "X", .run = {}}), std::invalid_argument);
    EXPECT_THROW(table.index_of("x"), std::out_of_range);
    EXPECT_EQ(table.size(), 4U);
}

TEST_F(CommandsTest, ATakenChordIsReportedAndOnlyTakenWhenAskedFor) {
    const std::size_t open = table.index_of("file.open"), save = table.index_of("file.save");
    EXPECT_EQ(table.bind(open, ctrl('S')), save);
    EXPECT_EQ(table.chord(open), ctrl('O')) << "nothing changed";
    EXPECT_EQ(table.bind(open, ctrl('S'), true), save);
    EXPECT_EQ(table.chord_text(open), "Ctrl+S");
    EXPECT_EQ(table.chord_text(save), "");
    EXPECT_EQ(table.reset(save), open);
    EXPECT_EQ(table.bind(open, ctrl('S')), std::nullopt) << "its own";
    table.reset_all();
    EXPECT_FALSE(table.rebound(open) || table.rebound(save));
}

TEST_F(CommandsTest, ChangedBindingsGoThroughJson) {
    EXPECT_EQ(table.to_json(), "{}");
    const std::size_t open = table.index_of("file.open"), save = table.index_of("file.save");
    table.bind(open, ctrl('S'), true);
    table.bind(save, ctrl('O'));
    table.bind(table.index_of("view.grid"), {});
    const std::string text = table.to_json();
    table.reset_all();
    EXPECT_THAT(table.from_json(text), ElementsAre());
    EXPECT_EQ(table.chord(open), ctrl('S')) << "two have changed places";
    EXPECT_EQ(table.chord(save), ctrl('O'));
    EXPECT_EQ(table.chord_text(table.index_of("view.grid")), "");
    EXPECT_EQ(table.to_json(), text);
}

TEST_F(CommandsTest, FaultsInAFileAreToldAndTheRestIsTaken) {
    const auto faults = table.from_json(
        R"({"file.open": "Ctrl+G", "help": "Ctrl+G", "file.save": "Tab", "view.grid": 7, "new.thing": "F9"})");
    EXPECT_THAT(faults, ElementsAre(HasSubstr("file.save"), HasSubstr("view.grid"), HasSubstr("taken by File: Open")));
    EXPECT_EQ(table.chord_text(table.index_of("file.open")), "Ctrl+G");
    EXPECT_THAT(table.to_json(), HasSubstr("\"new.thing\": \"F9\"")) << "of a newer version: kept";
    EXPECT_THAT(table.from_json("{"), ElementsAre(HasSubstr("JSON")));
    EXPECT_EQ(table.chord_text(table.index_of("file.open")), "Ctrl+G") << "nothing changed";
}

TEST_F(CommandsTest, RecentOnesAreEachThereOnceTheNewestFirst) {
    for (const std::size_t i : {0, 1, 2, 0}) table.note_recent(i);
    EXPECT_THAT(table.recent(), ElementsAre(0, 2, 1));
}

TEST_F(CommandsTest, MenuItemsAndButtonsShowAndRunThem) {
    Harness ui(
        [&](Ui& u) {
            Row row(u);
            command_button(u, table, "file.save");
            command_button(u, table, "view.grid");
            if (button(u, "Menu")) open_menu(u, "m", {.side = Placement::Side::pointer});
            if (Menu menu(u, "m", "M"); menu) {
                command_item(u, table, "file.save");
                command_item(u, table, "view.grid");
            }
        },
        {640, 480}, 1, &table);
    EXPECT_EQ(ui.tip("Save"), "Save (Ctrl+S)");
    EXPECT_EQ(ui.tip("Grid"), "Lines over the picture (G)");
    ui.click("Save").click("Grid");
    EXPECT_EQ(ran, "save;");
    EXPECT_TRUE(grid);
    EXPECT_TRUE(ui.frame().is("Grid", Is::checked));
    can_save = false;
    ui.click("Save").key('S', Mods::command);
    EXPECT_EQ(ran, "save;");
    ui.key('G');
    EXPECT_FALSE(grid);
    ui.click("Menu");
    EXPECT_TRUE(ui.is("M/Save", Is::disabled));
    EXPECT_EQ(ui.text("M/Save"), "Ctrl+S");
    ui.click("M/Grid");
    EXPECT_TRUE(grid);
}

TEST(Commands, SpaceIsTheProgramsAfterAClickAndTheButtonsOnceItHasTheRing) {
    CommandTable table;
    int played = 0, clicked = 0;
    table.add(
        {.id = "play", .title = "Play", .group = "Play", .chord = {Key::space, Mods::none}, .run = [&] { ++played; }});
    Harness ui([&](Ui& u) { clicked += button(u, "Hold") ? 1 : 0; }, {400, 300}, 1, &table);
    ui.click("Hold").key(Key::space);
    EXPECT_EQ(clicked, 1) << "by the pointer alone";
    EXPECT_EQ(played, 1);
    ui.key(Key::enter);
    EXPECT_EQ(clicked, 2) << "Enter is always the button's";
    ui.key(Key::space);
    EXPECT_EQ(clicked, 3) << "the keyboard was used last, and the ring is seen";
    EXPECT_EQ(played, 1);
}

}  // namespace
}  // namespace lapfx::ui
