#include "document/document.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <random>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"

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

/// Any order of edits, undo and redo gives the same as a list of whole states.
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

Content with_events(std::size_t count) {
    Content content;
    content.scene.events.resize(count);
    for (std::size_t i = 0; i < count; ++i) content.scene.events[i].time = 0.01 * static_cast<double>(i);
    return content;
}

/// Bytes of as many steps of one slider as are kept.
std::size_t memory_of_a_slider(Content content) {
    Document document;
    document.open(std::move(content));
    for (std::size_t i = 1; i <= Document::most_steps; ++i)
        document.change("Speed", [&](Content& c) { c.preset.bleeding.speed = 0.1 * static_cast<double>(i); });
    EXPECT_EQ(document.steps().size(), Document::most_steps);
    return document.step_memory();
}

TEST(DocumentHistory, StepsHoldWhatDiffersHoweverLargeTheDocumentIs) {
    Content large = with_events(4096);
    large.preset.smoke.clips.resize(16, {.file = "a_clip_with_a_long_name_that_is_not_kept_in_place.mp4"});
    const std::size_t small = memory_of_a_slider({});
    EXPECT_EQ(memory_of_a_slider(std::move(large)), small);
    EXPECT_LT(small, Document::most_steps * 1000) << "less than a preset each";
    EXPECT_LT(small, Document::most_steps * sizeof(Preset));
}

TEST(DocumentHistory, AnEventPutInAmongManyIsOneEvent) {
    Document document;
    document.open(with_events(4096));
    const std::string before = write_scene(document.scene());
    document.change("Add event",
                    [&](Content& c) { c.scene.events.insert(c.scene.events.begin() + 7, {.time = 3.25}); });
    const std::string after = write_scene(document.scene());
    EXPECT_LT(document.step_memory(), sizeof(Step) + sizeof(ToolContact) + 500);
    document.undo();
    EXPECT_EQ(write_scene(document.scene()), before);
    document.redo();
    EXPECT_EQ(write_scene(document.scene()), after);
}

TEST(DocumentHistory, RenamingIsNoStepAndLastsThroughUndo) {
    Document document;
    document.open({});
    document.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    document.change("Name", [](Content& c) { c.preset.name = "typed"; });
    EXPECT_TRUE(document.steps()[1].preset.changes("/name"));
    EXPECT_FALSE(document.steps()[0].preset.changes("/name"));
    document.rename(Document::Named::preset, "saved as this");
    EXPECT_EQ(document.steps().size(), 2U);
    document.undo();
    EXPECT_EQ(document.preset().name, "") << "as it was before one was typed";
    document.redo();
    EXPECT_EQ(document.preset().name, "saved as this");
    EXPECT_NE(document.steps()[1].change.find("saved as this"), std::string::npos) << document.steps()[1].change;
    EXPECT_EQ(document.steps()[1].change.find("typed"), std::string::npos) << document.steps()[1].change;
    document.go_to(1);
    document.rename(Document::Named::preset, "before it");
    EXPECT_NE(document.steps()[1].change.find("before it to saved as this"), std::string::npos)
        << document.steps()[1].change;
    document.rename(Document::Named::scene, "Renamed");
    document.undo();
    EXPECT_EQ(document.scene().name, "Renamed");
    EXPECT_EQ(document.preset().bleeding.speed, BleedingParameters{}.speed);
}

