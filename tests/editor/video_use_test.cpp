// What becomes of videos that are dropped or named: smoke is added to the clips, a surgery is the reference, and what
// is neither for certain is asked about. Nothing is taken out of a preset.
#include <gmock/gmock.h>

#include <fstream>

#include "app/reference/reference.h"
#include "editor/support/document_fixture.h"
#include "support/clips.h"
#include "support/folders.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* view = "Workspace/View/Preview";

class VideoUseTest : public EditorDocument {
  protected:
    void SetUp() override {
        EditorDocument::SetUp();
        if (IsSkipped()) return;
        const Preset preset = editor().document.preset();
        preset_file = folder() / "own.json";
        save_preset(preset, preset_file);
        open({preset_file.string()});
        before = names();
        ASSERT_EQ(before.size(), 3U);
    }
    void drop(const std::string& path, const std::vector<fs::path>& files) {
        std::string lines;
        for (const fs::path& file : files) lines += (lines.empty() ? "" : "\n") + file.string();
        ui().drop(path, lines).frame().frame();
    }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const SmokeClip& clip : editor().document.preset().smoke.clips) all.push_back(clip.file);
        return all;
    }
    std::string named() { return editor().document.scene().reference.file; }
    bool asks() { return editor().files().question() != nullptr; }
    const std::string& standard() {
        for (const app::Files::Answer& answer : editor().files().question()->answers)
            if (answer.standard) return answer.label;
        return editor().files().question()->title;
    }
    void preset_is_as_it_was() {
        EXPECT_EQ(names(), before);
        EXPECT_EQ(editor().document.preset_file(), preset_file);
        EXPECT_FALSE(editor().document.preset_unsaved());
    }
    /// The clips are those of before and these.
    void expect_added(const std::vector<std::string>& more) {
        std::vector<std::string> all = before;
        all.insert(all.end(), more.begin(), more.end());
        EXPECT_EQ(names(), all);
        EXPECT_EQ(editor().document.preset_file(), preset_file);
        EXPECT_EQ(editor().document.preset_unsaved(), !more.empty());
    }
    fs::path preset_file;
    std::vector<std::string> before;
};

TEST_F(VideoUseTest, ASurgeryIsTheReferenceAndThePresetStays) {
    const fs::path video = write_surgery(folder() / "op.avi");
    drop(view, {video});
    EXPECT_FALSE(asks());
    EXPECT_EQ(named(), fs::canonical(video).string());
    preset_is_as_it_was();
    EXPECT_TRUE(editor().document.scene_unsaved());
    EXPECT_THAT(ui().dump(), HasSubstr("op.avi becomes the reference: tissue fills the picture"));
    ui().key('Z', ui::Mods::command).frame().frame();
    EXPECT_EQ(named(), "reference/operation.mp4");
}

TEST_F(VideoUseTest, SmokeIsAddedToTheClipsAndQuittingAsks) {
    drop(view, {write_smoke(folder() / "puff.avi")});
    EXPECT_FALSE(asks());
    expect_added({"puff.avi"});
    EXPECT_EQ(named(), "reference/operation.mp4");
    EXPECT_THAT(ui().dump(), HasSubstr("puff.avi becomes a smoke clip"));
    editor().files().close();
    EXPECT_TRUE(asked("Save changes"));
    say("Cancel");
    ui().key('Z', ui::Mods::command).frame();
    preset_is_as_it_was();
}

TEST_F(VideoUseTest, FilesNamedAtTheStartAreUsedTheSameWay) {
    const fs::path video = write_surgery(folder() / "op.avi"), smoke = write_smoke(folder() / "puff.avi");
    open({preset_file.string(), video.string(), smoke.string()});
    EXPECT_FALSE(asks());
    expect_added({"puff.avi"});
    EXPECT_EQ(named(), fs::canonical(video).string());
}

TEST_F(VideoUseTest, TheNoticesButtonMakesASmokeClipOfTheReference) {
    drop(view, {write_surgery(folder() / "op.avi")});
    ui().click("**/Use it as a smoke clip instead").frame().frame();
    EXPECT_EQ(named(), "reference/operation.mp4") << "the former one is back";
    expect_added({"op.avi"});
    while (editor().document.can_undo()) editor().document.undo();
    ui().frame();
    EXPECT_EQ(names(), before);
    EXPECT_EQ(named(), "reference/operation.mp4");
}

