// The list of clips, driven by the names of the widgets on the screen.
#include <fstream>

#include "app/base/saved.h"
#include "app/clips/keying_bench.h"
#include "app/files/files.h"
#include "app/tuning/tuning.h"
#include "editor/support/editor_test.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/suggest.h"
#include "support/clips.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

/// A puff with a mark in a corner that never moves.
fs::path write_marked_smoke(const fs::path& path) {
    return write_seen(path, [](cv::Point2d at, int frame) -> cv::Vec3d {
        if (at.x >= 80 && at.x < 88 && at.y >= 8 && at.y < 16) return {255, 255, 255};
        const double away = cv::norm(at - cv::Point2d(40, 64 - 3 * frame)) / 14;
        return cv::Vec3d(200, 200, 200) * std::exp(-away * away);
    });
}

class ClipsPanel : public SampleTest {
  protected:
    ClipsPanel() { begins.layout = "Key"; }
    const std::vector<SmokeClip>& clips() { return editor().document.preset().smoke.clips; }
    const document::Step& last_step() { return editor().document.steps().at(editor().document.done() - 1); }
    std::vector<std::string> names() {
        std::vector<std::string> all;
        for (const SmokeClip& clip : clips()) all.push_back(clip.file);
        return all;
    }
    void drop(const std::string& files) { ui().drop(panel + "List", files).frame().frame(); }

    const std::string panel = "Workspace/Clips/";
    const std::vector<std::string> sample{"plume_thick.mp4", "wisps_thin.mp4", "haze_rolling.mp4"};
};

TEST_F(ClipsPanel, ListsThePresetsClips) {
    ASSERT_EQ(names(), sample);
    const std::string text = ui().text(panel + "List/1 plume_thick.mp4");
    EXPECT_NE(text.find("180x120, 5 s at 30 fps"), std::string::npos) << text;
    EXPECT_NE(text.find("graphics memory"), std::string::npos) << text;
    EXPECT_EQ(text.find("resident"), std::string::npos) << text;
    EXPECT_NE(editor().clips().of(0).thumbnail, 0U);
    ui().click(panel + "List/2 wisps_thin.mp4");
    EXPECT_EQ(editor().clips().selected, 1U);
    ui().key(ui::Key::down);
    EXPECT_EQ(editor().clips().selected, 2U);
}

TEST_F(ClipsPanel, WeightIsDraggedInTheListInOneStep) {
    ui().drag(panel + "List/1 plume_thick.mp4/Weight", {20, 0});
    EXPECT_NE(clips()[0].weight, 1.0);
    EXPECT_EQ(editor().document.done(), 1U);
    EXPECT_EQ(last_step().name, "Weight");
}

TEST_F(ClipsPanel, BackspaceInTheListGoesBackToTheSavedWeight) {
    const std::string row = panel + "List/1 plume_thick.mp4/Weight";
    const auto weigh = [&](double weight) {
        editor().document.change("Weight", [&](document::Content& c) { c.preset.smoke.clips[0].weight = weight; });
    };
    weigh(0.5);
    editor().document.save_preset(folder() / "mine.json");
    weigh(0.8);
    ui().frame();
    ui().move_to(row).key(ui::Key::backspace);
    EXPECT_EQ(clips()[0].weight, 0.5);
    ui().move_to(row).key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_EQ(clips()[0].weight, 1.0) << "with Shift the default";
}

TEST_F(ClipsPanel, OrderAndNumberAreChanged) {
    ui().click(panel + "Move clip down");
    EXPECT_EQ(names(), (std::vector<std::string>{sample[1], sample[0], sample[2]}));
    EXPECT_EQ(editor().clips().selected, 1U) << "the selection goes along";
    ui().click(panel + "Move clip up");
    EXPECT_EQ(names(), sample);
    ui().click(panel + "Duplicate clip");
    EXPECT_EQ(names(), (std::vector<std::string>{sample[0], sample[0], sample[1], sample[2]}));
    ui().click(panel + "Remove clip");
    EXPECT_EQ(names(), sample);
    ui().click(panel + "List/3 haze_rolling.mp4").key(ui::Key::del);
    EXPECT_EQ(names(), (std::vector<std::string>{sample[0], sample[1]}));
    EXPECT_EQ(editor().clips().selected, 1U);
    EXPECT_EQ(last_step().name, "Remove clip");
    while (editor().document.can_undo()) editor().document.undo();
    EXPECT_EQ(names(), sample);
}

