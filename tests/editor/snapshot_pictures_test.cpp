// Snapshots as pictures: a thumbnail of each, and each one beside the preview, the reference or another one.
#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshot_previews.h"
#include "app/tuning/snapshots.h"
#include "editor/support/editor_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

using app::CompareSide;

constexpr std::size_t A = 0, B = 1;

class SnapshotPictures : public SampleTest {
  protected:
    SnapshotPictures() { begins.layout = "Compare", begins.time = 6; }
    app::Reference& reference() { return editor().reference(); }
    app::ReferenceComparison& comparison() { return reference().comparison(); }
    app::SnapshotPreviews& previews() { return editor().snapshot_previews(); }
    static std::string in(const std::string& name) { return "Workspace/Reference/" + name; }
    void set_speed(double speed) {
        editor().document.change("Speed", [&](document::Content& c) { c.preset.bleeding.speed = speed; });
        ui().frame().frame();
    }
    void keep(std::size_t slot) {
        editor().snapshots().keep(slot);
        ui().frame().frame();
    }
    const ui::StoredImage* thumbnail(std::size_t slot) { return ui().images().find(previews().thumbnail(slot)); }
    /// Pixels in which the two differ.
    int differing(const ui::Picture& a, const ui::Picture& b) {
        int count = 0;
        for (int y = 0; y < a.size.y; ++y)
            for (int x = 0; x < a.size.x; ++x)
                count += glm::distance(a.pixels->pixel({x, y}), b.pixels->pixel({x, y})) > 24 ? 1 : 0;
        return count;
    }
};

TEST_F(SnapshotPictures, WhatIsKeptHasAPictureOfThatMoment) {
    EXPECT_FALSE(ui().exists("**/Picture of A"));
    keep(A);
    ASSERT_TRUE(ui().exists("**/Picture of A"));
    ASSERT_NE(thumbnail(A), nullptr);
    EXPECT_EQ(thumbnail(A)->size, app::SnapshotPreviews::thumbnail_size);
    EXPECT_EQ(ui().text("**/Picture of A"), "through the endoscope, at 6.00 s of the scene");
    const std::vector<std::uint8_t> slow = thumbnail(A)->pixels;
    set_speed(25);
    keep(B);
    ASSERT_NE(thumbnail(B), nullptr);
    EXPECT_NE(thumbnail(B)->pixels, slow) << "more blood";
    EXPECT_EQ(thumbnail(A)->pixels, slow) << "A stays as it was kept";
    ui().click("**/Clear B").frame();
    EXPECT_FALSE(ui().exists("**/Picture of B"));
    EXPECT_EQ(previews().thumbnail(B), 0U);
}

TEST_F(SnapshotPictures, WhatIsKeptWhileOneClipPlaysAloneIsPicturedWhole) {
    keep(A);
    ASSERT_NE(thumbnail(A), nullptr);
    editor().clips().play_alone(0);
    ui().frame().frame();
    keep(B);  // the same preset at the same moment
    for (int i = 0; i < 4; ++i) ui().frame();
    ASSERT_NE(thumbnail(B), nullptr);
    EXPECT_EQ(thumbnail(B)->pixels, thumbnail(A)->pixels);
}

/// Snapshots of an editor that was ended come back with it.
TEST_F(SnapshotPictures, ThoseThatComeFromAFileGetTheirPictures) {
    set_speed(25);
    keep(A);
    ASSERT_NE(thumbnail(A), nullptr);
    const std::vector<std::uint8_t> before = thumbnail(A)->pixels;
    const auto kept = editor().snapshots().kept();
    editor().document.undo();
    editor().snapshots().restore(kept);
    EXPECT_EQ(previews().thumbnail(A), 0U);
    for (int i = 0; i < 4; ++i) ui().frame();
    ASSERT_NE(thumbnail(A), nullptr);
    EXPECT_EQ(thumbnail(A)->pixels, before) << "the same preset, camera and time";
    ui().frame();
    EXPECT_EQ(previews().at(A), nullptr) << "its preview goes when the picture is made";
}

TEST_F(SnapshotPictures, ASnapshotLiesBesideThePreview) {
    keep(A);
    set_speed(25);
    ui().click(in("Second picture")).frame();
    ui().click("**/Snapshot A").frame();
    for (int i = 0; i < 4; ++i) ui().frame();
    EXPECT_EQ(comparison().sides, (std::array{CompareSide::preview, CompareSide::a}));
    const ui::Picture now = comparison().picture(CompareSide::preview), a = comparison().picture(CompareSide::a);
    ASSERT_NE(now.pixels, nullptr);
    ASSERT_NE(a.pixels, nullptr);
    EXPECT_EQ(a.size, now.size);
    EXPECT_GT(differing(a, now), 50) << "it has less blood";
    editor().document.undo();  // the speed
    ui().frame().frame();
    EXPECT_EQ(differing(comparison().picture(CompareSide::a), comparison().picture(CompareSide::preview)), 0)
        << "the same preset gives the same pixels";
}

