// What is kept when the editor ends: settings, and work that was not saved.
#include <gmock/gmock.h>

#include <fstream>

#include "app/base/layouts.h"
#include "app/base/saved.h"
#include "app/base/settings.h"
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/tuning/snapshots.h"
#include "app/tuning/tuning.h"
#include "editor/support/document_fixture.h"
#include "lapfx/authoring/file.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using ui::Key;
using ui::key_of;
using ui::Mods;

TEST_F(EditorDocument, SettingsOutliveTheEditor) {
    editor().settings().light = true;
    editor().settings().favourites = {"bleeding.speed"};
    layout("Key");
    editor().layouts().shown.show("History");
    ASSERT_TRUE(editor().layouts().keep("mine"));
    editor().commands.bind(editor().commands.index_of("edit.history"), {key_of('J'), Mods::command});
    ui().frame().frame(2).frame(2);
    start();
    EXPECT_TRUE(editor().settings().light);
    EXPECT_EQ(editor().settings().favourites, std::vector<std::string>{"bleeding.speed"});
    EXPECT_EQ(editor().layouts().name(), "mine");
    EXPECT_THAT(editor().layouts().names(), testing::Contains("mine"));
    EXPECT_EQ(editor().commands.chord_text(editor().commands.index_of("edit.history")), "Ctrl+J");
    EXPECT_EQ(editor().toasts.size(), 0U);
}

TEST_F(EditorDocument, BrokenSettingsArePutAsideAndUnknownOnesKept) {
    const fs::path file = folder() / "config" / "settings.json";
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "{\"light\": true";
    start();
    EXPECT_FALSE(editor().settings().light);
    EXPECT_EQ(editor().toasts.size(), 1U);
    EXPECT_TRUE(fs::exists(folder() / "config" / "settings.broken.json"));
    EXPECT_FALSE(fs::exists(file));
    std::ofstream(file) << R"({"light": true, "scale": "big", "of_tomorrow": 5})";
    start();
    EXPECT_TRUE(editor().settings().light);
    EXPECT_EQ(editor().settings().scale, 0);
    EXPECT_EQ(editor().toasts.size(), 1U);
    editor().settings().light = false;
    ui().frame().frame(2).frame(2);
    EXPECT_THAT(read_file(file, 1 << 20), HasSubstr("of_tomorrow"));
}

TEST_F(EditorDocument, ALayoutOfAnEarlierVersionKeepsThePanelThatHasAnotherNameNow) {
    const fs::path file = folder() / "config" / "settings.json";
    fs::create_directories(file.parent_path());
    std::ofstream(file) << R"({"layout": "Mine", "layouts": {"version": 1, "layouts": [{"name": "Mine",
        "root": {"split": "x", "fraction": 0.7, "first": {"tabs": ["View"]},
                 "second": {"tabs": ["Scene", "Presets", "History"], "active": 1}}}]}})";
    start();
    EXPECT_EQ(editor().layouts().name(), "Mine");
    EXPECT_TRUE(editor().layouts().seen("Library")) << "not in the first group, behind the view";
    EXPECT_NE(editor().layouts().shown.find("Library"), editor().layouts().shown.find("View"));
    EXPECT_EQ(editor().layouts().shown.find("Library"), editor().layouts().shown.find("Scene"));
    EXPECT_EQ(editor().toasts.size(), 0U);
}

TEST_F(EditorDocument, SettingsThatCannotBeKeptAreToldOnce) {
    fs::remove_all(folder() / "config");
    std::ofstream(folder() / "config") << "a file";
    for (const std::size_t told : {1U, 0U, 0U}) {
        editor().toasts.clear();
        editor().settings().light = !editor().settings().light;
        ui().frame().frame(1.1).frame();
        EXPECT_EQ(editor().toasts.size(), told);
    }
}

TEST_F(EditorDocument, WorkIsKeptInAPauseAndFiveSecondsBehindAtMost) {
    own_preset();
    app::Autosave& autosave = editor().autosave();
    double now = 1000, kept = 0;
    for (; now < 1008 && kept == 0; now += 0.5) {
        editor().document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = 0.001 * now; });
        autosave.update(now);
        if (autosave.due() > 1e9) kept = now;
    }
    EXPECT_EQ(kept, 1000 + app::Autosave::wait) << "while changes go on";
    set_speed(7.5);
    autosave.update(now);
    EXPECT_EQ(autosave.due(), now + app::Autosave::pause) << "and again after the next one";
}

TEST_F(EditorDocument, TheWindowsPlaceOutlivesTheEditor) {
    const app::WindowPlace place{.area = {.at = {-40, 20}, .size = {1200, 700}}, .maximized = true};
    editor().settings().window = place;
    ui().frame().frame(2).frame(2);
    start();
    EXPECT_EQ(editor().settings().window, place);
    const fs::path file = folder() / "config" / "settings.json";
    for (const char* wrong : {R"({"window": 5})", R"({"window": {"x": 1, "y": 2, "width": 0, "height": 5}})",
                              R"({"window": {"x": 1, "y": 2, "width": 1e300, "height": 5}})"}) {
        std::ofstream(file) << wrong;
        start();
        EXPECT_FALSE(editor().settings().window) << wrong;
        EXPECT_EQ(editor().toasts.size(), 1U) << wrong;
    }
}

