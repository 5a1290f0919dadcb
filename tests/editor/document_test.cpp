// Files, history, snapshots and autosave, through the whole editor.
#include <gmock/gmock.h>

#include <fstream>

#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/clips/keying_bench.h"
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshots.h"
#include "editor/support/document_fixture.h"
#include "editor/support/held_jobs.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "support/folders.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using ui::Key;
using ui::key_of;
using ui::Mods;

TEST_F(EditorDocument, TheHistoryOpensAtTheCurrentStep) {
    for (int i = 0; i < 60; ++i)
        editor().document.change("Step " + std::to_string(i),
                                 [&](document::Content& c) { c.preset.bleeding.speed = 1 + 0.1 * i; });
    for (int i = 0; i < 10; ++i) editor().document.undo();
    editor().layouts().shown.show("History");
    ui().frame().frame();
    ASSERT_TRUE(ui().exists("**/Steps/Step 49")) << ui().dump();
    const ui::Rect row = ui().rect("**/Steps/Step 49"), table = ui().rect("**/History/Steps");
    EXPECT_LE(row.bottom(), table.bottom() + 1);
    EXPECT_GE(row.y, table.y);
    editor().document.go_to(3);
    ui().frame().frame();
    ASSERT_TRUE(ui().exists("**/Steps/Step 2")) << "and follows";
    ui().wheel("**/History/Steps", {0, -5}).frame();
    ui().wheel("**/History/Steps", {0, -30}).frame();
    EXPECT_FALSE(ui().exists("**/Steps/Step 2")) << "one may look elsewhere meanwhile";
}

TEST_F(EditorDocument, TheHistoryIsWalkedByClickAndByKeys) {
    layout("Tune");
    ui().key('H', Mods::command).frame();
    set_speed(5);
    set_speed(8.3);
    EXPECT_THAT(ui().dump(), HasSubstr("5 to 8.3 mm/s"));
    EXPECT_THAT(ui().dump(), HasSubstr("As opened"));
    ui().click("**/Steps/As opened").frame();
    EXPECT_EQ(editor().document.done(), 0U);
    EXPECT_NE(speed(), 5);
    ui().key(Key::down).frame();
    EXPECT_EQ(editor().document.done(), 0U) << "arrows only look";
    ui().key(Key::enter).frame();
    EXPECT_EQ(editor().document.done(), 1U);
    EXPECT_EQ(speed(), 5);
    EXPECT_THAT(ui().dump(), HasSubstr("2 steps, 1 undone"));
}

TEST_F(EditorDocument, SavingWritesWhatIsShownAndSaysSo) {
    const fs::path file = own_preset();
    set_speed(7.5);
    EXPECT_THAT(editor().files().title(), testing::StartsWith("own.json* - "));
    ui().key('S', Mods::command).frame();
    EXPECT_EQ(load_preset(file).bleeding.speed, 7.5);
    EXPECT_FALSE(editor().document.preset_unsaved());
    EXPECT_THAT(editor().files().title(), testing::StartsWith("own.json - "));
    EXPECT_EQ(editor().settings().recent.front(), file.string());
}

TEST_F(EditorDocument, ShippedFilesAreNotWrittenOver) {
    const fs::path file = editor().document.preset_file();
    const std::string before = read_file(file, 1 << 20);
    set_speed(7.5);
    ui().key('S', Mods::command).frame();
    EXPECT_TRUE(ui().exists("Save preset as"));
    EXPECT_EQ(editor().chooser().dialog().folder(), folder()) << "the user's documents";
    ui().key(Key::escape).frame();
    EXPECT_EQ(read_file(file, 1 << 20), before);
    EXPECT_TRUE(editor().document.preset_unsaved());
    editor().document.change("Length", [](document::Content& c) { c.scene.duration = 9; });
    ui().frame().key('S', Mods::command | Mods::alt).frame();
    EXPECT_TRUE(ui().exists("Save scene as"));
    EXPECT_EQ(editor().chooser().dialog().folder(), folder());
}

