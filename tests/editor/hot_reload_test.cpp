#include "app/files/hot_reload.h"

#include <glad/gl.h>
#include <gmock/gmock.h>

#include <fstream>

#include "editor/support/editor_test.h"
#include "lapfx/authoring/documents.h"
#include "support/folders.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Opens a copy of the sample, which tests may change and delete.
class HotReloading : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        const fs::path samples = light_folder() / "samples";
        for (const char* name : {"lagb.glb", "hook_cautery.glb"}) fs::copy_file(samples / name, folder() / name);
        fs::copy_file(samples / "clips" / "plume_thick.mp4", folder() / "mine.mp4");
        Preset preset;
        preset.smoke.clips = {{.file = "mine.mp4"}};
        preset.vessels = load_preset(light_folder() / "presets" / "gastric_banding.json").vessels;
        save_preset(preset, folder() / "mine.json");
        Scene scene = load_scene(samples / "lagb.scene.json");
        scene.preset = "mine.json";
        save_scene(scene, folder() / "mine.scene.json");
        open({(folder() / "mine.scene.json").string()});
    }
    void change(const std::string& name) {
        editor().hot_reload().take({folder() / name});
        ui().frame().frame();
    }
    Preset on_disk() const { return load_preset(folder() / "mine.json"); }
};

TEST_F(HotReloading, APresetThatChangesOnDiskIsAnUndoStep) {
    Preset preset = on_disk();
    preset.bleeding.speed = 11;
    save_preset(preset, folder() / "mine.json");
    change("mine.json");
    EXPECT_EQ(editor().document.preset().bleeding.speed, 11.0);
    EXPECT_EQ(editor().document.steps().back().name, "Reload preset");
    EXPECT_FALSE(editor().document.preset_unsaved());
    editor().document.undo();
    EXPECT_NE(editor().document.preset().bleeding.speed, 11.0);
    EXPECT_TRUE(editor().document.preset_unsaved());
}

TEST_F(HotReloading, EditedWorkIsKeptUntilItIsGivenUp) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 7; });
    Preset preset = on_disk();
    preset.bleeding.speed = 11;
    save_preset(preset, folder() / "mine.json");
    change("mine.json");
    EXPECT_EQ(editor().document.preset().bleeding.speed, 7.0);
    ASSERT_EQ(editor().toasts.size(), 1U);
    ui().click("**/Reload");
    EXPECT_EQ(editor().document.preset().bleeding.speed, 11.0);
    EXPECT_EQ(editor().document.steps().size(), 2U);
}

TEST_F(HotReloading, WhatIsWrittenByTheEditorItselfIsNoNews) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 7; });
    editor().document.save_preset(folder() / "mine.json");
    const std::size_t steps = editor().document.steps().size();
    change("mine.json");
    EXPECT_EQ(editor().document.steps().size(), steps);
    EXPECT_EQ(editor().toasts.size(), 0U);
}

TEST_F(HotReloading, ABrokenPresetIsToldAndTheWorkStays) {
    std::ofstream(folder() / "mine.json") << "{ nonsense";
    const Preset before = editor().document.preset();
    change("mine.json");
    EXPECT_EQ(write_preset(editor().document.preset()), write_preset(before));
    EXPECT_EQ(editor().toasts.size(), 1U);
}

TEST_F(HotReloading, FilesThatVanishAreToldOnceAndThePictureStays) {
    const Image before = picture(6);
    for (const char* name : {"mine.json", "mine.mp4", "lagb.glb"}) {
        fs::rename(folder() / name, folder() / (std::string(name) + ".away"));
        change(name);
        change(name);
    }
    EXPECT_EQ(editor().toasts.size(), 3U);
    EXPECT_EQ(differing(before, picture(6), 0), 0U);
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 12; });
    EXPECT_GT(differing(before, picture(6)), 100U) << "parameters are live without the clip";
    EXPECT_EQ(editor().preview.preset_faults().size(), 1U) << "which is told where it belongs";
    fs::rename(folder() / "mine.mp4.away", folder() / "mine.mp4");
    change("mine.mp4");
    EXPECT_THAT(editor().preview.preset_faults(), IsEmpty());
}

