// Specks of fat on a GL context: where, how large, how bright, behind what.
#include "lapfx/effects.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "render/view_block.h"
#include "smoke/particles_cpu.h"
#include "smoke/particles_gpu.h"
#include "support/tissue.h"

namespace lapfx::smoke {
namespace {

class SpecksOnGpu : public test::GpuTest {
  protected:
    static constexpr glm::ivec2 extent{160, 120};
    static constexpr glm::vec3 fat_color{0.86f, 0.72f, 0.45f};

    /// Camera at z = 100 mm, looking at the origin; a pixel is about 0.5 mm there.
    const View view = render::view_of({.eye = {0, 0, 100}, .target = {0, 0, 0}, .up = {0, 1, 0}}, SceneLight{}, extent);

    using Pixels = std::vector<glm::vec4>;

    /// Specks over black, rows from the bottom; everything else is at `window_depth`.
    Pixels draw(const std::vector<SpeckBlock::Speck>& specks, float window_depth = 1.0f, float under = 0.0f) {
        const gl::Texture color({.size = extent, .format = GL_RGBA32F});
        const gl::Texture depth({.size = extent, .format = GL_DEPTH_COMPONENT32F});
        const gl::Framebuffer framebuffer(color, nullptr), depth_only(color, &depth);
        const float fill[4] = {under, under, under, 1.0f};
        glClearNamedFramebufferfv(depth_only.name(), GL_DEPTH, 0, &window_depth);
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, fill);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, extent.x, extent.y);
        const render::ViewBlock block;
        block.bind(view);
        ParticlesGpu gpu;
        std::copy(specks.begin(), specks.end(), gpu.specks().specks.begin());
        gpu.draw(specks.size(), fat_color, depth.name());
        Pixels pixels(static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)),
                          pixels.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glDisable(GL_BLEND);
        return pixels;
    }

    static SpeckBlock::Speck speck(glm::vec3 place, float diameter, float opacity = 1.0f, float glow = 0.0f,
                                   float shape = 0.3f) {
        return {glm::vec4(place, diameter), {opacity, glow, shape, 0.0f}};
    }

    struct Found {
        double sum = 0.0;  ///< of green
        int pixels = 0;
        glm::dvec2 middle{0.0};
    };
    static Found find(const Pixels& pixels) {
        Found found;
        for (int i = 0; i < extent.x * extent.y; ++i) {
            const auto value = static_cast<double>(pixels[static_cast<std::size_t>(i)].g);
            if (value <= 1e-6) continue;
            found.sum += value;
            ++found.pixels;
            found.middle += value * (glm::dvec2(i % extent.x, i / extent.x) + 0.5);
        }
        found.middle /= std::max(found.sum, 1e-9);
        return found;
    }
};

TEST_F(SpecksOnGpu, AreWhereTheirPlaceProjectsTo) {
    for (const glm::vec3 place : {glm::vec3(0, 0, 0), {20, -10, 5}, {-15, 12, -30}}) {
        const glm::vec4 clip = view.projection * view.view * glm::vec4(place, 1.0f);
        const glm::dvec2 expected = (0.5 + 0.5 * glm::dvec2(clip.x / clip.w, clip.y / clip.w)) * glm::dvec2(extent);
        const Found found = find(draw({speck(place, 6.0f)}));
        EXPECT_LT(glm::distance(found.middle, expected), 1.0) << place.x;
    }
}

TEST_F(SpecksOnGpu, AreAsLargeAsTheyAre) {
    const double millimetres = 2.0 * 100.0 / (static_cast<double>(view.projection[1][1]) * extent.y);  // of a pixel
    for (const float diameter : {6.0f, 12.0f, 24.0f}) {
        const double area = find(draw({speck({0, 0, 0}, diameter)})).pixels * millimetres * millimetres;
        const double disc = 0.25 * 3.14159 * static_cast<double>(diameter * diameter);
        EXPECT_GT(area, 0.4 * disc) << diameter;
        EXPECT_LT(area, 1.0 * disc) << diameter << ": its outline lies within";
    }
}

TEST_F(SpecksOnGpu, ThoseSmallerThanAPixelPaleInsteadOfFlickering) {
    // Light in proportion to their area, wherever they are between the pixels.
    const double whole = find(draw({speck({0, 0, 0}, 0.4f)})).sum;
    EXPECT_GT(whole, 0.0);
    EXPECT_NEAR(find(draw({speck({0, 0, 0}, 0.2f)})).sum, whole / 4.0, 0.01 * whole);
    for (const float offset : {0.1f, 0.2f, 0.3f, 0.4f})
        EXPECT_NEAR(find(draw({speck({offset, -offset, 0}, 0.4f)})).sum, whole, 0.35 * whole) << offset;
}

TEST_F(SpecksOnGpu, AreHiddenByWhatIsInFrontOfThem) {
    const glm::vec4 clip = view.projection * view.view * glm::vec4(0, 0, 20, 1);  // 20 mm nearer than the origin
    const float window_depth = 0.5f + 0.5f * clip.z / clip.w;
    EXPECT_EQ(find(draw({speck({0, 0, 0}, 6.0f)}, window_depth)).pixels, 0);
    EXPECT_GT(find(draw({speck({0, 0, 30}, 6.0f)}, window_depth)).pixels, 20);
}