TEST_F(ClipsPanel, SaysWhichSmokeNoClipShows) {
    const std::string no_haze = "No clip has the role haze: the haze is an even veil.";
    const std::string none = "This preset has no smoke clip: cautery makes no smoke.";
    EXPECT_FALSE(ui().exists(panel + no_haze));
    ui().click(panel + "List/3 haze_rolling.mp4").key(ui::Key::del).frame();
    EXPECT_TRUE(ui().exists(panel + no_haze));
    EXPECT_FALSE(ui().exists(panel + none));
    ui().click(panel + "Remove clip").click(panel + "Remove clip").frame();
    EXPECT_FALSE(ui().exists(panel + no_haze));
    EXPECT_TRUE(ui().exists(panel + none));
}

TEST_F(ClipsPanel, DroppedVideosAreAddedInOneStep) {
    const fs::path one = write_clip(folder() / "one.avi", 5), two = write_clip(folder() / "two.avi", 5);
    drop(one.string() + "\n" + two.string());
    ASSERT_EQ(clips().size(), 5U);
    EXPECT_EQ(editor().document.done(), 1U);
    EXPECT_EQ(last_step().name, "Add 2 clips");
    EXPECT_EQ(editor().clips().selected, 4U);
    EXPECT_EQ(clips()[3].file, "one.avi") << "no other clip needed the preset's folder: it is theirs now";
    EXPECT_TRUE(editor().clips().faults(3).empty());
    EXPECT_EQ(editor().preview.preset_faults().size(), 0U);
    EXPECT_EQ(editor().preview.preview()->clips().size(), 5U) << "seen at once";
    editor().document.undo();
    EXPECT_EQ(names(), sample);
}

TEST_F(ClipsPanel, ANewClipComesWithTheKeyingThatIsSuggestedForIt) {
    const fs::path file = write_marked_smoke(folder() / "marked.avi");
    const KeyingParameters shared = editor().document.preset().smoke.keying;
    drop(file.string());
    ASSERT_EQ(clips().size(), 4U);
    SmokeClip wanted = clips()[3];
    wanted.keying = shared, wanted.masks.clear();
    suggest_keying(file).apply(wanted);
    EXPECT_EQ(clips()[3].own_keying, true);
    EXPECT_EQ(clips()[3].keying.luma_low, wanted.keying.luma_low);
    EXPECT_EQ(clips()[3].keying.luma_high, wanted.keying.luma_high);
    ASSERT_EQ(wanted.masks.size(), 1U) << "the watermark";
    EXPECT_EQ(clips()[3].masks, wanted.masks) << "is not seen at all";
    EXPECT_EQ(editor().document.preset().smoke.keying.luma_low, shared.luma_low) << "the others stay as they were";
    EXPECT_NE(ui().dump().find("Suggested keying for marked.avi, "), std::string::npos);
    EXPECT_EQ(last_step().name, "Add clip") << "one step";
    editor().document.undo();
    EXPECT_EQ(names(), sample);
}

TEST_F(ClipsPanel, TheFirstClipSetsTheKeyingThatAllShare) {
    editor().document.change("No clips", [](document::Content& c) { c.preset.smoke.clips.clear(); });
    const fs::path file = write_marked_smoke(folder() / "marked.avi");
    editor().clips().add({file.string()});
    ui().frame().frame();
    ASSERT_EQ(clips().size(), 1U);
    EXPECT_FALSE(clips()[0].own_keying);
    SmokeClip wanted;
    suggest_keying(file).apply(wanted);
    EXPECT_EQ(editor().document.preset().smoke.keying.luma_low, wanted.keying.luma_low);
    EXPECT_EQ(clips()[0].masks.size(), 1U);
}

TEST_F(ClipsPanel, LotsThatComeInQuickSuccessionAreAllAdded) {
    const fs::path one = write_clip(folder() / "one.avi", 5), two = write_clip(folder() / "two.avi", 5),
                   three = write_clip(folder() / "three.avi", 5), text = folder() / "notes.mp4";
    std::ofstream(text) << "no video at all";
    app::ClipShelf& shelf = editor().clips();
    shelf.add({one.string(), text.string()});
    shelf.add({two.string()});
    shelf.add({three.string()});
    shelf.give_up(three.string());
    for (int i = 0; i < 4; ++i) ui().frame();
    ASSERT_EQ(clips().size(), 5U);
    EXPECT_EQ(clips()[3].file, "one.avi") << "in the order in which they came";
    EXPECT_EQ(clips()[4].file, "two.avi");
    EXPECT_EQ(shelf.refused().size(), 1U) << "of the first lot, while the second was looked at";
    EXPECT_EQ(shelf.work(), nullptr);
    shelf.add({three.string()});
    shelf.add({three.string()});
    shelf.cancel_work();
    for (int i = 0; i < 4; ++i) ui().frame();
    EXPECT_EQ(clips().size(), 5U) << "cancelled with all that waits";
}