TEST_F(HotReloading, AClipAndAnOrganThatChangeChangeThePicture) {
    const Image before = picture(3);
    fs::copy_file(light_folder() / "samples" / "clips" / "wisps_thin.mp4", folder() / "part");
    fs::rename(folder() / "part", folder() / "mine.mp4");
    change("mine.mp4");
    const Image other_clip = picture(3);
    EXPECT_GT(differing(before, other_clip, 2), 20U);
    fs::copy_file(light_folder() / "samples" / "liver_lobe.glb", folder() / "part");
    fs::rename(folder() / "part", folder() / "lagb.glb");
    change("lagb.glb");
    EXPECT_GT(differing(other_clip, picture(3)), 1000U);
    EXPECT_THAT(editor().preview.organ_faults(), IsEmpty());
    std::ofstream(folder() / "lagb.glb") << "glTF";
    const Image liver = picture(3);
    change("lagb.glb");
    EXPECT_EQ(editor().preview.organ_faults().size(), 1U);
    EXPECT_EQ(differing(liver, picture(3), 0), 0U) << "a broken one leaves the former on the screen";
}

TEST_F(HotReloading, TheWatchTellsByItself) {
    Preset preset = on_disk();
    preset.bleeding.speed = 11;
    save_preset(preset, folder() / "mine.json");
    EXPECT_TRUE(wait_until([&] { return editor().document.preset().bleeding.speed == 11.0; }, [&] { ui().frame(); }));
}

/// A preview that is not exact: files are shown when they have been loaded.
class PreviewLoading : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        const fs::path samples = light_folder() / "samples";
        content.scene = load_scene(samples / "lagb.scene.json");
        document.open(content);
        host.resize({160, 120});
    }
    bool turn(double time) {
        jobs.take();
        host.follow(document);
        shot.time = time;
        shot.camera = document.scene().camera;
        return host.draw(shot);
    }
    /// Draws until nothing is loading. Gives how often a picture was drawn.
    int settle(double time) {
        int drawn = 0;
        const auto draw = [&] { drawn += turn(time += 0.01) ? 1 : 0; };
        draw();
        EXPECT_TRUE(wait_until([&] { return !host.loading(); }, draw));
        turn(time);
        return drawn;
    }

    document::Content content;
    document::Document document;
    app::Jobs jobs;
    app::Shot shot;
    app::PreviewHost host{{.clip_folders = {light_folder() / "samples" / "clips"}}, jobs};
};

TEST_F(PreviewLoading, TheFormerOrganIsDrawnWhileTheNextOneLoads) {
    EXPECT_FALSE(turn(0));
    ASSERT_TRUE(host.loading());
    EXPECT_EQ(host.loading()->name, "lagb.glb");
    settle(0);
    ASSERT_TRUE(host.ready());
    EXPECT_GT(host.memory(), 1'000'000U);
    const std::string first = host.preview()->organ().name;
    document.change("Organ", [](document::Content& c) { c.scene.organ.file = "liver_lobe.glb"; });
    EXPECT_TRUE(turn(5)) << "time goes on with the former organ";
    EXPECT_EQ(host.preview()->organ().name, first);
    EXPECT_GT(settle(5), 0);
    EXPECT_EQ(host.preview()->organ().name, "liver_lobe");
    EXPECT_THAT(host.organ_faults(), IsEmpty());
}

TEST_F(PreviewLoading, TheNewestRequestCounts) {
    turn(0);
    document.change("Organ", [](document::Content& c) { c.scene.organ.file = "liver_lobe.glb"; });
    turn(0);
    document.change("Organ", [](document::Content& c) { c.scene.organ.file = "hook_cautery.glb"; });
    settle(0);
    EXPECT_EQ(host.preview()->organ().name, "hook_cautery");
}