TEST_F(EditorDocument, WhatSavingWillDoWithShippedFilesIsSaidBefore) {
    set_speed(7.5);
    editor().files().close();
    ASSERT_TRUE(asked("Save changes before closing?"));
    EXPECT_THAT(editor().files().question()->text, HasSubstr("\"gastric_banding.json\" came with lapfx and stays "
                                                             "unchanged: saving asks for a new name"));
    say("Save as...");
    EXPECT_TRUE(ui().exists("Save preset as"));
    ui().key(Key::escape).frame();
    EXPECT_FALSE(editor().files().closed());
    editor().document.change("Length", [](document::Content& c) { c.scene.duration = 9; });
    editor().files().close();
    ASSERT_TRUE(asked("Save changes before closing?"));
    EXPECT_THAT(editor().files().question()->text,
                HasSubstr("and \"lagb.scene.json\" came with lapfx and stay unchanged"));
    EXPECT_TRUE(ui().exists("**/Save all as..."));
    say("Cancel");
    EXPECT_FALSE(editor().files().closed());
}

TEST_F(EditorDocument, SavingBeginsInTheFolderOfTheLastTime) {
    fs::create_directory(folder() / "mine");
    set_speed(7.5);
    ui().key('S', Mods::command).frame();
    ui().key('A', Mods::command).type((folder() / "mine" / "a.json").string()).key(Key::enter).frame();
    ASSERT_TRUE(fs::exists(folder() / "mine" / "a.json"));
    ui().frame().frame(2).frame(2);
    start();
    open_sample();
    set_speed(8);
    ui().key('S', Mods::command).frame();
    EXPECT_EQ(editor().chooser().dialog().folder(), folder() / "mine") << "also of the last session";
    ui().key(Key::escape).frame();
    fs::remove_all(folder() / "mine");
    ui().key('S', Mods::command).frame();
    EXPECT_EQ(editor().chooser().dialog().folder(), folder()) << "it is gone";
}

TEST_F(EditorDocument, RecentFilesAreThoseThatWereOpened) {
    const auto& recent = editor().settings().recent;
    const fs::path own = own_preset(), broken = folder() / "broken.json", organ = folder() / "organ.obj";
    std::ofstream(broken) << "{";
    std::ofstream(organ) << "no organ";
    for (const fs::path& file : {broken, folder() / "none.json", organ}) {
        open({file.string()});
        EXPECT_THAT(recent, testing::ElementsAre(own.string())) << file;
        ui().key(Key::escape).frame();
    }
    const fs::path clip = source_folder() / "samples" / "clips" / "wisps_thin.mp4";
    const fs::path video = source_folder() / "samples" / "reference" / "operation.mp4";
    editor().clips().add({broken.string(), clip.string()});
    ui().frame().frame();
    EXPECT_THAT(recent, testing::ElementsAre(clip.string(), own.string()));
    editor().reference().choose(broken);
    ui().frame().frame();
    EXPECT_THAT(recent, testing::ElementsAre(clip.string(), own.string()));
    editor().reference().choose(video);
    ui().frame().frame();
    EXPECT_THAT(recent, testing::ElementsAre(video.string(), clip.string(), own.string()));
    fs::remove(own);
    open({own.string()});
    EXPECT_THAT(recent, testing::ElementsAre(video.string(), clip.string())) << "what is gone leaves the list";
}

TEST_F(EditorDocument, WhatIsGoneLeavesTheRecentFilesWhateverItWas) {
    const std::string gone = (folder() / "gone").string(), broken = (folder() / "broken").string();
    auto& recent = editor().settings().recent;
    for (const char* ending : {".json", ".obj", ".mp4"}) {
        std::ofstream(broken + ending) << "neither";
        recent.insert(recent.end(), {gone + ending, broken + ending});
    }
    open({gone + ".json"});
    EXPECT_THAT(recent, testing::Not(testing::Contains(gone + ".json")));
    for (const std::string& organ : {broken, gone}) {
        open({organ + ".obj"});
        ui().key(Key::escape).frame();
    }
    EXPECT_THAT(recent, testing::Not(testing::Contains(gone + ".obj")));
    editor().reference().choose(broken + ".mp4");
    ui().frame().frame();
    editor().reference().choose(gone + ".mp4");
    ui().frame().frame();
    EXPECT_THAT(recent, testing::ElementsAre(broken + ".json", broken + ".obj", broken + ".mp4"));
    recent.push_back(gone + ".mp4");
    editor().clips().add({broken + ".mp4", gone + ".mp4"});
    ui().frame().frame();
    EXPECT_EQ(editor().clips().refused().size(), 2U);
    EXPECT_THAT(recent, testing::ElementsAre(broken + ".json", broken + ".obj", broken + ".mp4"));
}