TEST_F(ClipsPanel, WhatIsNoVideoIsToldInPlace) {
    const fs::path text = folder() / "notes.mp4";
    std::ofstream(text) << "no video at all";
    const fs::path good = write_clip(folder() / "good.avi", 5);
    drop(text.string() + "\n" + good.string() + "\n" + (folder() / "none.mp4").string());
    EXPECT_EQ(clips().size(), 4U) << "the good one is there";
    EXPECT_EQ(editor().clips().refused().size(), 2U);
    EXPECT_NE(ui().dump().find("Not added: " + text.string() + ": is not a video that can be decoded"),
              std::string::npos);
    ui().click(panel + "Dismiss");
    EXPECT_EQ(ui().dump().find("Not added"), std::string::npos);
}

TEST_F(ClipsPanel, AMissingFileIsToldInPlaceWithTheWayOut) {
    const fs::path clip = write_clip(folder() / "clip.avi", 5);
    drop(clip.string());
    fs::remove(clip);
    editor().clips().look_again();
    ui().frame().frame();
    EXPECT_NE(ui().dump().find("clip.avi: no such clip; looked in"), std::string::npos);
    EXPECT_TRUE(ui().exists(panel + "Selected clip/Choose file..."));
    write_clip(clip, 5);
    ui().focus(panel + "Selected clip/Look again").key(ui::Key::enter).frame();  // a notice may cover it
    EXPECT_TRUE(editor().clips().faults(3).empty());
    EXPECT_FALSE(ui().exists(panel + "Selected clip/Choose file..."));
}

TEST_F(ClipsPanel, ACropThatLeavesNothingIsToldUntilItIsMended) {
    const auto crop = [&](double right) {
        editor().document.change("Crop", [&](document::Content& c) {
            c.preset.smoke.clips[1].crop.left = 0.6;
            c.preset.smoke.clips[1].crop.right = right;
        });
        ui().frame().frame();
    };
    crop(0.6);
    ASSERT_EQ(editor().clips().faults(1).size(), 1U);
    EXPECT_TRUE(editor().clips().faults(0).empty());
    crop(0.1);
    EXPECT_TRUE(editor().clips().faults(1).empty());
}

TEST_F(ClipsPanel, SavingCopiesTheClipsThatLieElsewhereWhenAskedTo) {
    const fs::path home = folder() / "preset", elsewhere = folder() / "videos";
    for (const fs::path& made : {home, elsewhere}) fs::create_directory(made);
    editor().document.save_preset(home / "mine.json");
    drop(write_clip(elsewhere / "smoke.avi", 5).string());
    editor().files().save_preset();
    ui().frame();
    ui().click("**/Copy clips and save").frame().frame();
    EXPECT_TRUE(fs::exists(home / "smoke.avi"));
    EXPECT_FALSE(editor().document.preset_unsaved());
    EXPECT_EQ(load_preset(home / "mine.json").smoke.clips[3].file, "smoke.avi");
    EXPECT_TRUE(editor().document.preset_faults().empty());
}

TEST_F(ClipsPanel, ClipsThatLieElsewhereAreCopiedBesideThePreset) {
    const fs::path home = folder() / "preset", elsewhere = folder() / "videos", third = folder() / "more";
    for (const fs::path& made : {home, elsewhere, third}) fs::create_directory(made);
    editor().document.save_preset(home / "mine.json");
    drop(write_clip(elsewhere / "smoke.avi", 5).string());
    EXPECT_TRUE(editor().clips().outside(3));
    drop(write_clip(third / "smoke.avi", 5).string());  // its folder is already needed by the other clip
    EXPECT_EQ(editor().document.preset().folder / clips()[4].file, third / "smoke.avi");
    EXPECT_EQ(editor().document.preset().folder / clips()[3].file, elsewhere / "smoke.avi");
    EXPECT_TRUE(editor().preview.preset_faults().empty()) << "both are seen at once";
    EXPECT_TRUE(editor().clips().outside(4));
    ui().click(panel + "Selected clip/Copy clips next to the preset").frame().frame();
    EXPECT_EQ(last_step().name, "Copy clips next to the preset");
    EXPECT_FALSE(editor().clips().any_outside());
    EXPECT_TRUE(editor().document.preset_faults().empty());
    EXPECT_TRUE(fs::exists(home / "smoke.avi"));
    EXPECT_TRUE(fs::exists(home / "smoke_2.avi")) << "neither takes the place of the other";
    EXPECT_EQ(fs::file_size(home / "smoke.avi"), fs::file_size(elsewhere / "smoke.avi"));
    EXPECT_EQ(editor().preview.preview()->clips().size(), 5U);
    editor().document.save_preset(home / "mine.json");
    EXPECT_EQ(load_preset(home / "mine.json").smoke.clips.size(), 5U);
}

