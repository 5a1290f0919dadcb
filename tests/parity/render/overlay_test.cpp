// The overlays: their colours in closed form, and that they are where the densities are.
#include <numbers>

#include "gl/objects.h"
#include "lapfx/effects.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "support/gpu_function.h"
#include "support/tissue.h"

namespace lapfx {
namespace {

using namespace test;

constexpr double side = 80.0;
constexpr glm::vec3 vessel_color(0.0f, 0.6f, 1.0f), fat_color(1.0f, 0.7f, 0.0f);
constexpr float cover = 0.8f;

float luma(glm::vec3 color) {
    return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

class OverlayTest : public SceneTest {
  protected:
    static constexpr glm::ivec2 extent{160, 160};

    void SetUp() override {
        SceneTest::SetUp();
        if (IsSkipped()) return;
        preset.smoke.clips.clear();
        preset.vessels.smoothing = 0.2;
        color = gl::Texture({.size = extent, .format = GL_RGBA32F});
        depth = gl::Texture({.size = extent, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
        target = gl::Framebuffer(color, &depth);
    }

    /// Linear light, per pixel, rows from the bottom.
    std::vector<glm::vec4> draw(Effects& effects, Overlay overlay) const {
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &far);
        glViewport(0, 0, extent.x, extent.y);
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        effects.set_overlay(overlay);
        effects.draw_organ(render::view_of(scene.camera, scene.light, extent));
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)),
                          pixels.data());
        return pixels;
    }
    /// mm of the sheet at a pixel; the camera looks straight down from 60 mm, x to the right and z down.
    glm::dvec2 place(int i) const {
        const double reach = 60.0 * std::tan(glm::radians(scene.camera.field_of_view) / 2.0);
        return glm::dvec2((i % extent.x + 0.5) / extent.x - 0.5, 0.5 - (i / extent.x + 0.5) / extent.y) * 2.0 * reach;
    }
    /// Every pixel is mix(grey, tint, cover * density) of what is drawn without; `density` at its place.
    template <class Density>
    void expect_tinted(Effects& effects, Overlay overlay, glm::vec3 tint, const Density& density) {
        const std::vector<glm::vec4> plain = draw(effects, Overlay::none), tinted = draw(effects, overlay);
        int compared = 0, covered = 0;
        for (int i = 0; i < extent.x * extent.y; ++i) {
            const float share = density(place(i));
            if (share < 0.0f) continue;  // the share is not known well enough
            const auto pixel = static_cast<std::size_t>(i);
            const glm::vec3 wanted = glm::mix(glm::vec3(luma(plain[pixel])), tint, cover * share);
            ++compared;
            covered += share > 0.5f;
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(tinted[pixel][c], wanted[c], 0.02f + 0.01f * wanted[c]) << place(i).x << ' ' << place(i).y;
        }
        EXPECT_GT(compared, extent.x * extent.y * 3 / 4);
        EXPECT_GT(covered, 500);
        EXPECT_TRUE(draw(effects, Overlay::none) == plain) << "and it goes again";
    }