TEST_F(EditorDocument, UnsavedWorkOutlivesACrash) {
    own_preset();
    ui().key('A', Mods::shift).frame();
    set_speed(7.5);
    app::Autosave& autosave = editor().autosave();
    autosave.update(1000);
    EXPECT_EQ(autosave.due(), 1000 + app::Autosave::pause);
    autosave.update(1001.5);
    EXPECT_FALSE(fs::exists(folder() / "state" / "autosave"));
    autosave.update(1000 + app::Autosave::pause);
    start();  // there was no end(), as after a crash
    editor().autosave().find();
    ui().frame().frame();
    ASSERT_EQ(editor().autosave().offers().size(), 1U);
    EXPECT_EQ(editor().autosave().offers()[0].unsaved, "preset");
    EXPECT_THAT(ui().dump(), HasSubstr("own.json"));
    EXPECT_GE(ui().rect("**/Unsaved work/Kept").w, ui().ui().text_width("2026-12-28 20:38") + ui().ui().em(1.5F))
        << "the whole time is read";
    say("Keep for later");
    EXPECT_TRUE(editor().autosave().offers().empty());
    editor().autosave().find();
    ui().frame().frame();
    say("Recover");
    EXPECT_EQ(speed(), 7.5);
    EXPECT_EQ(editor().document.preset_file(), folder() / "own.json");
    EXPECT_TRUE(editor().document.preset_unsaved());
    EXPECT_FALSE(editor().document.scene_unsaved());
    EXPECT_TRUE(editor().snapshots().at(0).has_value());
    ASSERT_FALSE(editor().document.steps().empty());
    EXPECT_EQ(editor().document.steps().back().name, "Recovered work") << "told when it would be lost";
    const double in_file = load_preset(folder() / "own.json").bleeding.speed;
    editor().document.undo();
    EXPECT_EQ(speed(), in_file) << "one step from what was saved";
    EXPECT_FALSE(editor().document.unsaved());
    editor().document.redo();
    EXPECT_EQ(speed(), 7.5);
    start();  // another crash; the work was never saved
    editor().autosave().find();
    ASSERT_EQ(editor().autosave().offers().size(), 1U);
    editor().files().recover(0);
    editor().autosave().update(2000);
    ui().frame().key('S', Mods::command).frame();
    editor().autosave().update(2001);
    EXPECT_EQ(load_preset(folder() / "own.json").bleeding.speed, 7.5);
    editor().autosave().end();
    start();
    editor().autosave().find();
    EXPECT_TRUE(editor().autosave().offers().empty());
}

TEST_F(EditorDocument, WhatIsSavedIsOfTheSceneThatIsOpen) {
    const auto saved_seed = [&] { return editor().saved().content().scene.seed; };
    document::Document& d = editor().document;
    document::Document::Recovered work;
    work.content = d.content();
    work.scene_in_file = d.scene();
    work.scene_unsaved = true;
    ASSERT_EQ(saved_seed(), d.scene().seed);
    work.content.scene.seed = d.scene().seed + 2;
    work.scene_in_file->seed = d.scene().seed + 1;
    const auto in_file = work.scene_in_file->seed;
    d.recover(work);
    EXPECT_EQ(saved_seed(), in_file) << "that of the recovered one, which is unsaved from the beginning";
    d.undo();
    EXPECT_EQ(saved_seed(), in_file);
    d.redo();
    d.forget_scene_file();
    ASSERT_NE(in_file, Scene{}.seed);
    EXPECT_EQ(saved_seed(), Scene{}.seed) << "without a file the defaults are what one goes back to";
}

TEST_F(EditorDocument, DiscardedWorkIsGoneAndAutosaveThatFailsIsToldOnce) {
    own_preset();
    set_speed(7.5);
    editor().autosave().update(1000);
    editor().toasts.tell(Error(Failure::runtime, Fault{"", "", "something went wrong"}));
    editor().autosave().update(1001);  // at once
    start();
    editor().autosave().find();
    ui().frame().frame();
    say("Discard");
    EXPECT_TRUE(editor().autosave().offers().empty());
    editor().autosave().find();
    EXPECT_TRUE(editor().autosave().offers().empty());
    fs::remove_all(folder() / "state");
    std::ofstream(folder() / "state") << "a file";
    open_sample();
    set_speed(8);
    for (double time = 3000; time < 3200; time += 10) {
        editor().autosave().update(time);
        editor().autosave().write_now();  // waits for the write that is on its way
    }
    EXPECT_EQ(editor().toasts.size(), 1U);
}

}  // namespace
}  // namespace lapfx::test