TEST_F(ClipsPanel, UndoKeepsAClipThatWasJustAddedAndTheViewGoesOn) {
    const fs::path clip = write_clip(folder() / "one.avi", 5);
    drop(clip.string());
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 9; });
    ui().frame();
    ui().key('Z', ui::Mods::command).frame();
    ASSERT_EQ(clips().size(), 4U);
    EXPECT_EQ(editor().document.preset().folder / clips()[3].file, clip);
    EXPECT_TRUE(editor().document.preset_faults().empty());
    EXPECT_TRUE(editor().preview.preset_faults().empty());
    EXPECT_EQ(editor().preview.preview()->clips().size(), 4U);
    ui().key('Z', ui::Mods::command).frame();
    EXPECT_EQ(names(), sample);
    EXPECT_FALSE(editor().document.unsaved());
    ui().key('Z', ui::Mods::command | ui::Mods::shift).frame();
    EXPECT_EQ(editor().document.preset().folder / clips()[3].file, clip);
}

TEST_F(ClipsPanel, WhatCannotBeShownFreezesNothingElse) {
    const fs::path clip = write_clip(folder() / "one.avi", 5);
    layout("Tune");
    editor().document.change("Add", [&](document::Content& c) {
        c.preset.smoke.clips.push_back({.file = clip.string()});  // a saved preset must not name it so
        c.preset.smoke.keying.luma_low = 255;
    });
    const Image before = picture(6);
    ui().frame();
    EXPECT_NE(ui().dump().find("Not shown because of a fault:"), std::string::npos);
    EXPECT_NE(ui().dump().find("luma_low"), std::string::npos) << "which value it is";
    EXPECT_TRUE(ui().exists("**/Preset fault/Undo")) << "and how to get out";
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 60; });
    ui().frame();
    EXPECT_FALSE(ui().exists("**/Preset fault/Undo")) << "it would take back the speed";
    EXPECT_GT(differing(before, picture(6)), 100U);
    EXPECT_EQ(editor().preview.preview()->clips().size(), 3U);
}

TEST_F(ClipsPanel, WhatWasShownLastStandsInForAValueThatCannotBe) {
    layout("Tune");
    editor().document.change("Clip", [](document::Content& c) { c.preset.smoke.clips[1].file = "gone.mp4"; });
    const Image before = picture(6);
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 60; });
    const Image fast = picture(6);
    ASSERT_GT(differing(before, fast), 100U) << "seen although a clip is missing";
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = -5; });
    EXPECT_EQ(differing(fast, picture(6), 0), 0U);
}

TEST_F(ClipsPanel, AClipWhoseFileIsMissingIsFoundOrRemovedFromTheView) {
    layout("Tune");
    editor().document.change("Clip", [](document::Content& c) { c.preset.smoke.clips[1].file = "gone.mp4"; });
    ui().frame().frame();
    EXPECT_TRUE(ui().exists("**/Preset fault/Undo")) << "the last step named it";
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 60; });
    ui().frame().frame();
    EXPECT_FALSE(ui().exists("**/Preset fault/Undo")) << "it would take back the speed";

    write_smoke(folder() / "found.avi");
    ui().click("**/Preset fault/Find file...").frame().frame();
    ui().click("Another file for this clip/Name").key('A', ui::Mods::command).type((folder() / "found.avi").string());
    ui().key(ui::Key::enter).frame().frame();
    ASSERT_EQ(clips().size(), 3U);
    EXPECT_EQ(fs::path(clips()[1].file).filename(), "found.avi");
    EXPECT_FALSE(ui().exists("**/Preset fault"));

    ui().key('Z', ui::Mods::command).frame().frame();
    ui().click("**/Preset fault/Remove clip").frame().frame();
    EXPECT_EQ(names(), (std::vector<std::string>{sample[0], sample[2]}));
    EXPECT_EQ(editor().document.preset().bleeding.speed, 60.0) << "no other work is gone";
    EXPECT_FALSE(ui().exists("**/Preset fault"));
}