TEST_F(EditorDocument, SnapshotsTellWhenTheyAreOfAnotherFile) {
    layout("Tune");
    editor().layouts().shown.show("Snapshots");
    own_preset();
    ui().frame().click("**/Keep A").frame();
    EXPECT_EQ(editor().snapshots().other_file(0), "");
    EXPECT_THAT(ui().dump(), testing::Not(HasSubstr("own, of own.json")));
    own_preset("second.json");
    ui().frame();
    EXPECT_EQ(editor().snapshots().other_file(0), "own.json");
    EXPECT_THAT(ui().dump(), HasSubstr("own, of own.json"));
    set_speed(7.5);
    editor().autosave().update(1000);
    editor().autosave().update(1000 + app::Autosave::wait);
    start();
    editor().autosave().find();
    ASSERT_EQ(editor().autosave().offers().size(), 1U);
    editor().files().recover(0);
    EXPECT_EQ(editor().snapshots().other_file(0), "own.json") << "also after a crash";
}

TEST_F(EditorDocument, SnapshotsGoAlongWhenTheirPresetGetsAnotherName) {
    own_preset("other.json");
    editor().snapshots().keep(1);
    own_preset();
    editor().snapshots().keep(0);
    set_speed(7.5);
    editor().files().save_preset_as();
    ui().frame().frame();
    ui().key('A', Mods::command).type((folder() / "mine.json").string()).key(Key::enter).frame();
    ASSERT_EQ(editor().document.preset_file(), folder() / "mine.json") << ui().dump();
    EXPECT_EQ(editor().snapshots().other_file(0), "") << "it is of the same work";
    EXPECT_EQ(editor().snapshots().other_file(1), "other.json");
    own_preset("third.json");
    EXPECT_EQ(editor().snapshots().other_file(0), "mine.json");
}

TEST_F(EditorDocument, AFolderThatIsGoneIsTold) {
    fs::create_directory(folder() / "gone");
    own_preset("gone/own.json");
    set_speed(7.5);
    fs::remove_all(folder() / "gone");
    ui().key('S', Mods::command).frame();
    ASSERT_TRUE(asked("was not saved"));
    EXPECT_THAT(ui().dump(), HasSubstr("No such file or directory"));
    fs::create_directory(folder() / "gone");
    say("Try again");
    EXPECT_EQ(load_preset(folder() / "gone" / "own.json").bleeding.speed, 7.5);
}

TEST_F(EditorDocument, SavingOverAnotherProgramsWritingAsks) {
    const fs::path file = own_preset();
    set_speed(7.5);
    Preset other;
    other.vessels = editor().document.preset().vessels;
    other.bleeding.speed = 11;
    save_preset(other, file);
    ui().key('S', Mods::command).frame();
    ASSERT_TRUE(asked("has been changed by another program")) << ui().dump();
    say("Cancel");
    EXPECT_EQ(load_preset(file).bleeding.speed, 11);
    ui().key('S', Mods::command).frame();
    say("Overwrite");
    EXPECT_EQ(load_preset(file).bleeding.speed, 7.5);
    EXPECT_FALSE(editor().document.preset_unsaved());
}

TEST_F(EditorDocument, AFailedSaveKeepsTheWorkAndOffersAnotherName) {
    const fs::path file = own_preset();
    set_speed(7.5);
    fs::remove(file);
    fs::create_directory(file);  // a file cannot replace it, even for root
    ui().key('S', Mods::command).frame();
    ASSERT_TRUE(asked("was not saved"));
    EXPECT_EQ(speed(), 7.5);
    EXPECT_TRUE(editor().document.preset_unsaved());
    say("Save as...");
    ASSERT_TRUE(ui().exists("Save preset as")) << ui().dump();
    ui().key('A', Mods::command).type((folder() / "new.json").string()).key(Key::enter).frame();
    EXPECT_EQ(load_preset(folder() / "new.json").bleeding.speed, 7.5);
    EXPECT_EQ(editor().document.preset_file(), folder() / "new.json");
}

