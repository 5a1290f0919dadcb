// Clips in the picture: they appear at their time as lit metal, move with the organ, and are in the depth that smoke
// uses.
#include "gl/objects.h"
#include "lapfx/effects.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"

namespace lapfx {
namespace {

class ClipPictureTest : public test::SceneTest {
  protected:
    void SetUp() override {
        SceneTest::SetUp();
        if (IsSkipped()) return;
        preset.smoke.clips.clear();
        scene.camera.eye = {0.0, 30.0, 0.0};
        scene.light.focus_distance = 30.0;
        scene.events = {clip({0.0, 0.0, 0.0}, 1.0)};
    }
    static ToolContact clip(const glm::dvec3& place, double time) {
        return {.action = ToolAction::clip, .time = time, .duration = 0.2, .position = place, .to = place};
    }
    /// How far apart the darkest and the brightest of the pixels are that differ.
    static int contrast(const Image& without, const Image& with) {
        int least = 255, most = 0;
        for (std::size_t i = 1; i < with.pixels.size(); i += 4) {
            if (std::abs(with.pixels[i] - without.pixels[i]) <= 8) continue;
            least = std::min<int>(least, with.pixels[i]);
            most = std::max<int>(most, with.pixels[i]);
        }
        return most - least;
    }
};

TEST_F(ClipPictureTest, IsThereFromItsTimeOnAndGoesWithIt) {
    Preview preview(scene, preset, {});
    const Image before = preview.image(0.9, size);
    const Image there = preview.image(1.1, size);
    const int changed = test::differing(before, there, 8);
    // 9 mm by 2 mm, at 30 mm before a camera of 60 degrees: 2.08 px per mm.
    EXPECT_GT(changed, 50);
    EXPECT_LT(changed, 140);
    EXPECT_GT(contrast(before, there), 80) << "metal: a line of light, and dark flanks";
    EXPECT_EQ(test::differing(preview.image(0.9, size), before, 0), 0) << "seeking back removes it";
    EXPECT_EQ(test::differing(preview.image(11.0, size), there, 0), 0) << "it stays";
    Preview again(scene, preset, {});
    EXPECT_EQ(test::differing(again.image(1.1, size), there, 0), 0) << "the same to the last bit";
}

TEST_F(ClipPictureTest, AsManyAsThereAre) {
    for (int i = 0; i < 12; ++i) scene.events.push_back(clip({-14.0 + 2.4 * i, 0.0, i % 2 == 0 ? -7.0 : 7.0}, 2.0 + i));
    Preview preview(scene, preset, {});
    const Image none = preview.image(0.5, size);
    const int one = test::differing(none, preview.image(1.5, size), 8);
    EXPECT_GT(test::differing(none, preview.image(14.0, size), 8), 6 * one) << "they overlap a little";
    EXPECT_EQ(test::differing(none, preview.image(1.5, size), 8), one);
}

TEST_F(ClipPictureTest, MovesWithTheTissueAndHidesWhatIsBehind) {
    const Organ organ = test::plane(80.0, 60);
    Effects effects(organ, preset);
    effects.set_contacts(scene.events);
    const gl::Texture color({.size = size, .format = GL_RGBA32F}),
        depth({.size = size, .format = GL_DEPTH_COMPONENT32F});
    const gl::Framebuffer target(color, &depth);
    const View view = render::view_of(scene.camera, scene.light, size);
    const auto depths = [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        glViewport(0, 0, size.x, size.y);
        const float far = 1.0f, black[4] = {};
        glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &far);
        glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, black);
        effects.draw_organ(view);
        std::vector<float> values(static_cast<std::size_t>(size.x * size.y));
        glGetTextureImage(depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(values.size() * 4),
                          values.data());
        return values;
    };
    /// Mean column of the pixels that are nearer than the sheet, and how many they are.
    const auto raised = [&](const std::vector<float>& with, const std::vector<float>& without) {
        double sum = 0;
        int count = 0;
        for (std::size_t i = 0; i < with.size(); ++i)
            if (with[i] < without[i] - 1e-6f) sum += static_cast<double>(i % size.x), ++count;
        return std::pair(count > 0 ? sum / count : 0.0, count);
    };
    effects.seek(0.5);
    const std::vector<float> bare = depths();
    effects.seek(1.5);
    const auto [column, pixels] = raised(depths(), bare);
    EXPECT_NEAR(column, 48, 2);
    EXPECT_GT(pixels, 25);
    // The sheet slides by 8 mm: 16.6 px.
    std::vector<glm::vec3> moved = organ.positions;
    for (glm::vec3& p : moved) p.x += 8.0f;
    effects.set_shape(moved);
    const auto [now, as_many] = raised(depths(), bare);
    EXPECT_NEAR(now, column + 16.6, 2);
    EXPECT_NEAR(as_many, pixels, 12);
}

}  // namespace
}  // namespace lapfx