TEST_F(ClipsPanel, AClipThatIsALinkIsAddedFromWhereItLies) {
    const fs::path home = folder() / "preset";
    fs::create_directory(home);
    editor().document.save_preset(home / "mine.json");
    write_clip(folder() / "far.avi", 5);
    fs::create_symlink("../far.avi", home / "near.avi");
    drop((home / "near.avi").string());
    ASSERT_EQ(clips().size(), 4U);
    EXPECT_EQ(fs::canonical(editor().document.preset().folder / clips()[3].file), folder() / "far.avi");
    EXPECT_TRUE(editor().clips().faults(3).empty()) << editor().clips().faults(3).front();
    EXPECT_TRUE(editor().clips().outside(3)) << "it can be copied beside the preset";
    EXPECT_EQ(editor().preview.preview()->clips().size(), 4U);
}

TEST_F(ClipsPanel, AClipFromElsewhereLeavesWhatIsSavedOfTheOthers) {
    const fs::path home = folder() / "preset", elsewhere = folder() / "videos";
    for (const fs::path& made : {home, elsewhere}) fs::create_directory(made);
    Preset preset;
    preset.folder = home;
    preset.smoke.clips = {{.file = write_clip(home / "own.avi", 5).filename().string(), .weight = 2.5}};
    save_preset(preset, home / "mine.json");
    open({(home / "mine.json").string()});
    drop(write_clip(elsewhere / "own.avi", 5).string());
    ASSERT_EQ(clips().size(), 2U);
    ASSERT_EQ(clips()[0].file, "preset/own.avi") << "named anew";
    ASSERT_NE(editor().saved().known_clip(0), nullptr);
    EXPECT_EQ(editor().saved().known_clip(0)->weight, 2.5);
    EXPECT_EQ(editor().saved().known_clip(1), nullptr) << "another one of that name";
}

TEST_F(ClipsPanel, AVideoOpenedWithAPresetIsAddedToItsClips) {
    const fs::path home = folder() / "preset", elsewhere = folder() / "videos";
    for (const fs::path& made : {home, elsewhere}) fs::create_directory(made);
    Preset preset;
    preset.folder = home;
    preset.smoke.clips = {
        {.file = write_clip(home / "haze.avi", 5).filename().string(), .role = ClipRole::haze, .weight = 2.5}};
    save_preset(preset, home / "mine.json");
    const fs::path video = write_smoke(elsewhere / "smoke.avi");
    const auto expect = [&](const char* how) {
        ASSERT_EQ(clips().size(), 2U) << how;
        EXPECT_EQ(editor().document.preset().folder / clips()[0].file, home / "haze.avi") << how;
        EXPECT_EQ(editor().document.preset().folder / clips()[1].file, video) << how;
        EXPECT_EQ(editor().document.preset_file(), home / "mine.json") << how;
        EXPECT_TRUE(editor().document.preset_unsaved()) << how;
        EXPECT_TRUE(editor().document.preset_faults().empty()) << how;
        EXPECT_TRUE(editor().preview.preset_faults().empty()) << how;
    };
    open({(home / "mine.json").string(), video.string()});
    expect("together");
    open_sample();
    open({(home / "mine.json").string()});
    open({video.string()});
    expect("one after the other");
}

TEST_F(ClipsPanel, InAndOutAreARangeOfTheClip) {
    ui().drag(panel + "Selected clip/Use/In and out/High", {-40, 0});
    EXPECT_GT(clips()[0].out, 1.0);
    EXPECT_LT(clips()[0].out, 5.0);
    EXPECT_EQ(last_step().name, "In and out");
    EXPECT_EQ(editor().document.done(), 1U);
    ui().key(ui::Key::end, ui::Mods::command);
    EXPECT_EQ(clips()[0].out, 0.0) << "the end of the clip is 0";
    EXPECT_TRUE(editor().document.preset_faults().empty());
}

TEST_F(ClipsPanel, AReplacedFileKeepsHowItIsUsed) {
    editor().document.change("Weight", [](document::Content& c) { c.preset.smoke.clips[1].weight = 2.5; });
    editor().clips().add({write_clip(folder() / "other.avi", 5).string()}, 1);
    ui().frame().frame();
    EXPECT_EQ(clips().size(), 3U);
    EXPECT_EQ(fs::path(clips()[1].file).filename(), "other.avi");
    EXPECT_EQ(clips()[1].weight, 2.5);
    EXPECT_EQ(last_step().name, "Replace clip");
}

}  // namespace
}  // namespace lapfx::test
