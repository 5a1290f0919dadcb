#include "ui/shell/key_editor.h"

#include <gmock/gmock.h>

#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

class KeyEditorTest : public testing::Test {
  protected:
    KeyEditorTest() {
        const auto add = [&](const char* id, const char* group, const char* title, Chord chord) {
            table.add({.id = id, .title = title, .group = group, .chord = chord, .run = [this, id] { ran += id; }});
        };
        add("open", "File", "Open", {key_of('O'), Mods::command});
        add("save", "File", "Save", {key_of('S'), Mods::command});
        add("grid", "View", "Grid", {});
        table.add({.id = "keys", .title = "Keys", .chord = {Key::f1, Mods::none}, .run = [this] {
                       toggle_cheat_sheet(ui.ui());
                   }});
    }
    std::string keys(const char* title) { return ui.text(std::string("**/Keys of ") + title); }
    CommandTable table;
    std::string ran;
    int changes = 0;
    Harness ui{[this](Ui& u) {
                   {
                       Panel panel(u, "Settings");
                       changes += key_editor(u, table) ? 1 : 0;
                   }
                   cheat_sheet(u, table);
               },
               {640, 480},
               1,
               &table};
};

TEST_F(KeyEditorTest, AClickWaitsForAChordAndBindsIt) {
    ui.frame().click("**/Keys of View: Grid");
    EXPECT_TRUE(ui.is("**/Keys of View: Grid", Is::busy));
    ui.key('G', Mods::command | Mods::shift);
    EXPECT_EQ(keys("View: Grid"), "Ctrl+Shift+G");
    EXPECT_TRUE(ui.is("**/Keys of View: Grid", Is::changed));
    EXPECT_FALSE(ui.is("**/Keys of View: Grid", Is::busy));
    EXPECT_EQ(changes, 1);
    ui.key('G', Mods::command | Mods::shift);
    EXPECT_EQ(ran, "grid");
}

TEST_F(KeyEditorTest, WithTheKeyboardAloneAndPlainKeysToo) {
    ui.frame().focus("**/Keys of View: Grid").key(Key::enter).key('J');
    EXPECT_EQ(keys("View: Grid"), "J");
    ui.key(Key::enter).key(Key::left);
    EXPECT_EQ(keys("View: Grid"), "Left");
}

TEST_F(KeyEditorTest, WhileItWaitsNoCommandRuns) {
    ui.frame().click("**/Keys of View: Grid").key('S', Mods::command);
    EXPECT_EQ(ran, "");
}

TEST_F(KeyEditorTest, AConflictIsToldAndTheChordTakenOnlyWhenAskedFor) {
    ui.frame().click("**/Keys of View: Grid").key('S', Mods::command);
    EXPECT_TRUE(ui.exists("**/Ctrl+S belongs to File: Save"));
    EXPECT_EQ(keys("View: Grid"), "");
    ui.click("**/Leave it");
    EXPECT_FALSE(ui.exists("**/Ctrl+S belongs to File: Save"));
    ui.click("**/Keys of View: Grid").key('S', Mods::command).click("**/Give it to View: Grid");
    EXPECT_EQ(keys("View: Grid"), "Ctrl+S");
    EXPECT_EQ(keys("File: Save"), "");
    EXPECT_EQ(changes, 1);
}

TEST_F(KeyEditorTest, EscapeGivesUpAndWhatMovesTheFocusIsRefused) {
    ui.frame().click("**/Keys of File: Open").key(Key::escape);
    EXPECT_EQ(keys("File: Open"), "Ctrl+O");
    EXPECT_FALSE(ui.is("**/Keys of File: Open", Is::busy));
    EXPECT_THAT(ui.dump(), testing::Not(testing::HasSubstr("belongs to the whole program")));
    ui.click("**/Keys of File: Open").key(Key::tab);
    EXPECT_EQ(keys("File: Open"), "Ctrl+O");
    EXPECT_TRUE(ui.exists("**/Tab belongs to the whole program and cannot be changed"));
    ui.click("**/Keys of File: Open").click("**/Keys of File: Save").key('T', Mods::alt);
    EXPECT_EQ(keys("File: Open"), "Ctrl+O") << "only one waits";
    EXPECT_EQ(keys("File: Save"), "Alt+T");
}

TEST_F(KeyEditorTest, KeysAreTakenAwayAndBroughtBack) {
    ui.frame().click("**/No keys for File: Save");
    EXPECT_EQ(keys("File: Save"), "");
    EXPECT_TRUE(ui.is("**/No keys for File: Save", Is::disabled));
    ui.click("**/Standard keys for File: Save");
    EXPECT_EQ(keys("File: Save"), "Ctrl+S");
    ui.click("**/No keys for File: Save").click("**/No keys for File: Open").click("**/All to standard");
    EXPECT_EQ(keys("File: Open"), "Ctrl+O");
    EXPECT_EQ(changes, 5);
    EXPECT_EQ(table.to_json(), "{}");
}

TEST_F(KeyEditorTest, FindsByTitleAndByKeys) {
    ui.frame().click("**/Search commands").type("ctrl+s");
    EXPECT_TRUE(ui.exists("**/Keys of File: Save"));
    EXPECT_FALSE(ui.exists("**/Keys of File: Open"));
}

TEST_F(KeyEditorTest, TheSheetTellsAllThatHaveKeys) {
    ui.key(Key::f1);
    EXPECT_TRUE(ui.exists("**/All keys/File"));
    EXPECT_EQ(ui.text("**/All keys/Save"), "Ctrl+S");
    EXPECT_FALSE(ui.exists("**/All keys/Grid"));
    EXPECT_EQ(ui.text("**/All keys/Next panel"), "F6");
    EXPECT_LE(ui.rect("Keys").bottom(), 480);
    ui.key(Key::f1);
    EXPECT_FALSE(ui.exists("**/All keys/Save"));
    ui.key(Key::f1).key(Key::escape);
    EXPECT_FALSE(ui.exists("**/All keys/Save"));
}

TEST_F(KeyEditorTest, TheBarOfTheSheetLiesBesideItsColumns) {
    for (const glm::ivec2 size : {glm::ivec2(640, 160), glm::ivec2(1400, 110)}) {
        Harness small([this](Ui& u) { cheat_sheet(u, table); }, size, 1, nullptr);
        toggle_cheat_sheet(small.ui());
        small.frame().frame();
        const float bar = small.rect("**/vertical scroll bar").x;
        EXPECT_LT(bar, static_cast<float>(size.x));
        for (const char* const line : {"Save", "Next panel", "Cancel"}) {
            if (!small.exists(std::string("**/All keys/") + line)) continue;
            EXPECT_LE(small.rect(std::string("**/All keys/") + line).right(), bar) << line << " at " << size.x;
        }
    }
}

}  // namespace
}  // namespace lapfx::ui