/// Who follows a document asks what has changed since it looked last.
TEST(DocumentHistory, WhatChangedIsKnownByTheRowsRedoBits) {
    Document document;
    document.open(with_events(3));
    std::uint64_t seen = document.version();
    const auto changed = [&] {
        const std::pair bits(document.scene_changes_since(seen), document.preset_changes_since(seen));
        seen = document.version();
        return bits;
    };
    using Bits = std::pair<unsigned, unsigned>;
    document.change("Opacity", [](Content& c) { c.preset.bleeding.opacity = 0.31; });
    EXPECT_EQ(changed(), Bits(0, redo::picture));
    document.change("Weight", [](Content& c) { c.preset.smoke.clips.resize(2); });
    EXPECT_NE(changed().second & redo::clips, 0U);
    document.change("Opacity", [](Content& c) { c.preset.bleeding.opacity = 0.32; });
    EXPECT_EQ(changed(), Bits(0, redo::picture)) << "clips changed in the step before";
    document.go_to(1);
    EXPECT_NE(changed().second & redo::clips, 0U) << "undone";
    document.begin("Exposure");
    document.edit([](Content& c) { c.scene.camera.exposure = 2; });
    EXPECT_EQ(changed(), Bits(redo::picture, 0));
    document.edit([](Content& c) { c.scene.camera.exposure = Scene{}.camera.exposure; });
    EXPECT_EQ(changed(), Bits(redo::picture, 0)) << "back to where the gesture began is a change, too";
    document.edit([](Content& c) { c.scene.events[1].time = 5; });
    EXPECT_NE(changed().first & redo::amounts, 0U);
    document.cancel();
    EXPECT_NE(changed().first & redo::amounts, 0U);
    EXPECT_EQ(document.changes_since(document.version()), 0U);
    document.change("Folder", [](Content& c) { c.preset.folder = "/elsewhere", c.preset.bleeding.speed = 7; });
    EXPECT_NE(changed().second & redo::clips, 0U) << "clips are looked up elsewhere";
}

TEST(DocumentHistory, ForgetsTheOldestStepsThatTakeTooMuch) {
    Document document;
    const std::size_t count = Document::most_step_bytes / sizeof(ToolContact) / 4;  // four such scenes fill it
    for (int i = 1; i <= 9; ++i)
        document.change("Events", [&](Content& c) { c.scene.events.assign(count, {.time = static_cast<double>(i)}); });
    EXPECT_LE(document.step_memory(), Document::most_step_bytes);
    EXPECT_GE(document.steps().size(), 2U);
    EXPECT_LE(document.steps().size(), 3U);
    EXPECT_EQ(document.done(), document.steps().size());
    EXPECT_EQ(document.scene().events[0].time, 9.0);
    document.undo();
    EXPECT_EQ(document.scene().events[0].time, 8.0);
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
    const auto found = [&] { return document_.preset().folder / document_.preset().smoke.clips[0].file; };
    EXPECT_EQ(found(), in("first/clips/a.mp4"));
    document_.redo();
    EXPECT_EQ(found(), in("first/clips/a.mp4"));
    EXPECT_FALSE(document_.preset_unsaved());
    document_.save_preset(in("p.json"));
    EXPECT_EQ(document_.clips_outside(in("second")), std::vector<std::string>{"first/clips/a.mp4"});
    EXPECT_THROW(document_.save_preset(in("second/p.json")), Error);
    EXPECT_EQ(document_.preset_file(), in("p.json"));
    document_.set_clip_folders({in("first/clips")});
    document_.save_preset(in("second/p.json"));
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "a.mp4") << "found on the search path";
}

/// Saving in another folder changes the names of clips in the present state only; undo and redo still work.
TEST_F(DocumentFiles, StepsThatAreUndoneWhenItIsSavedElsewhereStillFindClips) {
    for (const char* made : {"first/clips", "second"}) fs::create_directories(in(made));
    for (const char* name : {"first/clips/a.mp4", "first/clips/b.mp4"}) std::ofstream(in(name)) << "x";
    Content content;
    content.preset.smoke.clips = {{.file = "clips/a.mp4"}};
    content.preset.folder = in("first");
    document_.open(content, {}, in("first/p.json"));
    document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    document_.change("Add clip", [](Content& c) { c.preset.smoke.clips.push_back({.file = "clips/b.mp4"}); });
    document_.change("Opacity", [](Content& c) { c.preset.bleeding.opacity = 0.3; });
    document_.go_to(1);
    document_.save_preset(in("p.json"));
    const auto found = [&](std::size_t i) {
        return document_.preset().folder / document_.preset().smoke.clips.at(i).file;
    };
    for (int round = 0; round < 2; ++round) {
        document_.go_to(3);
        EXPECT_EQ(found(0), in("first/clips/a.mp4"));
        EXPECT_EQ(found(1), in("first/clips/b.mp4"));
        EXPECT_EQ(document_.preset().bleeding.opacity, 0.3);
        document_.go_to(1);
        EXPECT_EQ(found(0), in("first/clips/a.mp4"));
        EXPECT_EQ(document_.preset().bleeding.speed, 7);
        EXPECT_FALSE(document_.preset_unsaved());
        document_.go_to(0);
        EXPECT_EQ(found(0), in("first/clips/a.mp4"));
        EXPECT_EQ(document_.preset().bleeding.speed, BleedingParameters{}.speed);
    }
}