TEST_F(EditorDocument, ClosingAsksInWordsAndEachAnswerHolds) {
    editor().files().close();
    ui().frame();
    EXPECT_TRUE(editor().files().closed()) << "nothing is unsaved";
    start();
    open_sample();
    const fs::path file = own_preset();
    set_speed(7.5);
    editor().files().close();
    ASSERT_TRUE(asked("Save changes before closing?"));
    EXPECT_THAT(ui().dump(), HasSubstr("to 7.5 mm/s"));
    say("Cancel");
    EXPECT_FALSE(editor().files().closed());
    EXPECT_EQ(editor().files().question(), nullptr);
    editor().files().close();
    ui().frame().key(Key::escape).frame();
    EXPECT_FALSE(editor().files().closed());
    EXPECT_EQ(editor().files().question(), nullptr);
    editor().files().close();
    ui().frame();
    say("Save");
    EXPECT_TRUE(editor().files().closed());
    EXPECT_EQ(load_preset(file).bleeding.speed, 7.5);
}

TEST_F(EditorDocument, ClosingStaysWhenSavingFailsAndDiscardGoes) {
    const fs::path file = own_preset();
    set_speed(7.5);
    fs::remove(file);
    fs::create_directory(file);
    editor().files().close();
    ui().frame();
    say("Save");
    EXPECT_FALSE(editor().files().closed());
    ASSERT_TRUE(asked("was not saved"));
    say("Cancel");
    EXPECT_FALSE(editor().files().closed());
    editor().files().close();
    ui().frame();
    say("Discard");
    EXPECT_TRUE(editor().files().closed());
}

TEST_F(EditorDocument, OpeningOverUnsavedWorkAsks) {
    own_preset();
    set_speed(7.5);
    Preset other;
    other.vessels = editor().document.preset().vessels;
    other.bleeding.speed = 3;
    save_preset(other, folder() / "other.json");
    open({(folder() / "other.json").string()});
    EXPECT_EQ(speed(), 7.5);
    ASSERT_TRUE(asked("Save changes before opening"));
    say("Discard");
    EXPECT_EQ(speed(), 3);
    EXPECT_EQ(load_preset(folder() / "own.json").bleeding.speed, BleedingParameters{}.speed);
}

TEST_F(EditorDocument, ASecondEditorOnTheSameFileIsTold) {
    const fs::path file = own_preset();
    const fs::path state = folder() / "state";
    open({(source_folder() / "presets" / "slow_ooze.json").string()});
    const auto other = document::Lock::take(document::lock_file(state, file));
    ASSERT_TRUE(other.has_value()) << "leaving a file releases it";
    open({file.string()});
    ASSERT_TRUE(asked("Another editor has this file open"));
    EXPECT_NE(editor().document.preset_file(), file);
    say("Open a copy");
    EXPECT_TRUE(editor().document.preset_file().empty());
    EXPECT_EQ(editor().document.preset().name, "own");
    EXPECT_TRUE(editor().document.preset_unsaved());
}

TEST_F(EditorDocument, AFileThatIsOpenIsLocked) {
    const fs::path file = own_preset();
    const fs::path lock = document::lock_file(folder() / "state", file);
    EXPECT_FALSE(document::Lock::take(lock).has_value());
    start();
    EXPECT_TRUE(document::Lock::take(lock).has_value());
}

TEST_F(EditorDocument, NewBeginsWithTheDefaultsOnTheSampleOrgan) {
    editor().commands.run("file.new");
    ui().frame().frame();
    EXPECT_TRUE(editor().document.scene().events.empty());
    EXPECT_EQ(speed(), BleedingParameters{}.speed);
    EXPECT_TRUE(editor().document.preset_file().empty());
    EXPECT_TRUE(editor().preview.ready());
}

TEST_F(EditorDocument, SnapshotsAreKeptShownAndSwapped) {
    set_speed(5);
    ui().key('A', Mods::shift).frame();
    set_speed(9);
    ui().key('B', Mods::shift).frame();
    set_speed(12);
    const std::size_t steps = editor().document.steps().size();
    ui().key('A').frame();
    EXPECT_EQ(speed(), 5);
    EXPECT_EQ(editor().document.steps().size(), steps + 1);
    EXPECT_EQ(editor().document.steps().back().name, "Snapshot A");
    ui().key('B').frame();
    EXPECT_EQ(speed(), 9);
    ui().key('B').frame();
    EXPECT_EQ(speed(), 12) << "once more: what was tuned before any snapshot was shown";
    ui().key('C').frame();
    EXPECT_EQ(speed(), 12) << "an empty one changes nothing";
}

