// Scopes of the compared pictures: what they count, when, and where they are shown.
#include "app/base/layouts.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "support/clips.h"
#include "ui/core/tree.h"
#include "ui/support/count_allocations.h"

namespace lapfx::test {
namespace {

class ComparedScopes : public SampleTest {
  protected:
    ComparedScopes() { begins.layout = "Compare", begins.time = 4; }
    app::Reference& reference() { return editor().reference(); }
    static std::string in(const std::string& name) { return "**/" + name; }
    void show() { ui().click("Workspace/Reference/Scopes").frame().frame(); }
    double share_of_black(const app::PictureScopes& scopes) {
        const auto levels = scopes.levels(app::Channel::luma);
        double all = 0;
        for (const std::uint32_t n : levels) all += n;
        return levels[0] / all;
    }
};

TEST_F(ComparedScopes, BothPicturesAreCountedBesideEachOther) {
    EXPECT_FALSE(ui().exists(in("Waveform of Preview")));
    show();
    for (const char* name : {"Levels of Preview", "Levels of Reference", "Waveform of Preview", "Waveform of Reference",
                             "Colours of Preview", "Colours of Reference"})
        EXPECT_TRUE(ui().exists(in(name))) << name;
    const auto& [preview_scopes, video_scopes] = reference().comparison().scopes();
    ASSERT_TRUE(preview_scopes.counted());
    ASSERT_TRUE(video_scopes.counted());
    EXPECT_GT(preview_scopes.mean(app::Channel::red), preview_scopes.mean(app::Channel::blue)) << "tissue";
    EXPECT_GT(video_scopes.mean(app::Channel::red), video_scopes.mean(app::Channel::blue));
    char mean[32];
    std::snprintf(mean, sizeof mean, "Preview, luma: mean %ld", std::lround(preview_scopes.mean(app::Channel::luma)));
    EXPECT_NE(ui().dump().find(mean), std::string::npos) << ui().dump();
    EXPECT_NE(preview_scopes.waves(), video_scopes.waves());
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
    show();
    EXPECT_FALSE(ui().exists(in("Waveform of Preview")));
}

TEST_F(ComparedScopes, TheyFollowThePictures) {
    show();
    const auto& [preview_scopes, video_scopes] = reference().comparison().scopes();
    const double preview = preview_scopes.mean(app::Channel::red);
    const double video = video_scopes.mean(app::Channel::red);
    editor().document.change("Exposure", [](document::Content& c) { c.scene.camera.exposure *= 2; });
    ui().frame().frame();
    EXPECT_GT(preview_scopes.mean(app::Channel::red), preview + 10);
    EXPECT_EQ(video_scopes.mean(app::Channel::red), video) << "its frame is the same";
    editor().timeline.seek(0);
    ui().frame().frame();
    EXPECT_NE(video_scopes.mean(app::Channel::red), video);
    editor().document.change("Vignette", [](document::Content& c) { c.scene.camera.vignette = 0; });
    ui().frame().frame();
    EXPECT_LT(share_of_black(preview_scopes), 0.05) << "no black surround any more";
}

TEST_F(ComparedScopes, OneKindAndOneChannelCanBeChosen) {
    show();
    ui().click("**/Scopes shown/Colours").frame();
    EXPECT_TRUE(ui().exists(in("Colours of Preview")));
    EXPECT_FALSE(ui().exists(in("Waveform of Preview")));
    EXPECT_FALSE(ui().exists(in("Channel"))) << "only levels are of a channel";
    ui().click("**/Scopes shown/Levels").frame();
    ui().click(in("Channel")).frame();
    ui().click("Channel choices/Choices/Green").frame();
    EXPECT_EQ(reference().comparison().scopes_look.channel, app::Channel::green);
    EXPECT_NE(ui().dump().find("Reference, green: mean"), std::string::npos) << ui().dump();
}

TEST_F(ComparedScopes, OfTheReferenceAloneThereIsOneOfEach) {
    show();
    ui().click("Workspace/Reference/Compare/Reference").frame().frame();
    EXPECT_TRUE(ui().exists(in("Waveform of Reference")));
    EXPECT_FALSE(ui().exists(in("Waveform of Preview")));
}

TEST_F(ComparedScopes, AKeyShowsThemAndThePanelFirst) {
    layout("Tune");
    ui().key('M', ui::Mods::shift).frame().frame();
    EXPECT_TRUE(editor().layouts().seen("Reference"));
    EXPECT_TRUE(ui().exists(in("Waveform of Preview")));
    ui().key('M', ui::Mods::shift).frame();
    EXPECT_FALSE(ui().exists(in("Waveform of Preview")));
}

TEST_F(ComparedScopes, AFrameInWhichNothingChangesAllocatesNoMoreThanWithoutThem) {
    const auto allocations = [&] {
        ui().settle().frame().frame();
        const std::size_t before = allocations_so_far();
        ui().frame();
        return allocations_so_far() - before;
    };
    const std::size_t without = allocations();
    show();
    EXPECT_LE(allocations(), without);
}

TEST_F(ComparedScopes, CountingPicturesOfTheSameSizeAllocatesNothing) {
    show();
    ui().settle();
    Image image{.width = 320, .height = 256, .pixels = std::vector<std::uint8_t>(320 * 256 * 4, 90), .name = ""};
    ui::ImageStore images;
    app::PictureScopes scopes(images);
    scopes.count(image);
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{40});
    const std::size_t before = allocations_so_far();
    scopes.count(image);
    EXPECT_EQ(allocations_so_far() - before, 0U);
}

TEST_F(ComparedScopes, TheyComeToRest) {
    show();
    ui().settle().frame(2).settle();
    EXPECT_GT(ui().output().wake_at, ui().time + 60);
    ui().frame(1);
    EXPECT_FALSE(ui().output().changed);
}

}  // namespace
}  // namespace lapfx::test
