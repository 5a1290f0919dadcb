// The reference panel shows a video that follows the timeline, is aligned with it and compared with the preview.
#include "app/reference/reference.h"

#include <fstream>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/files/open.h"
#include "editor/support/editor_test.h"
#include "support/clips.h"
#include "support/folders.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* panel = "Workspace/Reference";

class ReferencePanel : public SampleTest {
  protected:
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        editor().reference().comparison().way = app::CompareWay::reference;
        layout("Compare");
    }
    app::Reference& reference() { return editor().reference(); }
    app::ReferenceComparison& comparison() { return reference().comparison(); }
    std::string named() { return editor().document.scene().reference.file; }
    static std::string in(const std::string& name) { return std::string(panel) + "/" + name; }
    /// A video with ten frames a second, each with another brightness.
    fs::path video(const std::string& name = "v.avi", int frames = 30) {
        return write_clip(folder() / name, frames, {64, 32}, 10);
    }
    void drop(const fs::path& file) {
        ui().drop(panel, file.string());
        ui().frame().frame();
    }
};

TEST_F(ReferencePanel, TheSampleSceneHasOneThatFollowsTheTimeline) {
    ASSERT_NE(reference().video(), nullptr);
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(160, 128));
    EXPECT_NEAR(reference().video()->info().duration, 8.0, 0.05);
    editor().timeline.seek(4);
    ui().frame();
    EXPECT_EQ(reference().frame(), 112) << "half a second on, 25 a second";
    EXPECT_EQ(ui().value(in("Frame")), 112);
    const ui::Picture picture = reference().shown().whole();
    const glm::vec4 before = picture.pixels->pixel({80, 62});
    editor().timeline.seek(0);
    ui().frame();
    EXPECT_GT(glm::distance(before, picture.pixels->pixel({80, 62})), 20.0F) << "blood has gone there";
    const auto span = reference().span();
    ASSERT_TRUE(span.has_value());
    EXPECT_NEAR(span->low, -0.5, 1e-9);
}

TEST_F(ReferencePanel, WithoutOneItSaysWhatToDo) {
    reference().remove();
    ui().frame();
    EXPECT_FALSE(ui().exists(in("Video")));
    ui().click(in("Sample reference")).frame();
    EXPECT_EQ(named(), "reference/operation.mp4") << "relative: it lies below the scene";
    EXPECT_TRUE(ui().exists(in("Video")));
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(named(), "");
    EXPECT_FALSE(ui().exists(in("Video")));
}

TEST_F(ReferencePanel, AVideoDroppedOnItIsTheReference) {
    const fs::path file = video();
    drop(file);
    EXPECT_EQ(named(), fs::canonical(file).string());
    EXPECT_EQ(editor().document.scene().reference.offset, 0.0);
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(64, 32));
    EXPECT_EQ(editor().document.steps().back().name, "Reference video");
    EXPECT_EQ(editor().document.preset().smoke.clips.size(), 3U) << "and no clip of the preset";
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(named(), "reference/operation.mp4");
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(160, 128));
}

TEST_F(ReferencePanel, WhatIsNoVideoIsToldInPlaceWithTheWayOut) {
    const fs::path file = folder() / "notes.mp4";
    std::ofstream(file) << "words, not a video";
    const std::size_t steps = editor().document.done();
    const std::string told = "notes.mp4: is not a video that can be decoded";
    drop(file);
    EXPECT_NE(ui().dump().find(told), std::string::npos) << ui().dump();
    EXPECT_EQ(named(), "reference/operation.mp4") << "the good one stays";
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(160, 128));
    EXPECT_EQ(editor().document.done(), steps);
    EXPECT_TRUE(ui().exists(in("Video")));
    ui().click(in("Choose another file...")).frame();
    EXPECT_NE(ui().dump().find("Open reference video"), std::string::npos);
    ui().key(ui::Key::escape).frame();
    ui().click(in("Keep this reference")).frame();
    EXPECT_EQ(ui().dump().find(told), std::string::npos);
    reference().remove();
    drop(file);
    EXPECT_NE(ui().dump().find(told), std::string::npos) << ui().dump();
    EXPECT_TRUE(ui().exists(in("Choose another file...")));
    EXPECT_EQ(named(), "");
    ui().click(in("Remove")).frame();
    EXPECT_TRUE(ui().exists(in("Sample reference"))) << "back to the beginning";
}

