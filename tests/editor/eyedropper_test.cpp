// The eyedropper takes a colour of the preset or the scene from the view or from the reference.
#include "app/preview/pick_color.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"

namespace lapfx::test {
namespace {

class EyedropperTest : public EditorTest {
  protected:
    EyedropperTest() { whole_sample = true; }  // it takes colours of single pixels
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        open_sample();
        editor().timeline.seek(6);
    }
    /// Starts the eyedropper from the picker of blood's deep colour.
    void begin() {
        layout("Compare");
        ui().click("**/Deep colour/Colour").frame();
        ui().click("**/Pick from a picture").frame();
    }
    glm::ivec3 deep() { return glm::ivec3(glm::round(255.0 * editor().document.preset().bleeding.color_deep)); }
    static glm::ivec3 codes(ui::Color c) { return {c.r, c.g, c.b}; }
};

class Halves : public ui::PickSource {
  public:
    glm::vec4 pixel(glm::ivec2 at) const override { return at.x < 3 ? glm::vec4(0, 0, 0, 255) : glm::vec4(255); }
};

TEST(PickedColor, IsAMeanOfLightOverFivePixels) {
    const Halves halves;
    EXPECT_EQ(app::color_around(halves, {20, 20}, {0, 5}), (ui::Color{0, 0, 0, 255}));
    EXPECT_EQ(app::color_around(halves, {20, 20}, {10, 5}), (ui::Color{255, 255, 255, 255}));
    // Pixels 0 to 4: three black, two white. 40 % of the light is the code value 170, not 102.
    EXPECT_NEAR(app::color_around(halves, {20, 20}, {2, 5}).r, 170, 1);
    EXPECT_NEAR(app::color_around(halves, {4, 20}, {3, 5}).r, 156, 1) << "of what is inside: one of three";
}

TEST_F(EyedropperTest, AColourComesFromTheReference) {
    editor().reference().way = app::CompareWay::reference;
    begin();
    ASSERT_NE(editor().eyedropper.wanted_by, 0U);
    EXPECT_TRUE(ui().exists("Workspace/Reference/Pick a colour/Leave"));
    const std::size_t steps = editor().document.done();
    const ui::Picture video = editor().reference().picture();
    ui().click("Workspace/Reference/Video").frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    EXPECT_EQ(editor().document.done(), steps + 1) << "one step";
    EXPECT_EQ(editor().document.steps().back().name, "Bleeding: Deep colour");
    const glm::ivec3 there = codes(app::color_around(*video.pixels, video.size, video.size / 2));
    EXPECT_LE(glm::length(glm::dvec3(deep() - there)), 6.0) << "the middle of the picture";
    EXPECT_FALSE(ui().exists("**/Leave"));
    editor().document.undo();
    EXPECT_GT(glm::length(glm::dvec3(deep() - there)), 20.0);
}

TEST_F(EyedropperTest, OrFromWhicheverOfBothIsUnderThePointer) {
    editor().reference().way = app::CompareWay::wipe;
    begin();
    ui().frame().frame();
    const ui::Picture preview = editor().reference().compared_preview();
    const ui::Picture video = editor().reference().compared_reference();
    ASSERT_NE(preview.pixels, nullptr);
    const double line = editor().reference().compare.position;
    ui().click("Workspace/Reference/Comparison", {.at = {0.4F, 0.5F}}).frame();
    const glm::ivec3 first = deep();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    begin();
    ui().click("Workspace/Reference/Comparison", {.at = {0.6F, 0.5F}}).frame();
    const glm::ivec3 second = deep();
    EXPECT_NE(first, second);
    EXPECT_EQ(editor().reference().compare.position, line) << "the line stays";
    const auto nearest = [](const ui::Picture& picture, const glm::ivec3& color) {
        double least = 1e9;
        const int y = picture.size.y / 2;
        for (int x = 0; x < picture.size.x; ++x)
            least = std::min(
                least,
                glm::length(glm::dvec3(codes(app::color_around(*picture.pixels, picture.size, {x, y})) - color)));
        return least;
    };
    EXPECT_LT(nearest(preview, first), 8.0);
    EXPECT_LT(nearest(video, second), 8.0);
}

TEST_F(EyedropperTest, OrFromTheView) {
    layout("Tune");
    const Image image = editor().preview.read();
    ui().click("**/Deep colour/Colour").frame();
    ui().click("**/Pick from a picture").frame();
    editor().tool.action = ToolAction::cauterise;
    const std::size_t events = editor().document.scene().events.size();
    const std::size_t steps = editor().document.done();
    ui().click("Workspace/View/Preview", {.at = {0.5F, 0.4F}}).frame();
    EXPECT_EQ(editor().document.scene().events.size(), events) << "the tool rests meanwhile";
    EXPECT_EQ(editor().document.done(), steps + 1);
    const app::ImagePixels pixels(image);
    const glm::ivec2 size(image.width, image.height);
    const ui::Color there = app::color_around(pixels, size, glm::ivec2(glm::vec2(size) * glm::vec2(0.5F, 0.4F)));
    EXPECT_LE(glm::length(glm::dvec3(deep() - codes(there))), 6.0);
}

TEST_F(EyedropperTest, EscapeLeavesItAndAFieldThatIsGoneTakesNothing) {
    begin();
    const std::size_t steps = editor().document.done();
    ui().key(ui::Key::escape).frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    ui().click("**/Comparison").frame();
    EXPECT_EQ(editor().document.done(), steps);
    begin();
    layout("Key");  // shows no preset panel
    ui().click("Workspace/View/Preview").frame().frame().frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    EXPECT_EQ(editor().document.done(), steps);
}

TEST_F(EyedropperTest, TheKeyColourIsPickedInTheKeyingPanelAlone) {
    layout("Tune");
    ui().click("Workspace/Preset/Parameters/Keying/header").frame();
    ui().click("**/Key colour/Colour").frame();
    EXPECT_TRUE(ui().exists("**/Hue"));
    EXPECT_FALSE(ui().exists("**/Pick from a picture"));
}

}  // namespace
}  // namespace lapfx::test
