// Finding a row of preset or scene with the command palette, also by everyday words: the row is shown and gets the
// keyboard.
#include "app/base/layouts.h"
#include "app/tuning/tuning.h"
#include "editor/support/editor_test.h"
#include "panels/table_rows.h"

namespace lapfx::test {
namespace {

using ui::Key;
using ui::Mods;

class FindTest : public SampleTest {
  protected:
    FindTest() { begins.view = false; }
    void find(const std::string& words) {
        ui().key('P', Mods::command).frame().type(words).key(Key::enter).frame().frame().settle();
    }
};

TEST_F(FindTest, ThePaletteGoesToAParameter) {
    ui().key('P', Mods::command).frame().type("sparks");
    EXPECT_EQ(ui().text("**/Commands/Fat particles: Rate"), "smoke.particles.rate");
    ui().key(Key::escape).frame();
    find("haze ventilation");
    EXPECT_TRUE(ui().focused().ends_with("Haze/Ventilation")) << ui().focused();
    const ui::Rect row = ui().rect("**/Parameters/Haze/Ventilation"), area = ui().rect("**/Preset/Parameters");
    EXPECT_GE(row.y, area.y) << "visible values";
    EXPECT_LE(row.bottom(), area.bottom());
    EXPECT_EQ(editor().tuning().current, app::parameters().find("smoke.haze.ventilation"));
    EXPECT_EQ(editor().document.done(), 0U);
}

TEST_F(FindTest, WhatNarrowsThePanelIsTakenBack) {
    editor().layouts().shown.close("Preset");
    editor().tuning().search = "gloss";
    editor().tuning().changed_only = true;
    ui().frame();
    find("luma high");
    EXPECT_TRUE(ui().focused().ends_with("Keying/Luma/High")) << ui().focused();
    EXPECT_EQ(editor().tuning().search, "");
    EXPECT_FALSE(editor().tuning().changed_only);
}

TEST_F(FindTest, ThePaletteGoesToARowOfTheScene) {
    find("fov");
    EXPECT_TRUE(ui().focused().ends_with("Camera/Field of view")) << ui().focused();
    ui().click("**/Scene rows/Camera/header");
    find("brightness exposure");
    EXPECT_TRUE(ui().focused().ends_with("Camera/Exposure")) << "its section is unfolded: " << ui().focused();
}

void titles(const Table& table, const std::string& name, std::vector<std::string>& into) {
    for (const Parameter& row : table.rows) into.push_back(name + ": " + std::string(row.name));
    for (const Table& child : table.tables) titles(child, std::string(child.name), into);
}

TEST_F(FindTest, WhatThePaletteListsOfTheSceneHasItsRow) {
    std::vector<std::string> all;
    titles(scene_table(), "Scene", all);
    int found = 0, measured = 0;
    for (const std::string& title : all) {
        ui().key('P', Mods::command).frame().type(title);
        const std::string item = "**/Commands/" + title;
        if (!ui().exists(item)) {
            ui().key(Key::escape).frame();
            continue;
        }
        ++found;
        ui().click(item).frame().frame().settle();
        EXPECT_EQ(ui().dump().find("is not shown yet"), std::string::npos) << title;
        const bool measure = ui().focused().find("/Measure settings/") != std::string::npos;
        EXPECT_TRUE(measure || ui().focused().find("/Scene rows/") != std::string::npos)
            << title << ": " << ui().focused();
        measured += measure ? 1 : 0;
        EXPECT_EQ(panels::wanted_row(ui().ui()), nullptr) << title;
    }
    EXPECT_EQ(measured, 11) << "times, blood and region, in the Measure panel";
    EXPECT_EQ(found, 58) << "rows of the scene, but files that commands load, and what is no row: events and curves";
}

TEST_F(FindTest, TheReferencesAspectIsARow) {
    find("squeezed video");
    EXPECT_TRUE(ui().focused().ends_with("Reference/Aspect")) << ui().focused();
    ui().type("1.78").key(Key::enter).frame();
    EXPECT_EQ(editor().document.scene().reference.aspect, 1.78);
    ASSERT_EQ(editor().document.done(), 1U);
    EXPECT_EQ(editor().document.steps().back().name, "Reference: Aspect");
}

TEST_F(FindTest, ARowThatIsNotThereIsTold) {
    editor().document.change("No tool", [](document::Content& c) { c.scene.tool.file.clear(); });
    find("trocar");
    EXPECT_NE(ui().dump().find("Port is not shown yet"), std::string::npos);
    EXPECT_EQ(panels::wanted_row(ui().ui()), nullptr);
}

TEST_F(FindTest, ThePanelsSearchKnowsEverydayWords) {
    ui().key('F', Mods::command).type("blood size");
    EXPECT_TRUE(ui().exists("**/Bleeding/Level extent"));
    EXPECT_FALSE(ui().exists("**/Bleeding/Gloss"));
}

TEST_F(FindTest, DownGoesFromThePanelsSearchToTheFirstRowFound) {
    ui().key('F', Mods::command).type("ventilation").key(Key::down).frame().settle();
    EXPECT_TRUE(ui().focused().ends_with("Haze/Ventilation")) << ui().focused();
    EXPECT_EQ(editor().tuning().search, "ventilation") << "the rows found stay";
    const double before = editor().document.preset().smoke.haze.ventilation;
    ui().key(Key::right).settle();
    EXPECT_NE(editor().document.preset().smoke.haze.ventilation, before) << "its keys work";
}

}  // namespace
}  // namespace lapfx::test