TEST_F(SnapshotPictures, ItFollowsTimeAndScene) {
    keep(A);
    comparison().sides = {CompareSide::a, CompareSide::preview};
    for (int i = 0; i < 4; ++i) ui().frame();
    const auto same = [&] {
        return differing(comparison().picture(CompareSide::a), comparison().picture(CompareSide::preview)) == 0;
    };
    EXPECT_TRUE(same());
    editor().timeline.seek(9);
    ui().frame().frame();
    EXPECT_TRUE(same());
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 1.5; });
    ui().frame().frame();
    EXPECT_TRUE(same());
    editor().document.change("Organ's colour", [](document::Content& c) { c.scene.organ.color = {0.5, 0.8, 0.7}; });
    ui().frame().frame();
    EXPECT_TRUE(same());
}

TEST_F(SnapshotPictures, TwoSnapshotsOrOneAndTheReference) {
    keep(A);
    set_speed(25);
    keep(B);
    ui().click("**/Compare/A").frame();
    ui().click("**/Against/B").frame();
    ui().click("**/Pictures").frame();
    for (int i = 0; i < 4; ++i) ui().frame();
    EXPECT_EQ(comparison().sides, (std::array{CompareSide::a, CompareSide::b}));
    EXPECT_GT(differing(comparison().picture(CompareSide::a), comparison().picture(CompareSide::b)), 50);
    editor().commands.run("snapshot.compare_b");
    for (int i = 0; i < 4; ++i) ui().frame();
    EXPECT_EQ(comparison().sides, (std::array{CompareSide::b, CompareSide::reference}));
    EXPECT_NE(comparison().picture(CompareSide::b).pixels, nullptr);
    EXPECT_EQ(previews().at(A), nullptr) << "nobody looks at it any more";
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(SnapshotPictures, WhatIsOnTheOtherSideChangesPlaces) {
    ui().click(in("First picture")).frame();
    ui().click("First picture choices/Choices/Reference").frame();
    EXPECT_EQ(comparison().sides, (std::array{CompareSide::reference, CompareSide::preview}));
}

TEST_F(SnapshotPictures, AnEmptySlotSaysHowItIsFilled) {
    comparison().put(0, CompareSide::d);
    ui().frame();
    EXPECT_NE(ui().dump().find("Snapshot D is empty"), std::string::npos) << ui().dump();
    EXPECT_FALSE(ui().exists(in("Comparison")));
    ui().key('D', ui::Mods::shift).frame().frame();
    EXPECT_TRUE(ui().exists(in("Comparison")));
}

TEST_F(SnapshotPictures, NoReferenceIsNeeded) {
    reference().remove();
    keep(A);
    set_speed(25);
    EXPECT_FALSE(ui().exists(in("Comparison")));
    ui().click("**/Preview next to snapshot A").frame();
    for (int i = 0; i < 4; ++i) ui().frame();
    ASSERT_TRUE(ui().exists(in("Comparison"))) << ui().dump();
    EXPECT_EQ(comparison().picture(CompareSide::a).size, glm::ivec2(1280, 1024));
    EXPECT_FALSE(ui().exists(in("Offset"))) << "there is no video to align";
    ui().click(in("Second picture")).frame();
    ui().click("Second picture choices/Choices/Reference").frame();
    EXPECT_TRUE(ui().exists(in("Sample reference"))) << "what to do is said again";
}

TEST_F(SnapshotPictures, APanelThatIsLeftLetsThePreviewsGo) {
    keep(A);
    comparison().sides = {CompareSide::a, CompareSide::preview};
    for (int i = 0; i < 4; ++i) ui().frame();
    EXPECT_NE(previews().at(A), nullptr);
    EXPECT_GT(previews().memory(), 0U);
    layout("Tune");
    ui().frame();
    EXPECT_EQ(previews().at(A), nullptr);
}

TEST_F(SnapshotPictures, ScopesAreOfThePicturesThatAreCompared) {
    keep(A);
    set_speed(25);
    comparison().sides = {CompareSide::a, CompareSide::preview};
    comparison().scopes_look.on = true;
    for (int i = 0; i < 5; ++i) ui().frame();
    const auto& [a, now] = comparison().scopes();
    EXPECT_NE(a.mean(app::Channel::green), now.mean(app::Channel::green));
    EXPECT_TRUE(ui().exists("**/Waveform of Snapshot A"));
}

TEST_F(SnapshotPictures, TheyComeToRest) {
    keep(A);
    set_speed(25);
    keep(B);
    comparison().sides = {CompareSide::a, CompareSide::b};
    for (int i = 0; i < 5; ++i) ui().frame();
    ui().settle().frame(2).settle();
    EXPECT_GT(ui().output().wake_at, ui().time + 60);
    ui().frame(1);
    EXPECT_FALSE(ui().output().changed);
}

}  // namespace
}  // namespace lapfx::test
