// Tests of the whole window: it comes to rest, its commands have different names, and nothing of one document remains
// in the next.
#include <sys/stat.h>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/browser/browser.h"
#include "app/clips/keying_bench.h"
#include "app/files/hot_reload.h"
#include "app/files/open.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshots.h"
#include "editor/support/editor_test.h"
#include "lapfx/authoring/documents.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

class RestTest : public EditorTest {
  protected:
    /// Expects that no frame is asked for within a minute, and that a frame made anyway draws nothing new.
    void expect_rest(const std::string& where) {
        ui().settle().frame(2).frame(2).settle();  // settings are written a moment after a change
        ASSERT_FALSE(editor().wants_frame()) << where;
        EXPECT_GT(ui().output().wake_at, ui().time + 60)
            << where << ": " << (ui().ui().wake_reasons().empty() ? "" : ui().ui().wake_reasons().back().reason);
        ui().frame(1);
        EXPECT_FALSE(ui().output().changed) << where;
        EXPECT_EQ(ui().ui().duplicates(), 0U) << where;
    }
    void expect_rest_everywhere(const std::string& what) {
        for (const char* name : {"Tune", "Key", "Compare", "Stage"}) {
            layout(name);
            expect_rest(what + ", layout " + name);
        }
        for (const auto& panel : editor().layouts().panels()) {
            editor().layouts().shown.show(panel);
            ui().frame();
            expect_rest(what + ", panel " + std::string(panel));
        }
    }
    fs::path another_preset() {
        Preset preset;
        preset.name = "Another";
        preset.vessels = editor().document.preset().vessels;
        preset.bleeding.speed = 2;
        save_preset(preset, folder() / "another.json");
        return folder() / "another.json";
    }
};

TEST_F(RestTest, EveryLayoutComesToRest) {
    open_sample();
    editor().timeline.speed = 0;
    expect_rest_everywhere("sample");
}

TEST_F(RestTest, AViewThatIsLeftWhileItIsCoarseIsNotWaitedFor) {
    int asked = 0;
    clock = [&] { return 0.5 * ++asked; };  // every picture of the scene takes half a second
    start({1440, 900}, false);
    open_sample();
    const auto settle = [&] {
        for (int i = 0; i < 3; ++i) {
            editor().jobs.finish();
            ui().frame(1).frame();
        }
    };
    settle();
    editor().timeline.speed = 0;
    layout("Compare");
    editor().reference().choose_sample();
    settle();
    layout("Tune");
    settle();
    editor().looking.endoscope = false;
    for (int i = 0; i < 120; ++i) {  // the first frames may still have all pixels
        editor().looking.camera.eye.x += 0.1;
        editor().touch(ui().time + 1.0 / 60);
        ui().frame();
    }
    ASSERT_LT(editor().whole_at(), 1e9) << "what is seen has fewer pixels";
    ASSERT_TRUE(editor().layouts().choose("Compare"));
    ui().frame(1).frame(1);
    ASSERT_FALSE(editor().layouts().seen("View"));
    EXPECT_GT(editor().whole_at(), 1e9) << "no frame is asked for because of it";
    layout("Tune");
    const Image whole = editor().preview.read();
    EXPECT_EQ(differing(whole, picture(editor().timeline.time), 0), 0U) << "and seen again it is whole";
}

TEST_F(RestTest, APipeIsNotWaitedFor) {
    const fs::path pipe = folder() / "smoke";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(app::kind_of(pipe), app::FileKind::video) << "and its reader says what it is";
    editor().clips().add({pipe.string()});
    ui().frame().frame();
    ASSERT_EQ(editor().clips().refused().size(), 1U);
    EXPECT_EQ(editor().clips().refused()[0].reason, "is not a plain file");
}

TEST_F(RestTest, AnEmptyEditorComesToRestToo) {
    editor().timeline.speed = 0;
    editor().keying().look.behind = app::Behind::preview;  // there is none
    ui().frame();
    expect_rest_everywhere("nothing open");
}