/// A gesture that changes nothing in the saved file leaves no step and every letter as it was.
TEST_F(DocumentFiles, AClipNamedByAnotherWayIsNoStep) {
    fs::create_directories(in("home"));
    std::ofstream(in("home/a.mp4")) << "x";
    Content content;
    content.preset.smoke.clips = {{.file = "a.mp4"}};
    content.preset.folder = in("home");
    document_.open(content, {}, in("home/p.json"));
    document_.change("Replace clip", [&](Content& c) {
        c.preset.folder = folder_;
        c.preset.smoke.clips[0].file = "home/a.mp4";
    });
    EXPECT_TRUE(document_.steps().empty());
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "a.mp4");
    EXPECT_EQ(document_.preset().folder, in("home"));
}

/// However files are named, and from wherever: undo and redo give back every letter, and what was not touched is not
/// unsaved.
TEST_F(DocumentFiles, AValueIsWhatItWasThroughUndoAndRedo) {
    fs::create_directories(in("home/clips"));
    for (const char* name : {"home/organ.obj", "home/clips/a.avi", "tool.obj", "home/smoke_01.png"})
        std::ofstream(in(name)) << "x";
    Content content;
    content.scene.organ.file = "./organ.obj";
    content.scene.tool.file = "../tool.obj";
    content.scene.reference.file = in("nowhere.mp4").string();
    content.scene.preset = "clips/../p.json";
    for (const char* file : {"./clips/a.avi", "clips//a.avi", "smoke_%02d.png", "gone.avi", "plume.mp4"})
        content.preset.smoke.clips.push_back({.file = file});
    for (const bool has_files : {true, false})
        for (const fs::path& home : {in("home"), fs::relative(in("home")), in("home") / "", fs::path()}) {
            content.scene.folder = content.preset.folder = home;
            Document document;
            document.set_clip_folders({in("home/clips")});
            document.open(content, has_files ? home / "s.json" : fs::path(), has_files ? home / "p.json" : fs::path());
            const Content opened = document.content();
            EXPECT_FALSE(document.unsaved());
            document.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
            document.change("Seed", [](Content& c) { c.scene.seed = 7; });
            const Content changed = document.content();
            document.begin("Given up");
            document.edit([](Content& c) { c.preset.bleeding.speed = 8; });
            document.cancel();
            const auto expect = [&](const Content& wanted, const char* when) {
                EXPECT_EQ(write_scene(document.scene()), write_scene(wanted.scene)) << when << " in " << home;
                EXPECT_EQ(write_preset(document.preset()), write_preset(wanted.preset)) << when << " in " << home;
                EXPECT_EQ(document.scene().folder, wanted.scene.folder) << when;
                EXPECT_EQ(document.preset().folder, wanted.preset.folder) << when;
            };
            expect(changed, "cancelled");
            document.undo();
            document.undo();
            expect(opened, "undone");
            EXPECT_FALSE(document.unsaved()) << home;
            document.go_to(2);
            expect(changed, "redone");
        }
}

