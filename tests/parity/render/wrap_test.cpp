// What a texture shows beyond its edges, drawn: as a larger texture that holds it.
#include "gl/objects.h"
#include "lapfx/effects.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "support/tissue.h"

namespace lapfx {
namespace {

using namespace test;

constexpr double side = 80.0;
constexpr int texels = 64;

int inside(int i, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(i, 0, texels - 1);
    const int period = wrap == Wrap::mirror ? 2 * texels : texels, within = (i + 2 * period) % period;
    return within < texels ? within : period - 1 - within;
}

/// Shows within 0..1 what `image` shows within -0.5..1.5.
Image baked(const Image& image) {
    Image out{.width = 2 * texels, .height = 2 * texels, .pixels = {}, .name = "baked"};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int from = inside(y - texels / 2, image.wrap_v) * texels + inside(x - texels / 2, image.wrap_u);
            const auto first = image.pixels.begin() + 4 * from;
            out.pixels.insert(out.pixels.end(), first, first + 4);
        }
    return out;
}

class WrapTest : public SceneTest {
  protected:
    static constexpr glm::ivec2 extent{160, 160};

    void SetUp() override {
        SceneTest::SetUp();
        if (IsSkipped()) return;
        preset.smoke.clips.clear();
        color = gl::Texture({.size = extent, .format = GL_RGBA32F});
        depth = gl::Texture({.size = extent, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
        target = gl::Framebuffer(color, &depth);
    }

    std::vector<glm::vec4> draw(const Organ& organ, Overlay overlay) const {
        constexpr float black[4] = {}, far = 1.0f;
        Effects effects(organ, preset);
        effects.set_overlay(overlay);
        glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &far);
        glViewport(0, 0, extent.x, extent.y);
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        effects.draw_organ(render::view_of(scene.camera, scene.light, extent));
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)),
                          pixels.data());
        return pixels;
    }

    gl::Texture color, depth;
    gl::Framebuffer target;
};

TEST_F(WrapTest, IsDrawnAsATextureThatHoldsIt) {
    const auto paint = [](double x, double z) { return x + 0.7 * z < -20.0 ? fat_tissue : z > 18.0 ? artery : serosa; };
    for (const Overlay overlay : {Overlay::none, Overlay::fat})
        for (const auto& [u, v] : {std::pair(Wrap::repeat, Wrap::repeat), std::pair(Wrap::clamp, Wrap::repeat),
                                   std::pair(Wrap::mirror, Wrap::clamp), std::pair(Wrap::mirror, Wrap::mirror)}) {
            Image image = painted(texels, texels, side, paint);
            image.wrap_u = u;
            image.wrap_v = v;
            Organ organ = textured_plane(side, image);
            for (glm::vec2& uv : organ.uvs) uv = uv * 2.0f - 0.5f;
            const std::vector<glm::vec4> wanted = draw(textured_plane(side, baked(image)), overlay),
                                         found = draw(organ, overlay);
            float largest = 0.0f, apart = 0.0f;
            for (std::size_t i = 0; i < found.size(); ++i)
                for (int c = 0; c < 3; ++c) {
                    largest = std::max(largest, std::abs(found[i][c] - wanted[i][c]));
                    apart = std::max(apart, std::abs(found[i][c] - found[0][c]));
                }
            // Densities near a clamped edge are means over other texels here and there.
            EXPECT_LT(largest, overlay == Overlay::none ? 1e-3f : 0.08f) << static_cast<int>(u) << static_cast<int>(v);
            EXPECT_GT(apart, 0.1f) << "the texture is seen";
        }
}

}  // namespace
}  // namespace lapfx
