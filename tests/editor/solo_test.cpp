// One clip of the preset is shown alone: in the preview only, told where it is seen, and ended with one press.
#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "editor/support/editor_test.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

class SoloTest : public SampleTest {
  protected:
    SoloTest() { begins.layout = "Tune"; }
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        ui().click("Workspace/tabs/Clips").frame();
        ASSERT_GE(clips().size(), 2U);
    }
    const std::vector<SmokeClip>& clips() { return editor().document.preset().smoke.clips; }
    app::ClipShelf& shelf() { return editor().clips(); }
    std::string item(std::size_t number) {
        return "Workspace/Clips/List/" + std::to_string(number + 1) + " " +
               std::filesystem::path(clips()[number].file).filename().string() + "/Solo";
    }
};

TEST_F(SoloTest, OnlyThatClipIsSeenAndTheDocumentKnowsNothingOfIt) {
    const Image all = picture(6);
    const std::string preset = write_preset(editor().document.preset());
    const std::size_t steps = editor().document.done();
    ui().click(item(0)).frame().frame();
    EXPECT_EQ(shelf().alone(), 0U);
    EXPECT_TRUE(ui().is(item(0), ui::Is::checked));
    const Image first = picture(6);
    EXPECT_GT(differing(all, first), 200U);
    EXPECT_EQ(write_preset(editor().document.preset()), preset);
    EXPECT_EQ(editor().document.done(), steps);
    EXPECT_FALSE(editor().document.unsaved());
    ui().click(item(1)).frame().frame();
    EXPECT_EQ(shelf().alone(), 1U) << "another one takes its place";
    EXPECT_GT(differing(first, picture(6)), 200U);
    ui().click(item(1)).frame().frame();
    EXPECT_FALSE(shelf().alone().has_value());
    EXPECT_EQ(differing(all, picture(6), 0), 0U) << "as before, to the last bit";
}

TEST_F(SoloTest, ItIsToldAndEndedInTheView) {
    EXPECT_FALSE(ui().exists("**/Show all clips"));
    ui().click(item(1)).frame();
    const std::string file = std::filesystem::path(clips()[1].file).filename().string();
    EXPECT_NE(ui().dump().find("Only " + file + " is shown"), std::string::npos) << ui().dump();
    EXPECT_NE(ui().dump().find("Solo: " + file), std::string::npos) << "in the status bar too, for other layouts";
    ui().click("**/Show all clips").frame();
    EXPECT_FALSE(shelf().alone().has_value());
    EXPECT_EQ(ui().dump().find("Solo: "), std::string::npos);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(SoloTest, AKeyTogglesItForTheSelectedClip) {
    shelf().selected = 1;
    ui().frame().key('S', ui::Mods::shift).frame();
    EXPECT_EQ(shelf().alone(), 1U);
    shelf().selected = 0;
    ui().frame().key('S', ui::Mods::shift).frame();
    EXPECT_FALSE(shelf().alone().has_value()) << "it ends whatever is selected";
}

TEST_F(SoloTest, OtherValuesAreTunedMeanwhile) {
    ui().click(item(0)).frame();
    const Image before = picture(6);
    editor().document.change("Speed", [](document::Content& c) { c.preset.bleeding.speed = 25; });
    ui().frame();
    EXPECT_GT(differing(before, picture(6)), 200U);
    EXPECT_EQ(shelf().alone(), 0U);
}

TEST_F(SoloTest, ItStaysWithItsClipAndEndsWithIt) {
    const std::string file = clips()[1].file;
    ui().click(item(1)).frame();
    shelf().selected = 1;
    editor().commands.run("clip.up");
    ui().frame();
    EXPECT_EQ(shelf().alone(), 0U);
    ASSERT_EQ(clips()[0].file, file);
    shelf().selected = 0;
    editor().commands.run("clip.remove");
    ui().frame();
    EXPECT_FALSE(shelf().alone().has_value());
    editor().document.undo();
    ui().frame();
    EXPECT_FALSE(shelf().alone().has_value()) << "undo brings the clip back, not what was looked at";
}

TEST_F(SoloTest, AnotherDocumentIsShownWhole) {
    ui().click(item(0)).frame();
    editor().forget_document();
    ui().frame();
    EXPECT_FALSE(shelf().alone().has_value());
}

}  // namespace
}  // namespace lapfx::test