TEST_F(DocumentFiles, AClipFromElsewhereOutlivesUndo) {
    for (const char* made : {"home", "elsewhere", "third", "shipped"}) fs::create_directories(in(made));
    for (const char* name : {"shipped/plume.mp4", "elsewhere/a.avi", "third/b.avi", "home/own.avi"})
        std::ofstream(in(name)) << "x";
    const auto add = [&](const fs::path& file) {
        document_.change("Add clip", [&](Content& c) {
            c.preset.smoke.clips.push_back({.file = file.string()});
            document_.gather_clips(c.preset);
        });
    };
    const auto found = [&](std::size_t i) {
        return document_.preset().folder / document_.preset().smoke.clips[i].file;
    };
    document_.set_clip_folders({in("shipped")});
    for (const bool has_file : {true, false}) {
        Content content;
        content.preset.folder = in("home");
        content.preset.smoke.clips = {{.file = "plume.mp4"}};
        document_.open(content, {}, has_file ? in("home/p.json") : fs::path());
        add(in("elsewhere/a.avi"));
        EXPECT_EQ(found(1), in("elsewhere/a.avi"));
        document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
        document_.undo();
        EXPECT_EQ(document_.preset().smoke.clips[1].file, "a.avi");
        EXPECT_EQ(document_.preset().folder, in("elsewhere"));
        EXPECT_TRUE(document_.preset_faults().empty());
        add(in("third/b.avi"));
        add(in("home/own.avi"));
        add(in("shipped/plume.mp4"));
        EXPECT_EQ(document_.preset().folder, folder_) << "the deepest that holds all";
        EXPECT_EQ(found(1), in("elsewhere/a.avi"));
        EXPECT_EQ(found(2), in("third/b.avi"));
        EXPECT_EQ(found(3), in("home/own.avi"));
        EXPECT_EQ(document_.preset().smoke.clips[4].file, "plume.mp4") << "that came with the program";
        EXPECT_TRUE(document_.preset_faults().empty());
        EXPECT_EQ(document_.clips_outside(in("home")).size(), 2U);
        while (document_.can_undo()) document_.undo();
        EXPECT_FALSE(document_.unsaved());
        EXPECT_EQ(document_.preset().folder, in("home"));
    }
}

TEST_F(DocumentFiles, AClipOfTheSameNameElsewhereIsAnotherOne) {
    for (const char* made : {"a", "b"}) {
        fs::create_directories(in(made));
        std::ofstream(in(made) / "smoke.avi") << made;
    }
    Content content;
    content.preset.smoke.clips = {{.file = "smoke.avi"}};
    content.preset.folder = in("a");
    document_.open(content, {}, in("a/p.json"));
    document_.change("Replace clip", [&](Content& c) {
        c.preset.smoke.clips[0].file = in("b/smoke.avi").string();
        document_.gather_clips(c.preset);
    });
    EXPECT_EQ(document_.done(), 1U);
    EXPECT_TRUE(document_.preset_unsaved());
    Preset same_clip = document_.preset();
    same_clip.folder = folder_;
    same_clip.smoke.clips[0].file = "b/smoke.avi";
    EXPECT_TRUE(same(same_clip, document_.preset()));
}

TEST_F(DocumentFiles, ASceneSavedElsewhereStillFindsItsFiles) {
    for (const char* made : {"store", "home", "other"}) fs::create_directories(in(made));
    for (const char* name : {"store/organ.glb", "home/case:3.glb"}) std::ofstream(in(name)) << "x";
    fs::create_symlink("../store/organ.glb", in("home/organ.glb"));
    Content content;
    content.scene.organ.file = "organ.glb";
    content.scene.tool.file = in("home/case:3.glb").string();
    content.scene.folder = in("home");
    document_.open(content, in("home/s.json"));
    const auto expect = [&](const char* where) {
        const Scene& scene = document_.scene();
        EXPECT_EQ(fs::weakly_canonical(named_path(scene.folder, scene.organ.file, Reach::anywhere)),
                  in("store/organ.glb"))
            << where;
        EXPECT_TRUE(fs::equivalent(named_path(scene.folder, scene.tool.file, Reach::anywhere), in("home/case:3.glb")))
            << where;
    };
    document_.save_scene(in("other/s.json"));
    expect("elsewhere: the one is a link, the other reads as a URL");
    document_.save_scene(in("home/s.json"));
    expect("beside it");
}