TEST_F(VideoUseTest, TheNoticesButtonMakesTheReferenceOfASmokeClip) {
    const fs::path smoke = write_smoke(folder() / "puff.avi");
    drop(view, {smoke});
    ui().click("**/Make it the reference").frame().frame();
    EXPECT_EQ(named(), fs::canonical(smoke).string());
    preset_is_as_it_was();
}

TEST_F(VideoUseTest, WhatIsNotSureIsAskedWithTheLikelierChosen) {
    const fs::path haze = shipped() / "samples/clips/haze_rolling.mp4";
    drop(view, {haze});
    ASSERT_TRUE(asked("What is \"haze_rolling.mp4\"?"));
    EXPECT_EQ(standard(), "Smoke clip");
    EXPECT_THAT(ui().dump(), HasSubstr("it is grey like haze"));
    say("Cancel");
    ui().frame();
    preset_is_as_it_was();
    EXPECT_EQ(named(), "reference/operation.mp4");
    drop(view, {haze});
    ui().key(ui::Key::enter).frame().frame();
    expect_added({"haze_rolling.mp4"});
}

TEST_F(VideoUseTest, OfSeveralOnlyThoseThatAreNotSureAreAsked) {
    const fs::path smoke = write_smoke(folder() / "puff.avi"), flat = write_clip(folder() / "flat.avi", 10);
    drop(view, {smoke, flat});
    ASSERT_TRUE(asked("What is \"flat.avi\"?"));
    ui().click("What is \"flat.avi\"?/Reference").frame().frame();
    expect_added({"puff.avi"});
    EXPECT_EQ(named(), fs::canonical(flat).string());
}

TEST_F(VideoUseTest, APanelMeansItUnlessThePicturesContradict) {
    const fs::path smoke = write_smoke(folder() / "puff.avi"), video = write_surgery(folder() / "op.avi");
    layout("Key");
    const std::string clips = "Workspace/Clips/List";
    ASSERT_TRUE(ui().exists(clips));
    drop(clips, {video});
    ASSERT_TRUE(asked("What is \"op.avi\"?"));
    EXPECT_EQ(standard(), "Reference");
    say("Smoke clip");
    ui().frame();
    expect_added({"op.avi"});
    ui().key('Z', ui::Mods::command).frame();
    drop(clips, {write_clip(folder() / "flat.avi", 10)});
    EXPECT_FALSE(asks()) << "it may be smoke";
    expect_added({"flat.avi"});
    ui().key('Z', ui::Mods::command).frame();

    layout("Compare");
    const std::string reference = "Workspace/Reference";
    drop(reference, {smoke});
    ASSERT_TRUE(asked("What is \"puff.avi\"?"));
    EXPECT_EQ(standard(), "Smoke clip");
    ui().click("What is \"puff.avi\"?/Reference").frame().frame();
    EXPECT_EQ(named(), fs::canonical(smoke).string());
    drop(reference, {video});
    EXPECT_FALSE(asks());
    EXPECT_EQ(named(), fs::canonical(video).string());
    preset_is_as_it_was();
}

TEST_F(VideoUseTest, TheReferenceNamedAgainKeepsItsOffset) {
    const fs::path video = editor().document.scene().folder / named();
    const double offset = editor().document.scene().reference.offset;
    ASSERT_NE(offset, 0.0);
    drop(view, {video});
    EXPECT_FALSE(asks());
    EXPECT_EQ(editor().document.scene().reference.offset, offset);
    EXPECT_FALSE(editor().document.unsaved());
    EXPECT_THAT(ui().dump(), HasSubstr("operation.mp4 is the reference already"));
}

TEST_F(VideoUseTest, AQuestionWaitsForTheOneThatIsOpen) {
    set_speed(7);
    editor().files().open({(shipped() / "samples/lagb.scene.json").string()});
    ASSERT_TRUE(asked("Save changes"));
    editor().files().bring_videos({(shipped() / "samples/clips/haze_rolling.mp4").string()});
    ui().frame().frame();
    EXPECT_TRUE(asked("Save changes"));
    say("Discard");
    EXPECT_TRUE(asked("What is \"haze_rolling.mp4\"?"));
}

TEST_F(VideoUseTest, WhatCannotBeReadIsTold) {
    std::ofstream(folder() / "broken.mp4") << std::string(2000, '\0');
    drop(view, {folder() / "broken.mp4"});
    EXPECT_FALSE(asks());
    preset_is_as_it_was();
    EXPECT_THAT(ui().dump(), HasSubstr("broken.mp4: is not a video that can be decoded"));
}

}  // namespace
}  // namespace lapfx::test
