// The reference lies translucent over the view, so that the camera can be placed by it.
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "support/clips.h"
#include "ui/core/tree.h"

namespace lapfx::test {
namespace {

constexpr const char* underlay = "Workspace/View/Reference picture";

class UnderlayTest : public SampleTest {
  protected:
    UnderlayTest() { begins.layout = "Tune"; }
    const ui::StoredImage& shown() { return *ui().images().find(editor().reference().shown().whole().image); }
};

TEST_F(UnderlayTest, ItIsAsHighAsTheViewAndInItsMiddle) {
    EXPECT_FALSE(ui().exists(underlay));
    ui().click("Workspace/View/More...").frame().click("View tools/Underlay").frame().frame();
    ASSERT_TRUE(ui().exists(underlay)) << ui().dump();
    const ui::Rect view = ui().rect("Workspace/View/Preview"), under = ui().rect(underlay);
    EXPECT_NEAR(under.h, view.h, 1);
    EXPECT_NEAR(under.w, view.h * 640 / 512, 1) << "in the video's aspect";
    EXPECT_NEAR(under.x + under.w / 2, view.x + view.w / 2, 1);
    editor().document.change("Aspect", [](document::Content& c) { c.scene.reference.aspect = 1; });
    ui().frame().frame();
    EXPECT_NEAR(ui().rect(underlay).w, view.h, 1);
    ui().key(ui::Key::escape).frame();  // the list of tools
    ui().key('U').frame();
    EXPECT_FALSE(ui().exists(underlay)) << "the key ends it";
}

TEST_F(UnderlayTest, ItFollowsTheTimelineThoughNoOtherPanelShowsIt) {
    ui().key('U').frame().frame();
    const std::vector<std::uint8_t> before = shown().pixels;
    editor().timeline.seek(4);
    ui().frame().frame();
    EXPECT_NE(shown().pixels, before);
}

TEST_F(UnderlayTest, TheCameraIsPlacedThroughIt) {
    editor().looking.endoscope = false;
    ui().key('U').frame();
    ASSERT_TRUE(ui().exists(underlay));
    const glm::dvec3 eye = editor().looking.camera.eye;
    ui().drag("Workspace/View/Preview", {80, 0});
    EXPECT_NE(editor().looking.camera.eye, eye) << "it does not lie in the way of the pointer";
}

TEST_F(UnderlayTest, ItsShareIsSet) {
    EXPECT_FALSE(ui().exists("**/Underlay share"));
    ui().key('U').frame();
    ui().click("**/Underlay share", {.clicks = 2}).type("20").key(ui::Key::enter).frame();
    EXPECT_NEAR(editor().looking.underlay_share, 0.2, 1e-9);
    EXPECT_EQ(ui::faults_of(ui().ui().tree()), std::vector<std::string>{});
}

TEST_F(UnderlayTest, WithoutAReferenceThereIsNone) {
    editor().looking.underlay = true;
    editor().reference().remove();
    ui().frame().frame();
    EXPECT_FALSE(ui().exists(underlay));
    EXPECT_TRUE(ui().is("Workspace/View/Underlay", ui::Is::disabled));
}

}  // namespace
}  // namespace lapfx::test