TEST_F(DocumentFiles, AClipThatIsALinkIsNamedWhereItLies) {
    for (const char* made : {"home/sub", "elsewhere"}) fs::create_directories(in(made));
    for (const char* name : {"elsewhere/a.avi", "home/own.avi", "home/sub/b.avi"}) std::ofstream(in(name)) << "x";
    fs::create_symlink("../elsewhere/a.avi", in("home/link.avi"));
    fs::create_symlink("sub/b.avi", in("home/inner.avi"));
    fs::create_symlink("home", in("door"));
    const auto add = [&](const fs::path& file) {
        document_.change("Add clip", [&](Content& c) {
            c.preset.smoke.clips.push_back({.file = file.string()});
            document_.gather_clips(c.preset);
        });
    };
    const auto found = [&](std::size_t i) {
        return fs::canonical(find_clip(document_.preset().smoke.clips[i].file, document_.preset().folder, {}));
    };
    Content content;
    content.preset.folder = in("door");
    document_.open(content, {}, in("door/p.json"));
    add(in("home/own.avi"));
    add(in("door/inner.avi"));
    EXPECT_EQ(document_.preset().folder, in("door")) << "the preset's folder, whichever way one came";
    EXPECT_EQ(document_.preset().smoke.clips[0].file, "own.avi");
    EXPECT_EQ(document_.preset().smoke.clips[1].file, "inner.avi") << "as it is spelled where that is allowed";
    const Preset before = document_.preset();
    add(in("door/link.avi"));
    EXPECT_EQ(document_.preset().folder, folder_);
    EXPECT_EQ(found(0), in("home/own.avi"));
    EXPECT_EQ(found(1), in("home/sub/b.avi"));
    EXPECT_EQ(found(2), in("elsewhere/a.avi"));
    EXPECT_EQ(real_clip(before.smoke.clips[0].file, before.folder),
              real_clip(document_.preset().smoke.clips[0].file, document_.preset().folder));
    EXPECT_EQ(document_.clips_outside(in("home")).size(), 1U);
}

TEST_F(DocumentFiles, ASceneStaysSavedWhicheverPresetItWasSavedWith) {
    Content content;
    content.scene.organ.file = "organ.obj";
    document_.open(content);
    document_.change("Speed", [](Content& c) { c.preset.bleeding.speed = 7; });
    document_.save_preset(in("p.json"));
    document_.save_scene(in("s.json"));
    document_.undo();
    EXPECT_FALSE(document_.scene_unsaved());
    document_.redo();
    EXPECT_FALSE(document_.unsaved());
    EXPECT_EQ(document_.scene().folder / document_.scene().preset, in("p.json"));
}

TEST(DocumentMended, OneValueThatCannotBeKeepsNoOtherFromBeingSeen) {
    Preset good;
    good.folder = "/home";
    good.smoke.clips = {{.file = "a.avi", .weight = 2}, {.file = "b.avi"}};
    ASSERT_TRUE(check(preset_table(), &good).empty());
    Preset wanted = good;
    EXPECT_EQ(write_preset(mended(wanted, good)), write_preset(wanted)) << "nothing is wrong";
    wanted.bleeding.speed = 7;
    wanted.bleeding.max_extent = -1;
    wanted.smoke.keying.luma_high = 0;  // below luma_low, which is blamed
    wanted.smoke.clips[0].weight = -1;
    wanted.smoke.clips[1].weight = 3;
    wanted.smoke.clips.push_back({.file = "../c.avi"});
    ASSERT_GE(check(preset_table(), &wanted).size(), 4U);
    const Preset shown = mended(wanted, good);
    EXPECT_TRUE(check(preset_table(), &shown).empty());
    EXPECT_EQ(shown.bleeding.speed, 7);
    EXPECT_EQ(shown.bleeding.max_extent, good.bleeding.max_extent);
    EXPECT_EQ(shown.smoke.keying.luma_high, good.smoke.keying.luma_high);
    ASSERT_EQ(shown.smoke.clips.size(), 2U) << "the one that cannot be is left out";
    EXPECT_EQ(shown.smoke.clips[0].weight, 2);
    EXPECT_EQ(shown.smoke.clips[1].weight, 3);
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