/// The scene names the reference, so there is no other one to show.
TEST_F(ReferencePanel, AScenesReferenceThatIsNoVideoIsToldWithTheWayOut) {
    std::ofstream(folder() / "notes.mp4") << "words, not a video";
    editor().document.change("Reference video", [&](document::Content& c) {
        c.scene.reference = {.file = (folder() / "notes.mp4").string()};
    });
    ui().frame().frame();
    EXPECT_EQ(reference().video(), nullptr);
    EXPECT_NE(ui().dump().find("notes.mp4: is not a video that can be decoded"), std::string::npos) << ui().dump();
    ui().click(in("Remove")).frame();
    EXPECT_EQ(named(), "");
}

TEST_F(ReferencePanel, WhatIsBeingOpenedIsNotForAnotherDocument) {
    reference().choose(video());
    editor().forget_document();
    ui().frame().frame();
    EXPECT_EQ(named(), "reference/operation.mp4");
    EXPECT_FALSE(reference().opening());
}

TEST_F(ReferencePanel, AFileThatVanishesKeepsItsLastFrame) {
    const fs::path file = video();
    drop(file);
    editor().timeline.seek(1.0);
    ui().frame();
    fs::rename(file, folder() / "away.avi");
    ui().frame().frame();
    EXPECT_NE(ui().dump().find("v.avi: no longer exists; its last frame stays"), std::string::npos) << ui().dump();
    EXPECT_TRUE(ui().exists(in("Video")));
    EXPECT_TRUE(ui().exists(in("Choose another file...")));
    fs::rename(folder() / "away.avi", file);
    ui().frame().frame();
    EXPECT_EQ(ui().dump().find("no longer exists"), std::string::npos);
}

TEST_F(ReferencePanel, AFrameThatIsHeldIsAlignedWithTheScene) {
    drop(video());
    editor().timeline.seek(2.0);
    ui().frame();
    EXPECT_EQ(reference().frame(), 20);
    EXPECT_TRUE(ui().is(in("Align start here"), ui::Is::disabled));
    ui().click(in("Frame after")).click(in("Frame after")).click(in("Frame after")).click(in("Frame before")).frame();
    EXPECT_EQ(reference().frame(), 22);
    editor().timeline.seek(0.5);
    ui().frame();
    EXPECT_EQ(reference().frame(), 22) << "held";
    ui().click(in("Align start here")).frame();
    EXPECT_NEAR(editor().document.scene().reference.offset, 1.7, 1e-6);
    EXPECT_FALSE(reference().held());
    EXPECT_EQ(reference().frame(), 22);
    editor().timeline.seek(0.6);
    ui().frame();
    EXPECT_EQ(reference().frame(), 23);
    EXPECT_EQ(editor().document.steps().back().name, "Align reference");
    editor().document.undo();
    EXPECT_EQ(editor().document.scene().reference.offset, 0.0);
}

TEST_F(ReferencePanel, TheOffsetIsOneStepAGesture) {
    const std::size_t steps = editor().document.done();
    ui().click(in("Offset"), {.clicks = 2}).type("-1.25").key(ui::Key::enter).frame();
    EXPECT_NEAR(editor().document.scene().reference.offset, -1.25, 1e-9);
    EXPECT_EQ(editor().document.done(), steps + 1);
    EXPECT_EQ(editor().document.steps().back().name, "Reference offset");
    editor().timeline.seek(1.0);
    ui().frame();
    EXPECT_EQ(reference().frame(), 0);
    EXPECT_NE(ui().dump().find("Before its start"), std::string::npos);
    editor().timeline.seek(11.5);
    ui().frame();
    EXPECT_EQ(reference().frame(), 199);
    EXPECT_NE(ui().dump().find("After its end"), std::string::npos);
}

TEST_F(ReferencePanel, BackspaceGoesBackToTheSavedOffset) {
    const auto move = [&](double offset) {
        editor().document.change("Offset", [&](document::Content& c) { c.scene.reference.offset = offset; });
    };
    move(0.25);
    editor().document.save_scene(folder() / "mine.scene.json");
    ui().frame();
    move(2);
    ui().frame().move_to(in("Offset")).key(ui::Key::backspace);
    EXPECT_EQ(editor().document.scene().reference.offset, 0.25);
    ui().move_to(in("Offset")).key(ui::Key::backspace, ui::Mods::shift);
    EXPECT_EQ(editor().document.scene().reference.offset, 0.0) << "with Shift the default";
}