    gl::Texture color, depth;
    gl::Framebuffer target;
};

TEST_F(OverlayTest, FatIsYellowAndTheRestGrey) {
    Effects effects(textured_plane(side, painted(800, 800, side, half_fat)), preset);
    expect_tinted(effects, Overlay::fat, fat_color, [](glm::dvec2 at) {
        return std::abs(at.x) < 1.5 ? -1.0f : at.x > 0.0 ? 1.0f : 0.0f;
    });
    expect_tinted(effects, Overlay::fat, fat_color,
                  [&](glm::dvec2 at) { return std::abs(at.x) < 1.5 ? -1.0f : static_cast<float>(at.x > 0.0); });
}

TEST_F(OverlayTest, VesselsAreBlueWhereTheMapHasThem) {
    const auto paint = [](double x, double) { return std::abs(x) < 2.0 ? artery : serosa; };
    preset.vessels.vessel_width = 4.0;
    Effects effects(textured_plane(side, painted(800, 800, side, paint)), preset);
    expect_tinted(effects, Overlay::vessels, vessel_color, [](glm::dvec2 at) {
        const double x = std::abs(at.x);
        return x < 1.0 ? 1.0f : x < 3.5 ? -1.0f : 0.0f;
    });
}

TEST_F(OverlayTest, VertexDensitiesAreShownToo) {
    preset.vessels.smoothing = 0.5;
    Effects effects(painted_plane(side, 100, half_fat), preset);
    expect_tinted(effects, Overlay::fat, fat_color,
                  [](glm::dvec2 at) { return std::abs(at.x) < 3.0 ? -1.0f : static_cast<float>(at.x > 0.0); });
}

TEST_F(OverlayTest, AParameterShowsInTheNextPicture) {
    Effects effects(textured_plane(side, painted(400, 400, side, half_fat)), preset);
    const std::vector<glm::vec4> before = draw(effects, Overlay::fat);
    preset.vessels.fat_low = 90.0;
    preset.vessels.fat_high = 100.0;
    effects.set_preset(preset);
    const std::vector<glm::vec4> after = draw(effects, Overlay::fat);
    EXPECT_FALSE(before == after);
    for (const glm::vec4& pixel : after) EXPECT_NEAR(pixel.r, pixel.b, 0.01f);
}

TEST_F(OverlayTest, BleedIsolinesAreWhereTheBleedValueSaysSo) {
    scene.events.resize(1);
    scene.events[0].position = scene.events[0].to = {0.0, 0.0, 0.0};
    preset.bleeding.gravity_bias = 0.0;
    Effects effects(plane(side, 80), preset);
    effects.set_contacts(scene.events);
    effects.seek(2.5);  // 10 mm from the wound on
    const std::vector<glm::vec4> pixels = draw(effects, Overlay::bleed);
    int beyond = 0, inside = 0;
    for (int i = 0; i < extent.x * extent.y; ++i) {
        const double r = glm::length(place(i));
        const glm::vec4& pixel = pixels[static_cast<std::size_t>(i)];
        const bool grey = std::abs(pixel.r - pixel.g) < 0.02f && std::abs(pixel.g - pixel.b) < 0.02f;
        if (r > 11.0 && r < 20.0) {
            EXPECT_TRUE(grey) << r;
            ++beyond;
        }
        if (r < 9.0) {
            EXPECT_FALSE(grey) << r;
            ++inside;
        }
    }
    EXPECT_GT(beyond, 500);
    EXPECT_GT(inside, 200);
}

TEST_F(OverlayTest, FalseColoursRunFromBlueToRed) {
    const std::vector<glm::vec4> inputs{{0.0f, 0, 0, 0}, {1 / 3.0f, 0, 0, 0}, {2 / 3.0f, 0, 0, 0}, {1.0f, 0, 0, 0}};
    const auto colors = GpuFunction({"overlay.glsl"}, "vec4(lapfx_false_color(a.x), 1.0)")(inputs);
    const glm::vec3 wanted[] = {{0, 0, 1}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}};
    for (std::size_t i = 0; i < 4; ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colors[i][c], wanted[i][c], 1e-5f) << i;
}

TEST_F(OverlayTest, DensityDecidesWhetherACutBleedsAndHowStrongly) {
    const auto paint = [](double x, double) { return std::abs(x) < 1.0 ? artery : serosa; };
    preset.vessels.vessel_threshold = 0.1;
    preset.vessels.vessel_strength = 0.0;
    preset.bleeding.speed = 4.0;
    Effects effects(textured_plane(side, painted(800, 800, side, paint), 40), preset);
    const auto cut = [](double x) {
        return ToolContact{
            .action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = {x, 0, 0}, .to = {x, 0, 0}};
    };
    const std::vector<ToolContact> off{cut(10.0)}, both{cut(10.0), cut(0.0)};
    effects.set_contacts(off);
    effects.seek(2.0);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 0);
    EXPECT_EQ(effects.amounts().blood_area, 0.0);
    effects.set_contacts(both);
    effects.seek(2.0);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 1);
    const double once = effects.amounts().blood_area;
    EXPECT_NEAR(once, std::numbers::pi * 7.7 * 7.7, 0.05 * once);  // 8 mm less the threshold
    const double density = effects.tissue({0.0, 1.0, 0.0}).vessels;
    EXPECT_GT(density, 0.3);
    EXPECT_LT(effects.tissue({10.0, 0.0, 0.0}).vessels, 0.01);
    preset.vessels.vessel_strength = 1.0;
    preset.vessels.vessel_reference = density / 1.5;
    effects.set_preset(preset);
    effects.seek(2.0);
    EXPECT_NEAR(effects.amounts().blood_area, std::numbers::pi * 11.7 * 11.7, 0.05 * 430.0);
    preset.vessels.vessel_threshold = 0.9;
    effects.set_preset(preset);
    effects.seek(2.0);
    EXPECT_EQ(effects.amounts().blood_area, 0.0);
}

}  // namespace
}  // namespace lapfx