TEST_F(PreviewLoading, AnOrganThatCannotBeShownYetIsShownOnceItCan) {
    document.change("Gravity", [](document::Content& c) { c.scene.gravity = glm::dvec3(0.0); });
    settle(0);
    EXPECT_FALSE(host.ready());
    ASSERT_EQ(host.organ_faults().size(), 1U);
    EXPECT_EQ(host.organ_faults()[0].place, "/gravity");
    EXPECT_EQ(host.organ_of(document.scene()), nullptr);
    document.undo();
    EXPECT_TRUE(turn(0)) << "without loading it once more";
    EXPECT_THAT(host.organ_faults(), IsEmpty());
    EXPECT_NE(host.organ_of(document.scene()), nullptr);
}

TEST_F(PreviewLoading, TheOrganIsHandedOutForItsSceneOnly) {
    settle(0);
    const auto organ = host.organ_of(document.scene());
    ASSERT_NE(organ, nullptr);
    EXPECT_EQ(&organ->organ(), &host.preview()->organ());
    const std::uint64_t version = host.organ_version();
    document.change("Organ", [](document::Content& c) { c.scene.organ.scale = 2; });
    EXPECT_EQ(host.organ_of(document.scene()), nullptr);
    settle(0);
    EXPECT_NE(host.organ_of(document.scene()), nullptr);
    EXPECT_NE(host.organ_of(document.scene()), organ);
    EXPECT_GT(host.organ_version(), version);
}

TEST_F(PreviewLoading, AnEarlyLoadOfAnotherSceneIsGivenUpWithoutWaiting) {
    const auto early = app::load_early(content.scene, content.preset, {});
    app::PreviewHost other({}, jobs, early);
    document.change("Organ", [](document::Content& c) { c.scene.organ.file = "liver_lobe.glb"; });
    other.follow(document);
    EXPECT_TRUE(early->stopped);
    jobs.finish();
    other.follow(document);
    EXPECT_EQ(other.preview()->organ().name, "liver_lobe");
}

TEST_F(PreviewLoading, CancelKeepsWhatWasThereAndSaysSo) {
    settle(0);
    document.change("Organ", [](document::Content& c) { c.scene.organ.file = "liver_lobe.glb"; });
    turn(0);
    ASSERT_TRUE(host.loading());
    host.cancel_loading();
    EXPECT_FALSE(host.loading());
    EXPECT_EQ(host.organ_faults().size(), 1U);
    settle(0);
    EXPECT_EQ(host.preview()->organ().name, "lagb");
    host.reload_organ();
    settle(0);
    EXPECT_EQ(host.preview()->organ().name, "liver_lobe");
}

TEST_F(PreviewLoading, ClipsOpenBesideTheUi) {
    settle(0);
    document.change("Clip", [](document::Content& c) { c.preset.smoke.clips = {{.file = "plume_thick.mp4"}}; });
    turn(0);
    ASSERT_TRUE(host.loading());
    EXPECT_TRUE(host.preview()->clips().empty()) << "the former ones play until they are there";
    settle(0);
    ASSERT_EQ(host.preview()->clips().size(), 1U);
    EXPECT_THAT(host.preview()->clips()[0].file, testing::EndsWith("plume_thick.mp4"));
}

TEST_F(PreviewLoading, ADriversFaultIsToldOnce) {
    settle(0);
    EXPECT_FALSE(host.check_driver(10).has_value());
    ASSERT_TRUE(turn(1));
    glEnable(0xffff);
    EXPECT_FALSE(host.check_driver(10.5).has_value()) << "at most once a second";
    const auto fault = host.check_driver(11.5);
    ASSERT_TRUE(fault.has_value());
    EXPECT_THAT(fault->reason, testing::HasSubstr("1280"));
    ASSERT_TRUE(turn(2));
    glEnable(0xffff);
    EXPECT_FALSE(host.check_driver(13).has_value());
    EXPECT_FALSE(host.lost());
}

TEST_F(HotReloading, ReadingAllAgainTellsOfNoFileThatHasNotChanged) {
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 7; });
    editor().document.change("Gravity", [](document::Content& c) { c.scene.gravity = glm::dvec3(0.0); });
    editor().toasts.clear();
    editor().hot_reload().reload_all();
    ui().frame();
    EXPECT_EQ(editor().toasts.size(), 0U) << "what is not saved here differs from the disk, which has not changed";
    EXPECT_EQ(editor().document.preset().bleeding.speed, 7);
}

}  // namespace
}  // namespace lapfx::test
