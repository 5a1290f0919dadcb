// The CPU's pictures of keying equal those of the shaders, for real frames of the sample clips.
#include "lapfx/authoring/keying.h"

#include "gl/srgb.h"
#include "media/decoder.h"
#include "parity/smoke/smoke_fixture.h"
#include "smoke/plume.h"
#include "support/folders.h"

namespace lapfx::smoke {
namespace {

struct Case {
    const char* clip;
    KeyingParameters keying;
    SmokeClip window{};
};

std::vector<Case> cases() {
    const KeyingParameters green{.luma_low = 0,
                                 .luma_high = 1,
                                 .key_color = {0.1, 0.69, 0.25},
                                 .chroma_low = 12,
                                 .chroma_high = 80,
                                 .spill = 0.8,
                                 .noise_strength = 0};
    KeyingParameters luma{.luma_low = 20, .luma_high = 180, .noise_strength = 0};
    KeyingParameters edges = luma;
    edges.choke = 2.5, edges.feather = 1.5;
    // The fade reaches the middle of the view, which is compared; the masks lie there.
    SmokeClip faded;
    faded.crop = {.left = 0.04, .top = 0.03, .right = 0.05, .bottom = 0.02};
    faded.edge_fade = 0.3;
    faded.source_y = 0.5;
    faded.masks = {{.x = 0.3, .y = 0.3, .width = 0.04, .height = 0.06},
                   {.x = 0.62, .y = 0.55, .width = 0.1, .height = 0.03}};
    return {{"plume_thick.mp4", luma},         {"plume_thick.mp4", luma, faded},
            {"plume_thick.mp4", edges, faded}, {"plume_green_alpha.mp4", edges, faded},
            {"wisps_thin.mp4", edges},         {"plume_green.mp4", green},
            {"plume_green_alpha.mp4", luma}};
}

/// A frame of a clip in textures as ClipSet makes them.
struct Uploaded {
    explicit Uploaded(media::Decoder& decoder, int frame) : format(decoder.format()), matrix(decoder.info().color) {
        media::Picture picture;
        EXPECT_TRUE(decoder.read(frame, picture));
        const std::uint8_t* bytes = picture.bytes.data();
        send(0, format.size, GL_R8, GL_RED, bytes);
        send(1, format.chroma_size(), GL_RG8, GL_RG, bytes + format.color_bytes());
        if (format.alpha) send(2, format.size, GL_R8, GL_RED, bytes + format.color_bytes() + format.chroma_bytes());
    }
    void send(int plane, glm::ivec2 size, GLenum internal, GLenum external, const std::uint8_t* bytes) {
        textures[plane] = gl::Texture({.size = size, .format = internal, .layers = 1});
        textures[plane].upload(external, bytes, 0);
    }
    media::ClipFrame frame() const {
        return {.format = format,
                .color = textures[0].name(),
                .chroma = textures[1].name(),
                .alpha = textures[2].name(),
                .layer = 0,
                .matrix = &matrix};
    }
    media::PictureFormat format;
    media::ColorMatrix matrix;
    gl::Texture textures[3];
};

constexpr int number = 40;  // of the frame that is looked at

class KeyingPictureParity : public SmokeGpuTest {
  protected:
    /// A plume that fills the view at the focus distance, in front of nothing. Around the middle neither its border nor
    /// the lamp's light fades. Only the middle part is drawn, which is what is compared.
    std::vector<glm::vec4> drawn(const Case& tested, const Uploaded& clip, int part) {
        const float tall = 2.0f * focus * std::tan(glm::radians(30.0f));
        const float wide = tall * static_cast<float>(size.x) / static_cast<float>(size.y);
        const auto filling =
            plume_corners({.anchor = {0.0f, 0.0f, -focus}, .extent = {wide, tall}, .source = {0.5f, 0.5f}});
        SmokeGpu gpu(SmokeResolution::screen, false);
        const glm::ivec2 from = size / 2 - size / part / 2 - 1, extent = size / part + 2;
        glEnable(GL_SCISSOR_TEST);
        glScissor(from.x, from.y, extent.x, extent.y);
        const std::vector<glm::vec4> pixels = draw(gpu, [&] {
            gpu.standing(ClipRole::plume,
                         {.frame = clip.frame(), .keying = &tested.keying, .clip = &tested.window, .density = 1.0},
                         filling, glm::vec4(0.0f, 0.0f, 1.0f, 1.0f));
        });
        glDisable(GL_SCISSOR_TEST);
        return pixels;
    }

    struct Difference {
        double worst = 0.0, mean = 0.0;
    };
    /// Prepares the middle part of the view for composite_picture().
    Difference difference(const std::vector<glm::vec4>& pixels, const KeyingFrame& frame, const KeyingLook& look,
                          const std::vector<float>& opacity, int part) const {
        Difference found;
        int count = 0;
        const glm::ivec2 from = size / 2 - size / part / 2, to = size / 2 + size / part / 2;
        for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x, ++count) {
                const float thickness = -std::log(std::max(1.0f - opacity[index({x, y})], 0.002f));
                const glm::vec3 transmission = glm::exp(-thickness * glm::vec3(look.extinction));
                const glm::vec3 light = gl::to_linear(glm::vec3(look.color)) * smoke_light(frame, look, {x, y});
                const glm::vec3 wanted = glm::vec3(background) * transmission + light * (1.0f - transmission);
                const glm::vec3 error = glm::abs(glm::vec3(pixels[index({x, size.y - 1 - y})]) - wanted);
                const double most = std::max({error.r, error.g, error.b});
                found.worst = std::max(found.worst, most), found.mean += most;
            }
        found.mean /= std::max(count, 1);
        EXPECT_GT(count, 500);
        return found;
    }
};

TEST_F(KeyingPictureParity, CompositeIsThePlumeAsDrawn) {
    for (const Case& tested : cases()) {
        const std::filesystem::path path = test::source_folder() / "samples" / "clips" / tested.clip;
        media::Decoder decoder(path, media::Layout::planar);
        const Uploaded clip(decoder, number);
        set_size(clip.format.size);
        set_depth([](glm::ivec2) { return 4000.0f; });

        KeyingReader reader(path);
        KeyingFrame frame;
        ASSERT_TRUE(reader.read(number, frame));
        ASSERT_EQ(frame.size, size);
        std::vector<float> opacity;
        keyed_opacity(frame, tested.keying, tested.window, opacity);
        EXPECT_GT(*std::max_element(opacity.begin(), opacity.end()), 0.3f) << tested.clip << " has smoke";

        KeyingLook look{.keying = tested.keying, .color = {0.0, 0.0, 0.0}, .extinction = plume.extinction};
        plume.color = look.color;  // black: only the opacity is seen
        const Difference opaque = difference(drawn(tested, clip, 2), frame, look, opacity, 2);
        EXPECT_LT(opaque.worst, 1.2e-2) << tested.clip;
        EXPECT_LT(opaque.mean, 1e-3) << tested.clip;
        plume.color = look.color = {0.8, 0.7, 0.6};
        const Difference lit = difference(drawn(tested, clip, 8), frame, look, opacity, 8);
        EXPECT_LT(lit.worst, 1.5e-2) << tested.clip;
        EXPECT_LT(lit.mean, 5e-3) << tested.clip;
    }
}

}  // namespace
}  // namespace lapfx::smoke
