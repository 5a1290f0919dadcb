#include "document/document.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <random>

#include "lapfx/file.h"

namespace lapfx::document {
namespace {

namespace fs = std::filesystem;

class DocumentFiles : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "lapfx-document-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    void TearDown() override {
        std::error_code error;
        fs::permissions(folder_, fs::perms::owner_all, error);
        fs::remove_all(folder_, error);
    }
    fs::path in(const std::string& name) const { return folder_ / name; }

    fs::path folder_;
    Document document_;
};

/// Every edit, undo and redo in any order gives what a list of whole states gives.
TEST(DocumentHistory, FollowsAModel) {
    std::mt19937 random(7);
    Document document;
    std::vector<double> states{document.preset().bleeding.speed};
    std::size_t at = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto what = random() % 10;
        if (what < 4) {
            const double speed = static_cast<double>(random() % 500) / 10;
            const double before = states[at];
            document.change("Speed", [&](Content& c) { c.preset.bleeding.speed = speed; });
            if (speed != before) {
                states.resize(at + 1);
                states.push_back(speed);
                if (states.size() > Document::most_steps + 1) states.erase(states.begin());
                at = states.size() - 1;
            }
        } else if (what < 6) {
            document.undo();
            if (at > 0) --at;
        } else if (what < 8) {
            document.redo();
            if (at + 1 < states.size()) ++at;
        } else if (what == 8) {
            document.begin("Given up");
            document.edit([&](Content& c) { c.preset.bleeding.speed = 59; });
            document.cancel();
        } else {
            at = random() % states.size();
            document.go_to(at);
        }
        ASSERT_EQ(document.preset().bleeding.speed, states[at]) << "after " << i;
        ASSERT_EQ(document.done(), at);
        ASSERT_EQ(document.steps().size() + 1, states.size());
        ASSERT_EQ(document.can_undo(), at > 0);
    }
}

TEST_F(DocumentFiles, SavedIsSavedUntilItDiffers) {
    EXPECT_FALSE(document_.unsaved()) << "of an empty one nothing would be lost";
    document_.open({});
    EXPECT_FALSE(document_.unsaved());
    document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    EXPECT_TRUE(document_.preset_unsaved());
    EXPECT_FALSE(document_.scene_unsaved());
    document_.save_preset(in("a.json"));
    EXPECT_FALSE(document_.unsaved());
    EXPECT_EQ(load_preset(in("a.json")).bleeding.speed, 7);
    document_.undo();
    EXPECT_TRUE(document_.preset_unsaved());
    document_.redo();
    EXPECT_FALSE(document_.preset_unsaved());
}

TEST_F(DocumentFiles, UndoAfterSavingElsewhereStillFindsClips) {
    fs::create_directories(in("first/clips"));
    fs::create_directories(in("second"));
    std::ofstream(in("first/clips/a.mp4")) << "x";
    Content content;
    content.preset.smoke.clips = {{.file = "clips/a.mp4"}};
    content.preset.folder = in("first");
    document_.open(content, {}, in("first/p.json"));
    document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    document_.save_preset(in("p.json"));
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "first/clips/a.mp4");
    document_.undo();
    EXPECT_EQ(document_.preset().bleeding.speed, BleedingParameters{}.speed);
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "first/clips/a.mp4");
    EXPECT_EQ(document_.preset().folder, folder_);
    document_.redo();
    EXPECT_FALSE(document_.preset_unsaved());
    EXPECT_EQ(document_.clips_outside(in("second")), std::vector<std::string>{"first/clips/a.mp4"});
    EXPECT_THROW(document_.save_preset(in("second/p.json")), Error);
    EXPECT_EQ(document_.preset_file(), in("p.json"));
    document_.set_clip_folders({in("first/clips")});
    document_.save_preset(in("second/p.json"));
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "a.mp4") << "found on the search path";
}

TEST_F(DocumentFiles, AFileThatCannotBeWrittenStaysAndSoDoesTheWork) {
    document_.open({});
    document_.save_preset(in("a.json"));
    const std::string old = read_file(in("a.json"), 1 << 20);
    document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    EXPECT_THROW(document_.save_preset(in("gone/a.json")), Error);
    fs::create_directory(in("b.json"));
    EXPECT_THROW(document_.save_preset(in("b.json")), Error);
    EXPECT_EQ(document_.preset_file(), in("a.json"));
    EXPECT_EQ(document_.preset().bleeding.speed, 7);
    EXPECT_TRUE(document_.preset_unsaved());
    EXPECT_EQ(read_file(in("a.json"), 1 << 20), old);
    // Values that contradict each other are refused before anything is written.
    document_.change("Luma", [](Content& c) { c.preset.smoke.keying.luma_low = 255; });
    EXPECT_THROW(document_.save_preset(in("a.json")), Error);
    EXPECT_EQ(read_file(in("a.json"), 1 << 20), old);
}

TEST_F(DocumentFiles, WhatWasReloadedIsKnownAndSaved) {
    Content content;
    content.scene.organ.file = "a.obj";
    document_.open(content);
    document_.save_preset(in("a.json"));
    document_.save_scene(in("a.scene.json"));
    Document other;
    other.open(content);
    other.change("Speed", [](Content& c) { c.preset.bleeding.speed = 9, c.scene.duration = 7; });
    other.save_preset(in("a.json"));
    other.save_scene(in("a.scene.json"));
    ASSERT_NE(OnDisk::of(in("a.json")), document_.preset_on_disk());
    document_.reload(load_preset(in("a.json")));
    document_.reload(load_scene(in("a.scene.json")));
    EXPECT_EQ(document_.preset().bleeding.speed, 9);
    EXPECT_FALSE(document_.unsaved());
    EXPECT_EQ(OnDisk::of(in("a.json")), document_.preset_on_disk()) << "saving does not ask";
    EXPECT_EQ(OnDisk::of(in("a.scene.json")), document_.scene_on_disk());
}

TEST_F(DocumentFiles, AnotherProgramsWritingIsSeen) {
    document_.open({});
    document_.save_preset(in("a.json"));
    EXPECT_EQ(OnDisk::of(in("a.json")), document_.preset_on_disk());
    std::ofstream(in("a.json"), std::ios::app) << '\n';
    EXPECT_NE(OnDisk::of(in("a.json")), document_.preset_on_disk());
    fs::remove(in("a.json"));
    EXPECT_FALSE(OnDisk::of(in("a.json")).exists);
}

TEST_F(DocumentFiles, ASceneNamesThePresetItWasSavedWith) {
    Content content;
    content.scene.organ.file = "organ.glb";
    document_.open(content);
    fs::create_directory(in("presets"));
    document_.save_preset(in("presets/p.json"));
    document_.save_scene(in("s.json"));
    EXPECT_EQ(load_scene(in("s.json")).preset, "presets/p.json");
    EXPECT_FALSE(document_.unsaved());
}

TEST_F(DocumentFiles, AnotherPresetLeavesTheSceneUnsaved) {
    document_.open({});
    document_.change("Seed", [](Content& c) { c.scene.seed = 5; });
    document_.open_preset({}, in("other.json"));
    EXPECT_TRUE(document_.scene_unsaved());
    EXPECT_FALSE(document_.preset_unsaved());
    EXPECT_EQ(document_.scene().seed, 5);
}

}  // namespace
}  // namespace lapfx::document