TEST_F(EditorDocument, SnapshotsAreComparedAndOneValueTaken) {
    layout("Tune");
    editor().layouts().shown.show("Snapshots");
    ui().frame();
    EXPECT_THAT(ui().dump(), HasSubstr("Snapshot A is empty"));
    ui().click("**/Keep A").frame();
    editor().document.change("Two", [](document::Content& c) {
        c.preset.bleeding.speed = 9.5;
        c.preset.bleeding.max_extent = 30;
    });
    ui().frame().frame();
    EXPECT_THAT(ui().dump(), HasSubstr("2 differences"));
    const double before = editor().snapshots().at(0)->preset.bleeding.speed;
    ui().click("**/Differences/Bleeding: Speed").frame();
    EXPECT_EQ(speed(), before);
    EXPECT_EQ(editor().document.preset().bleeding.max_extent, 30);
    EXPECT_EQ(editor().document.steps().back().name, "Speed of snapshot A");
    editor().document.undo();
    EXPECT_EQ(speed(), 9.5);
    ui().click("**/Clear A").frame();
    EXPECT_FALSE(editor().snapshots().at(0).has_value());
}

TEST_F(EditorDocument, WhatTheViewLoadsIsToldThereAlone) {
    start({1280, 800}, false);
    HeldJobs held(editor().jobs);
    open_sample();
    HeldJobs::keep_only(editor().jobs, "Loading lagb.glb");  // the status bar names the oldest of several
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(ui().frame().exists("Workspace/View/Loading/Loading lagb.glb")) << ui().dump();
        EXPECT_FALSE(ui().exists("Status bar/Loading lagb.glb"));
    }
    layout("Compare");  // which does not show the view
    EXPECT_TRUE(ui().exists("Status bar/Loading lagb.glb")) << ui().dump();
    layout("Tune");
    held.let_go();
    EXPECT_TRUE(wait_until([&] { return !editor().preview.loading(); }, [&] { ui().frame(); }));
    EXPECT_TRUE(editor().preview.ready());
    EXPECT_FALSE(ui().frame().exists("Workspace/View/Loading"));
}

TEST_F(EditorDocument, CtrlYRedoesAsWell) {
    set_speed(7.5);
    ui().key('Z', Mods::command).frame();
    ASSERT_NE(speed(), 7.5);
    ui().key('Y', Mods::command).frame();
    EXPECT_EQ(speed(), 7.5);
    ui().key('Z', Mods::command).frame();
    ui().key('Z', Mods::command | Mods::shift).frame();
    EXPECT_EQ(speed(), 7.5);
    ui().key('Z', Mods::command).frame();
    editor().commands.bind(editor().commands.index_of("view.vessels"), {key_of('Y'), Mods::command});
    ui().key('Y', Mods::command).frame();
    EXPECT_NE(speed(), 7.5) << "who binds it has it";
    EXPECT_EQ(editor().looking.overlay, Overlay::vessels);
}

TEST_F(EditorDocument, SavedAsItIsCalledAsItsFileUnlessItHasANameOfItsOwn) {
    const auto save_as = [&](const std::string& name) {
        editor().files().save_preset_as();
        ui().frame().frame();
        ui().click("Save preset as/Name").key('A', Mods::command).type(name).key(Key::enter).frame().frame();
        EXPECT_EQ(editor().document.preset_file(), folder() / name);
    };
    ASSERT_EQ(editor().document.preset().name, "Gastric banding");
    const double speed = editor().document.preset().bleeding.speed;
    set_speed(7.5);
    save_as("my_bleed.json");
    EXPECT_EQ(editor().document.preset().name, "My bleed");
    EXPECT_EQ(load_preset(folder() / "my_bleed.json").name, "My bleed");
    EXPECT_FALSE(editor().document.preset_unsaved());
    EXPECT_THAT(ui().text("Status bar/Preset"), testing::HasSubstr("My bleed"));
    EXPECT_EQ(editor().document.done(), 1U) << "being called so is no step";
    editor().document.undo();
    EXPECT_EQ(editor().document.preset().bleeding.speed, speed);
    EXPECT_EQ(editor().document.preset().name, "My bleed");
    editor().document.change("Name", [](document::Content& c) { c.preset.name = "Oozing"; });
    save_as("other.json");
    EXPECT_EQ(load_preset(folder() / "other.json").name, "Oozing") << "a name that was given stays";
}