TEST_F(ReferencePanel, KeysGoThroughTheWaysAndSwap) {
    EXPECT_EQ(comparison().way, app::CompareWay::reference);
    ui().key('M').frame();
    EXPECT_EQ(comparison().way, app::CompareWay::beside);
    ui().click(in("Comparison"));
    ui().key('M').frame();
    EXPECT_EQ(comparison().way, app::CompareWay::wipe) << "also where letters belong to the picture";
    ui().key('X').frame();
    EXPECT_TRUE(comparison().state.swapped);
    EXPECT_TRUE(ui().is(in("Swap"), ui::Is::checked));
    ui().click(in("Compare/Difference")).frame();
    EXPECT_TRUE(ui().exists(in("Gain")));
    ui().click(in("Compare/Onion")).frame();
    EXPECT_TRUE(ui().exists(in("Mix")));
    ui().key('M').frame();
    EXPECT_EQ(comparison().way, app::CompareWay::reference);
    EXPECT_TRUE(ui().exists(in("Video")));
}

TEST_F(ReferencePanel, ThePreviewBesideIsTheOneOfTheViewPanel) {
    editor().timeline.seek(6);
    ui().click(in("Compare/Wipe")).frame().frame();
    const ui::Picture beside = comparison().preview();
    ASSERT_EQ(beside.size, glm::ivec2(160, 128));
    ASSERT_NE(beside.pixels, nullptr);
    const glm::ivec2 drawn = comparison().drawn_size();
    layout("Tune");
    editor().preview.resize(drawn);
    app::Shot shot = editor().shot();
    editor().preview.draw(shot);
    const Image view = editor().preview.read();
    ASSERT_EQ(glm::ivec2(view.width, view.height), drawn);
    for (const glm::ivec2 at : {glm::ivec2(80, 64), glm::ivec2(50, 75), glm::ivec2(100, 45), glm::ivec2(82, 60)}) {
        const glm::ivec2 there((glm::dvec2(at) + 0.5) * glm::dvec2(drawn) / glm::dvec2(beside.size));
        const std::uint8_t* p = view.pixels.data() + 4 * (there.y * view.width + there.x);
        EXPECT_EQ(beside.pixels->pixel(at), glm::vec4(p[0], p[1], p[2], p[3])) << at.x << ", " << at.y;
    }
}

TEST_F(ReferencePanel, ThePreviewBesideIsThereAsSoonAsThereIsOne) {
    app::Opened opened = app::open_sample(shipped());
    start();
    EXPECT_TRUE(editor().layouts().choose("Compare"));
    editor().document.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    ui().frame();
    ui().frame();
    EXPECT_NE(comparison().preview().image, 0U);
    ASSERT_NE(comparison().preview().pixels, nullptr) << "drawn";
    EXPECT_GT(comparison().preview().pixels->pixel({80, 64}).r, 20.0F);
}

TEST_F(ReferencePanel, WhatIsNotSeenIsNotDrawn) {
    ui().frame();
    EXPECT_FALSE(comparison().wanted());
    ui().click(in("Compare/Side by side")).frame();
    EXPECT_TRUE(comparison().wanted());
    EXPECT_FALSE(reference().draw(scene_scale)) << "nothing has changed";
    editor().timeline.seek(3);
    EXPECT_TRUE(reference().draw(scene_scale));
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 12; });
    editor().preview.follow(editor().document);
    EXPECT_TRUE(reference().draw(scene_scale));
    layout("Tune");
    EXPECT_FALSE(comparison().wanted());
}

TEST_F(ReferencePanel, LargeReferencesAreComparedAtASizeThatCanBeDrawn) {
    drop(write_clip(folder() / "large.avi", 2, {1600, 800}, 10));
    ui().click(in("Compare/Difference")).frame();
    EXPECT_EQ(comparison().preview().size, glm::ivec2(1280, 640));
    EXPECT_EQ(comparison().reference().size, glm::ivec2(1280, 640));
    const ui::Picture whole = reference().shown().whole(), counted = comparison().reference();
    EXPECT_EQ(counted.pixels->pixel({1279, 639}), whole.pixels->pixel({1599, 799}));
}

