// Preview::layers: what is in a frame, against what is known of the scene.
#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

class LayersTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 frame{160, 120};

    LayersTest() {
        preset.smoke.clips.clear();
        scene.events.clear();
    }
    static double share(const std::vector<std::uint8_t>& layer) {
        return static_cast<double>(std::count(layer.begin(), layer.end(), 255)) / static_cast<double>(layer.size());
    }
};

/// The sheet is 80 mm wide, 60 mm below a camera of 60 degrees: it leaves a margin at both sides, which is in view,
/// too.
TEST_F(LayersTest, TheViewIsThePicture) {
    const Layers layers = preview().layers(0.0, frame);
    EXPECT_EQ(share(layers.view), 1.0);
    EXPECT_EQ(share(layers.blood), 0.0);
}

TEST_F(LayersTest, ThereIsNoViewOfAnOrganThatIsNotSeen) {
    scene.camera.eye = {500.0, 0.0, 60.0};
    scene.camera.target = {500.0, 0.0, 0.0};
    const Layers layers = preview().layers(0.0, frame);
    EXPECT_EQ(share(layers.view), 0.0);
    EXPECT_EQ(amounts_of(layers).view, 0.0);
}

/// The round view is a disc of 1.12 half heights.
TEST_F(LayersTest, TheViewEndsAtTheRoundPicture) {
    test::write_obj(folder / "sheet.obj", test::plane(200.0, 60));
    EXPECT_EQ(share(preview().layers(0.0, frame).view), 1.0);
    scene.camera.vignette = 1.0;
    const Layers layers = preview().layers(0.0, frame);
    double inside = 0.0;
    for (int y = 0; y < frame.y; ++y)
        for (int x = 0; x < frame.x; ++x)
            inside += std::hypot(x + 0.5 - frame.x / 2.0, y + 0.5 - frame.y / 2.0) < 1.125 * frame.y / 2.0 ? 1 : 0;
    EXPECT_NEAR(share(layers.view), inside / (frame.x * frame.y), 0.01);
}

TEST_F(LayersTest, AnInstrumentIsNotOfTheView) {
    const Layers before = preview().layers(1.0, frame);
    scene.events = {{.action = ToolAction::cauterise,
                     .time = 0.5,
                     .duration = 3.0,
                     .position = {0, 0, 0},
                     .to = {0, 0, 0},
                     .power = 0.0,
                     .strength = 0.0}};
    scene.tool.file = "sheet.obj";  // any mesh: what is before the organ counts
    const Layers with = preview().layers(1.0, frame);
    EXPECT_LT(share(with.view), share(before.view));
}

/// A round wound of a known radius on a plane that is seen from above.
TEST_F(LayersTest, BloodIsAShareOfTheView) {
    scene.events = {{.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = {0, 0, 0}, .to = {0, 0, 0}}};
    preset.bleeding.max_extent = 12.0;
    preset.bleeding.speed = 20.0;
    const double at = 9.0;
    Preview shown = preview();
    const ShownAmounts amounts = amounts_of(shown.layers(at, frame));
    const double high = 2.0 * 60.0 * std::tan(glm::radians(30.0)), wide = high * frame.x / frame.y;
    EXPECT_NEAR(amounts.blood * wide * high, shown.amounts().blood_area, 0.1 * shown.amounts().blood_area);
    EXPECT_GT(amounts.blood, 0.034);
}

TEST_F(LayersTest, AmountsAreMeansOverTheViewAlone) {
    const Layers layers{
        .view = {255, 255, 0, 0, 255}, .blood = {255, 0, 255, 255, 0}, .veil = {0.2F, 0.4F, 1.0F, 1.0F, 0.3F}};
    const ShownAmounts amounts = amounts_of(layers);
    EXPECT_DOUBLE_EQ(amounts.blood, 1.0 / 3.0);
    EXPECT_NEAR(amounts.veil, 0.3, 1e-6);
    EXPECT_DOUBLE_EQ(amounts.view, 0.6);
    const ShownAmounts none = amounts_of({.view = {0, 0}, .blood = {255, 0}, .veil = {1.0F, 0.0F}});
    EXPECT_EQ(none.blood, 0.0);
    EXPECT_EQ(none.veil, 0.0);
}

}  // namespace
}  // namespace lapfx