TEST_F(EditorDocument, SavingAsReplacesNothingButAnotherOfItsKind) {
    const auto save_as = [&](bool scene, const std::string& name) {
        scene ? editor().files().save_scene_as() : editor().files().save_preset_as();
        ui().frame().frame();
        ui().click(std::string("Save ") + (scene ? "scene" : "preset") + " as/Name").key('A', Mods::command);
        ui().type(name).key(Key::enter).frame().frame();
        if (ui().exists("Replace the file?")) ui().click("Replace the file?/Replace").frame().frame();
    };
    std::ofstream(folder() / "o.glb") << "an organ";
    std::ofstream(folder() / "words.json") << "{}";
    editor().document.save_scene(folder() / "m.scene.json");
    editor().document.save_preset(folder() / "p.json");
    const auto text = [&](const char* name) { return read_file(folder() / name, 1 << 20); };
    const std::string scene = text("m.scene.json"), preset = text("p.json");
    for (const char* name : {"o.glb", "words.json", "m.scene.json"}) {
        save_as(false, name);
        ASSERT_TRUE(asked('"' + std::string(name) + "\" was not saved")) << ui().dump();
        say("Cancel");
    }
    save_as(true, "p.json");
    ASSERT_TRUE(asked("\"p.json\" was not saved")) << "nor \"is open in another editor\"";
    EXPECT_THAT(editor().files().question()->lines.at(0),
                HasSubstr("a file of this name is there and is not a scene; choose another name"));
    say("Cancel");
    EXPECT_EQ(text("o.glb"), "an organ");
    EXPECT_EQ(text("words.json"), "{}");
    EXPECT_EQ(text("m.scene.json"), scene);
    EXPECT_EQ(text("p.json"), preset);
    EXPECT_EQ(editor().document.preset_file(), folder() / "p.json");
    // Another preset may be replaced, once that was asked.
    Preset other;
    other.name = "Other";
    save_preset(other, folder() / "q.json");
    save_as(false, "q.json");
    EXPECT_EQ(editor().document.preset_file(), folder() / "q.json");
    EXPECT_NE(load_preset(folder() / "q.json").name, "Other");
}

TEST_F(EditorDocument, ANewDocumentIsCalledAsItsFirstFile) {
    editor().files().make_new();
    ui().frame().frame();
    ASSERT_EQ(editor().document.preset().name, "New preset");
    ASSERT_EQ(editor().document.scene().name, "New scene");
    editor().files().save_preset_as();
    ui().frame().frame();
    ui().click("Save preset as/Name").key('A', Mods::command).type("mine.json").key(Key::enter).frame().frame();
    EXPECT_EQ(load_preset(folder() / "mine.json").name, "Mine");
    editor().files().save_scene_as();
    ui().frame().frame();
    ui().click("Save scene as/Name").key('A', Mods::command).type("op.scene.json").key(Key::enter).frame().frame();
    EXPECT_EQ(load_scene(folder() / "op.scene.json").name, "Op");
}

TEST_F(EditorDocument, ANameThatWasTypedStaysWhateverItIs) {
    const auto save_as = [&](const std::string& name) {
        editor().files().save_preset_as();
        ui().frame().frame();
        ui().click("Save preset as/Name").key('A', Mods::command).type(name).key(Key::enter).frame().frame();
        return load_preset(folder() / name).name;
    };
    const auto call = [&](const std::string& name) {
        editor().document.change("Name", [&](document::Content& c) { c.preset.name = name; });
    };
    call("New preset");
    EXPECT_EQ(save_as("a.json"), "New preset");
    editor().files().make_new();
    ui().frame().frame();
    call("Oozing");
    call("New preset");
    EXPECT_EQ(save_as("b.json"), "New preset");
}

TEST_F(EditorDocument, ATextIsNoSmokeClip) {
    std::ofstream(folder() / "notes.txt") << "buy milk\n";
    editor().toasts.clear();
    editor().files().bring({(folder() / "notes.txt").string()});
    ui().frame();
    EXPECT_EQ(editor().files().question(), nullptr) << "neither a clip nor a reference";
    EXPECT_NE(ui().dump().find("notes.txt: is a text"), std::string::npos) << ui().dump();
}

}  // namespace
}  // namespace lapfx::test