TEST_F(RestTest, CommandsSayWhatTheyDo) {
    const ui::CommandTable& commands = editor().commands;
    ASSERT_GT(commands.size(), 50U);
    for (std::size_t i = 0; i < commands.size(); ++i) EXPECT_FALSE(commands[i].tip.empty()) << commands[i].id;
}

TEST_F(RestTest, AnUntouchedEditorAsksNothing) {
    EXPECT_FALSE(editor().document.unsaved());
    open({another_preset().string()});
    EXPECT_EQ(editor().document.preset().name, "Another");
}

TEST_F(RestTest, APresetAloneLeavesTheViewAndTheEventsAlone) {
    open_sample();
    editor().looking.endoscope = false;
    editor().looking.camera.eye += glm::dvec3(10, 0, 0);
    editor().selected = {0};
    editor().clips().selected = 2;
    const glm::dvec3 eye = editor().looking.camera.eye;
    open({another_preset().string()});
    EXPECT_EQ(editor().document.preset().name, "Another");
    EXPECT_EQ(editor().looking.camera.eye, eye);
    EXPECT_EQ(editor().selected, std::vector<std::size_t>{0});
    EXPECT_EQ(editor().clips().selected, 0U);
}

TEST_F(RestTest, WhatWasBeforeASnapshotIsNotBroughtIntoAnotherDocument) {
    open_sample();
    Preset other = load_preset(another_preset());
    editor().document.change("Values", [&](document::Content& c) { c.preset.bleeding.speed = 2; });
    editor().snapshots().keep(0);
    editor().document.undo();
    editor().snapshots().show(0);
    ASSERT_TRUE(editor().snapshots().shown(0));
    editor().document.undo();
    editor().snapshots().show(0);
    const std::string shown = write_preset(editor().document.preset());
    save_preset(editor().document.preset(), folder() / "same.json");
    editor().document.note_disk();
    editor().document.undo();
    open({(folder() / "same.json").string()});
    ASSERT_TRUE(editor().snapshots().shown(0));
    editor().snapshots().show(0);
    EXPECT_EQ(write_preset(editor().document.preset()), shown) << "there was nothing before it here";
}

TEST_F(RestTest, AnOldNoticeDoesNotReloadIntoAnotherDocument) {
    open({another_preset().string()});
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 7; });
    Preset changed = load_preset(another_preset());
    changed.bleeding.speed = 11;
    save_preset(changed, folder() / "another.json");
    editor().hot_reload().take({folder() / "another.json"});
    ui().frame().frame();
    ASSERT_TRUE(ui().exists("**/Reload"));
    Preset third;
    third.name = "Third";
    save_preset(third, folder() / "third.json");
    editor().document.open_preset(load_preset(folder() / "third.json"), folder() / "third.json");
    ui().frame();
    ui().click("**/Reload").frame();
    EXPECT_EQ(editor().document.preset().name, "Third");
    EXPECT_NE(editor().document.preset().bleeding.speed, 11.0);
}

TEST_F(RestTest, WorkThatIsStoppedAmongTheJobsIsNotWaitedForEver) {
    open_sample();
    editor().browser().show();
    ui().frame();
    const std::shared_ptr<app::Job> job = editor().jobs.start(
        "Long", [](app::Job&) -> app::Jobs::Apply { return [] { FAIL() << "it was stopped"; }; }, {});
    job->cancel();
    ui().frame().settle();
    EXPECT_FALSE(editor().jobs.busy());
    EXPECT_TRUE(editor().jobs.running().empty());
}

TEST_F(RestTest, StarsAndFoldersOfPresetsAreKept) {
    editor().settings().preset_folders = {folder().string()};
    editor().settings().preset_stars = {another_preset().string()};
    editor().settings().write();
    start();
    EXPECT_EQ(editor().settings().preset_folders, std::vector<std::string>{folder().string()});
    EXPECT_EQ(editor().settings().preset_stars, std::vector<std::string>{(folder() / "another.json").string()});
}

}  // namespace
}  // namespace lapfx::test