TEST_F(ReferencePanel, ThePreviewIsAsSharpAsThePanelWhateverTheVideoIs) {
    drop(write_clip(folder() / "small.avi", 30, {160, 80}, 10));
    editor().timeline.seek(6);
    ui().click(in("Compare/Difference")).frame().frame();
    EXPECT_EQ(comparison().drawn_size(), glm::ivec2(160, 80)) << "what is subtracted is of one resolution";
    const auto mean_difference = [&](const std::vector<glm::vec4>& before) {
        const ui::Picture now = comparison().preview();
        double sum = 0;
        for (int i = 0; i < 160 * 80; ++i)
            sum += glm::distance(glm::vec3(before[static_cast<std::size_t>(i)]),
                                 glm::vec3(now.pixels->pixel({i % 160, i / 160})));
        return sum / (160 * 80);
    };
    std::vector<glm::vec4> exact, mirrored;
    for (int i = 0; i < 160 * 80; ++i) {
        exact.push_back(comparison().preview().pixels->pixel({i % 160, i / 160}));
        mirrored.push_back(comparison().preview().pixels->pixel({159 - i % 160, i / 160}));
    }
    ui().click(in("Compare/Wipe")).frame().frame();
    const glm::ivec2 drawn = comparison().drawn_size();
    const ui::Rect area = ui().rect(in("Comparison"));
    EXPECT_NEAR(std::max(static_cast<float>(drawn.x) / area.w, static_cast<float>(drawn.y) / area.h), 1.0F, 0.01F);
    EXPECT_NEAR(static_cast<double>(drawn.x) / drawn.y, 2.0, 0.01);
    EXPECT_EQ(comparison().preview().size, glm::ivec2(160, 80)) << "counted in the video's pixels";
    ASSERT_NE(comparison().preview().pixels, nullptr) << "drawn";
    EXPECT_LT(mean_difference(exact), 0.5 * mean_difference(mirrored)) << "the same place of the organ";
    ui().click(in("Compare/Side by side")).frame().frame();
    EXPECT_LT(comparison().drawn_size().x, drawn.x) << "two share the room";
    const glm::ivec2 beside = comparison().drawn_size();
    editor().settings().half_resolution = true;
    ui().frame().frame();
    EXPECT_NEAR(comparison().drawn_size().x, beside.x / 2.0, 1.0);
    EXPECT_NE(comparison().preview().pixels, nullptr) << "drawn at that size";
}

TEST_F(ReferencePanel, ASqueezedVideoIsShownInItsAspect) {
    drop(write_clip(folder() / "square.avi", 5, {48, 48}, 10));
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(48, 48));
    ui().click(in("Aspect")).frame();
    ui().click("**/4:3").frame();
    EXPECT_NEAR(editor().document.scene().reference.aspect, 4.0 / 3, 1e-4);
    EXPECT_EQ(editor().document.steps().back().name, "Reference aspect");
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(64, 48));
    const ui::Picture shown = reference().shown().whole();
    EXPECT_EQ(shown.pixels->pixel({63, 47}).a, 255) << "the last pixel is inside";
    ui().click(in("Compare/Wipe")).frame().frame();
    EXPECT_EQ(comparison().reference().size, glm::ivec2(64, 48));
    EXPECT_NEAR(static_cast<double>(comparison().drawn_size().x) / comparison().drawn_size().y, 4.0 / 3, 0.01)
        << "and the camera sees as much more to the sides";
    editor().document.change("Aspect", [](document::Content& c) { c.scene.reference.aspect = 0.5; });
    ui().frame();
    EXPECT_EQ(ui().text(in("Aspect")), "0.5:1");
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(48, 96)) << "no pixel is lost";
    editor().document.undo();
    editor().document.undo();
    ui().frame();
    EXPECT_EQ(ui().text(in("Aspect")), "As stored");
    EXPECT_EQ(reference().shown().whole().size, glm::ivec2(48, 48));
}

TEST_F(ReferencePanel, EverythingHasANameForTheKeyboard) {
    for (const char* way : {"Reference", "Side by side", "Wipe", "Difference", "Onion"}) {
        ui().click(in(std::string("Compare/") + way)).frame();
        EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{}) << way;
    }
    reference().remove();
    ui().frame();
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

}  // namespace
}  // namespace lapfx::test