TEST_F(SpecksOnGpu, FadeGlowAndCoverWhatIsBehind) {
    const auto middle = [&](const Pixels& pixels) {
        return pixels[static_cast<std::size_t>(extent.x * (extent.y / 2) + extent.x / 2)];
    };
    const glm::vec4 cold = middle(draw({speck({0, 0, 0}, 12.0f)}));
    EXPECT_GT(cold.r, cold.g);
    EXPECT_GT(cold.g, cold.b) << "fat is yellow";
    const glm::vec4 young = middle(draw({speck({0, 0, 0}, 12.0f, 1.0f, 1.0f)}));
    EXPECT_NEAR(young.r - cold.r, 1.5f, 1e-3f);
    EXPECT_GT(young.r - cold.r, 2.0f * (young.g - cold.g)) << "it glows orange";
    const glm::vec4 faded = middle(draw({speck({0, 0, 0}, 12.0f, 0.25f)}, 1.0f, 0.8f));
    EXPECT_NEAR(faded.r, 0.25f * cold.r + 0.75f * 0.8f, 2e-3f);
}

TEST_F(SpecksOnGpu, NoTwoLookAlike) {
    const Pixels one = draw({speck({0, 0, 0}, 24.0f, 1.0f, 0.0f, 0.1f)}),
                 other = draw({speck({0, 0, 0}, 24.0f, 1.0f, 0.0f, 0.6f)});
    int differing = 0;
    for (std::size_t i = 0; i < one.size(); ++i) differing += glm::distance(one[i], other[i]) > 0.1f ? 1 : 0;
    EXPECT_GT(differing, 30);
}

TEST_F(SpecksOnGpu, NoneAndTooManyAreNoFault) {
    EXPECT_EQ(find(draw({})).pixels, 0);
    EXPECT_GT(find(draw(std::vector(most_specks, speck({0, 0, 0}, 12.0f)))).pixels, 20);
    static_assert(most_particles <= most_specks);
}

using SpecksInScene = test::SceneTest;

TEST_F(SpecksInScene, FlyWhereFatBurnsAndOnlyThere) {
    preset.smoke.clips.clear();
    preset.smoke.haze.accumulation = 0.0;
    preset.smoke.particles = {.rate = 60.0, .size = 2.0, .speed = 60.0, .lifetime = 2.0};
    const auto drawn = [&](const Organ& shown) {
        Effects effects(shown, preset);
        effects.set_contacts(scene.events);
        effects.seek(2.0);
        const gl::Texture color({.size = size, .format = GL_RGBA16F}),
            depth({.size = size, .format = GL_DEPTH_COMPONENT32F});
        const gl::Framebuffer framebuffer(color, nullptr), depth_only(color, &depth);
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(depth_only.name(), GL_DEPTH, 0, &far);
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, size.x, size.y);
        effects.draw_smoke(render::view_of(scene.camera, scene.light, size), depth.name());
        std::vector<float> pixels(4 * static_cast<std::size_t>(size.x * size.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                          pixels.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        int lit = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4) lit += pixels[i] > 0.01f ? 1 : 0;
        return lit;
    };
    EXPECT_EQ(drawn(test::plane(80.0, 60)), 0) << "of unknown tissue nothing is fat";
    EXPECT_EQ(drawn(test::painted_plane(80.0, 60, [](double, double) { return test::serosa; })), 0);
    EXPECT_GT(drawn(test::painted_plane(80.0, 60, test::half_fat)), 30);
}

TEST_F(SpecksInScene, FatGivesMoreHazeAndSuctionTakesIt) {
    preset.smoke.plume.fat_gain = 1.5;
    const auto haze = [&](glm::dvec3 place, bool sucked) {
        Effects effects(test::painted_plane(80.0, 60, test::half_fat), preset);
        std::vector<ToolContact> contacts{
            {.action = ToolAction::cauterise, .duration = 2.0, .position = place, .to = place}};
        if (sucked) contacts.push_back({.action = ToolAction::suction, .time = 3.0, .duration = 2.0});
        effects.set_contacts(contacts);
        effects.seek(5.0);
        return effects.amounts().haze;
    };
    const double lean = haze({-20, 0, 0}, false);
    EXPECT_GT(lean, 0.1);
    EXPECT_NEAR(haze({20, 0, 0}, false), 2.5 * lean, 0.01 * lean);
    EXPECT_NEAR(haze({-20, 0, 0}, true), lean * std::exp(-2.0 * preset.smoke.haze.suction), 1e-6);
}

TEST_F(SpecksInScene, AskingForFatGoesWithThePresetAndTheOrgan) {
    preset.smoke.plume.fat_gain = 1.0;
    const glm::dvec3 place(20, 0, 0);
    Effects effects(test::painted_plane(80.0, 60, test::half_fat), preset);
    effects.set_contacts(std::vector<ToolContact>{{.duration = 2.0, .position = place, .to = place}});
    const auto haze = [&] {
        effects.seek(2.0);
        return effects.amounts().haze;
    };
    const double fat = haze();
    preset.vessels.fat_low = 100.0, preset.vessels.fat_high = 110.0;
    effects.set_preset(preset);
    EXPECT_NEAR(haze(), 0.5 * fat, 0.01 * fat) << "nothing is that yellow";
    effects.set_preset({});
    const Organ serosa = test::painted_plane(80.0, 60, [](double, double) { return test::serosa; });
    Preset plain;
    plain.smoke.clips = preset.smoke.clips;
    plain.folder = preset.folder;
    plain.smoke.plume.fat_gain = 1.0;
    effects.set_preset(plain);
    EXPECT_NEAR(haze(), fat, 0.01 * fat);
    effects.set_topology(serosa, std::vector<std::uint32_t>(serosa.positions.size(), Effects::new_vertex));
    EXPECT_NEAR(haze(), 0.5 * fat, 0.01 * fat) << "the organ is another";
}

}  // namespace
}  // namespace lapfx::smoke
