// The facade on a GL context: moving and cutting the organ, bytes sent, amounts.
#include "lapfx/effects.h"

#include <cstdlib>
#include <new>

#include "gl/objects.h"
#include "lapfx/refine.h"
#include "lapfx/scene.h"
#include "parity/allocations.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "support/meshes.h"

thread_local std::size_t lapfx::test::allocations = 0;

namespace {

void* counted(std::size_t bytes) {
    ++lapfx::test::allocations;
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}

}  // namespace

// Only in this test program: counts allocations, thread by thread.
void* operator new(std::size_t bytes) {
    return counted(bytes);
}
void* operator new[](std::size_t bytes) {
    return counted(bytes);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace lapfx {
namespace {

using test::allocations;

class EffectsTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 extent{96, 96};

    static Preset bloody() {
        Preset p;
        p.bleeding.noise_strength = 0.0;
        p.bleeding.gravity_bias = p.bleeding.crease_bias = 0.0;
        return p;
    }
    static std::vector<ToolContact> cut_at(glm::dvec3 place) {
        return {{.action = ToolAction::cut, .time = 0.0, .duration = 0.5, .position = place, .to = place}};
    }

    /// Looking straight down on 100 mm: how many pixels are red, and how wide and high the red is.
    struct Red {
        int pixels = 0, width = 0, height = 0;
    };
    Red red_of(Effects& effects) {
        const gl::Texture color({.size = extent, .format = GL_RGBA16F});
        const gl::Texture depth({.size = extent, .format = GL_DEPTH_COMPONENT32F});
        const gl::Framebuffer framebuffer(color, &depth);
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &far);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, extent.x, extent.y);
        SceneCamera camera{.eye = {0, 100, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}};
        effects.draw_organ(render::view_of(camera, SceneLight{}, extent));
        std::vector<float> pixels(4 * static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                          pixels.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glm::ivec2 low = extent, high(-1);
        Red red;
        for (int i = 0; i < extent.x * extent.y; ++i) {
            const float* p = &pixels[4 * static_cast<std::size_t>(i)];
            if (p[0] < 0.02f || p[0] < 4.0f * p[1]) continue;
            ++red.pixels;
            low = glm::min(low, glm::ivec2(i % extent.x, i / extent.x));
            high = glm::max(high, glm::ivec2(i % extent.x, i / extent.x));
        }
        red.width = high.x - low.x + 1;
        red.height = high.y - low.y + 1;
        return red;
    }
};

TEST_F(EffectsTest, AmountsCountBloodAndWounds) {
    Effects effects(test::plane(100.0, 100), bloody());
    effects.set_contacts(cut_at({0, 0, 0}));
    effects.seek(2.0);
    const Amounts now = effects.amounts();
    const double radius = 4.0 * 2.0 - 0.3;
    EXPECT_NEAR(now.blood_area, std::acos(-1.0) * radius * radius, 0.03 * now.blood_area);
    EXPECT_GT(now.blood_volume, 0.2 * now.blood_area);
    EXPECT_LT(now.blood_volume, 0.6 * now.blood_area);
    EXPECT_EQ(now.wounds, 1);
    EXPECT_EQ(now.bleeding_wounds, 1);
    ASSERT_EQ(effects.wounds().size(), 1u);
    EXPECT_EQ(effects.wounds()[0].state, WoundState::bleeding);
    effects.seek(60.0);
    EXPECT_EQ(effects.amounts().bleeding_wounds, 0);
    EXPECT_EQ(effects.wounds()[0].state, WoundState::spent);
}

TEST_F(EffectsTest, OnlyWhatChangesIsSentAndASettledSceneSendsAndAllocatesNothing) {
    Effects effects(test::plane(400.0, 400), bloody());
    effects.set_contacts(cut_at({0, 0, 0}));
    effects.seek(0.0);
    effects.seek(1.0);
    EXPECT_GT(effects.uploaded(), 50u * sizeof(glm::vec2));
    EXPECT_LT(effects.uploaded(), 3000u * sizeof(glm::vec2)) << "of 160,801";
    effects.seek(50.0);
    red_of(effects);
    effects.amounts();  // whoever asks for the first time catches up with all that has changed
    allocations = 0;
    for (double time = 51.0; time < 60.0; time += 0.1) {
        effects.seek(time);
        EXPECT_EQ(effects.uploaded(), 0u);
        effects.amounts();
    }
    EXPECT_EQ(allocations, 0u);
}

TEST_F(EffectsTest, SmokeAllocatesNothingOnceItHasBeenDrawn) {
    preset.smoke.clips[0].crossfade = preset.smoke.clips[1].crossfade = 0.2;
    const gl::Texture color({.size = extent, .format = GL_RGBA16F});
    const gl::Texture depth({.size = extent, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
    const gl::Framebuffer framebuffer(color, nullptr);
    constexpr float far = 1.0f;
    const gl::Framebuffer cleared(color, &depth);
    glClearNamedFramebufferfv(cleared.name(), GL_DEPTH, 0, &far);
    const StreamingOptions ways[] = {{.resolution = SmokeResolution::screen},
                                     {.resolution = SmokeResolution::clip},
                                     {.scheme = Scheme::buffered},
                                     {.scheme = Scheme::buffered, .late = LateClips::skip}};
    for (const StreamingOptions& way : ways) {
        Effects effects(test::plane(80.0, 40), preset,
                        {.clip_folders = {}, .wait_for_clips = way.late != LateClips::skip, .streaming = way});
        effects.set_contacts(scene.events);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, extent.x, extent.y);
        const View view = render::view_of(scene.camera, scene.light, extent);
        std::size_t most = 0;
        const auto play = [&] {
            for (double time = 1.0; time < 3.4; time += 0.04) {
                effects.seek(time);
                allocations = 0;
                effects.draw_smoke(view, depth.name());
                most = std::max(most, allocations);
            }
        };
        play();
        most = 0;
        play();
        EXPECT_EQ(most, 0u);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_F(EffectsTest, AValueThatIsDraggedAllocatesNothing) {
    Effects effects(test::plane(80.0, 40), preset, {.clip_folders = {}, .wait_for_clips = true});
    effects.set_contacts(scene.events);
    effects.seek(3.0);
    for (const char* key : {"bleeding.thickness", "bleeding.gloss", "smoke.plume.density", "smoke.haze.accumulation",
                            "smoke.keying.luma_low"}) {
        const FoundParameter found = find_parameter(preset_table(), &preset, key);
        double& value = *static_cast<double*>(found.row->member(found.owner));
        for (const bool told : {false, true}) {
            std::size_t last = 1;
            for (int move = 0; move < 5; ++move) {
                value += found.row->step;
                allocations = 0;
                if (told)
                    effects.set_parameters(preset, found.row->redo | redo::smoke);
                else
                    effects.set_parameters(preset);
                last = allocations;
            }
            EXPECT_EQ(last, 0U) << key << (told ? ", told" : "");
        }
    }
}

TEST_F(EffectsTest, GravityWithoutADirectionIsRefused) {
    for (const glm::dvec3 gravity :
         {glm::dvec3(0.0), glm::dvec3(1e-200, 0.0, 0.0), glm::dvec3(0.0, std::nan(""), 0.0)}) {
        EffectsOptions options;
        options.gravity = gravity;
        try {
            Effects effects(test::plane(10.0, 4), Preset{}, options);
            ADD_FAILURE() << gravity.x;
        } catch (const Error& error) {
            EXPECT_EQ(error.failure(), Failure::bad_input);
            EXPECT_NE(std::string(error.what()).find("/gravity"), std::string::npos);
        }
    }
}

TEST_F(EffectsTest, AToolThatHoversCostsASettledSceneNothingAndLossesAreCounted) {
    Effects effects(test::plane(100.0, 100), bloody());
    effects.set_contacts(cut_at({0, 0, 0}));
    effects.seek(50.0);
    allocations = 0;
    for (int i = 0; i < 500; ++i) {
        effects.tool_queue().push({.time = 50.0 + 0.001 * i, .position = {1, 5, 1}, .touching = false});
        effects.seek(50.0 + 0.001 * i);
        EXPECT_EQ(effects.uploaded(), 0u);
    }
    EXPECT_EQ(allocations, 0u);
    EXPECT_EQ(effects.amounts().lost_samples, 0u);
    effects.tool_queue().push({.time = std::nan(""), .touching = true});
    effects.tool_queue().push({.time = 3.0, .touching = true});
    effects.seek(std::nan(""));
    EXPECT_EQ(effects.amounts().lost_samples, 2u) << "the queue is emptied whatever the host's clock says";
}

TEST_F(EffectsTest, AMovingOrganCarriesItsBloodAlong) {
    const Organ organ = test::plane(100.0, 100);
    Effects effects(organ, bloody());
    effects.set_contacts(cut_at({0, 0, 0}));
    effects.seek(3.0);
    const Red at_rest = red_of(effects);
    const double area = effects.amounts().blood_area;
    ASSERT_GT(at_rest.width, 15);
    EXPECT_NEAR(at_rest.width, at_rest.height, 1);
    std::vector<glm::vec3> moved = organ.positions;
    for (glm::vec3& p : moved) p.x *= 2.0f;  // twice as wide: twice the red
    effects.set_shape(moved);
    const Red wide = red_of(effects);
    EXPECT_NEAR(wide.width, 2 * at_rest.width, 3);
    EXPECT_NEAR(wide.height, at_rest.height, 1);
    EXPECT_EQ(effects.amounts().blood_area, area) << "areas are those of the rest shape";
    for (glm::vec3& p : moved) p.y += 20.0f;
    effects.set_shape(moved, organ.normals);
    const auto hit = effects.pick({60, 100, 0}, {0, -1, 0});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 80.0, 1e-5);
    EXPECT_NEAR(glm::distance(effects.to_rest(hit->position), {30, 0, 0}), 0.0, 1e-4);
    effects.seek(3.5);
    allocations = 0;
    effects.set_shape(moved);
    effects.set_shape(moved);
    EXPECT_EQ(allocations, 0u);
}

TEST_F(EffectsTest, ACoarseOrganMovesByTheVerticesThatItWasGivenWith) {
    const Organ organ = test::plane(100.0, 2), fine = refine(organ).organ;
    ASSERT_GT(fine.positions.size(), organ.positions.size());
    Effects effects(organ, bloody());
    effects.set_contacts(cut_at({7, 0, 12}));
    effects.seek(3.0);
    const Red at_rest = red_of(effects);
    ASSERT_GT(at_rest.width, 15) << "far from every vertex of the file";
    std::vector<glm::vec3> moved = organ.positions;
    for (glm::vec3& p : moved) p = {2.0f * p.x, 20.0f, p.z};
    effects.set_shape(moved);
    const auto hit = effects.pick({60, 100, 3}, {0, -1, 0});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 80.0, 1e-5);
    EXPECT_NEAR(glm::distance(effects.to_rest(hit->position), {30, 0, 3}), 0.0, 1e-4);
    for (glm::vec3& p : moved) p.y = 0.0f;
    effects.set_shape(moved, organ.normals);
    EXPECT_NEAR(red_of(effects).width, 2 * at_rest.width, 3);
    // A host that has all vertices may give them all.
    effects.set_shape(fine.positions, fine.normals);
    EXPECT_NEAR(red_of(effects).width, at_rest.width, 1);
    allocations = 0;
    effects.set_shape(moved, organ.normals);
    effects.set_shape(moved);
    EXPECT_EQ(allocations, 0u);
}

TEST_F(EffectsTest, ACoarseOrganThatIsCutKeepsTheBloodBetweenItsVertices) {
    const Organ whole = test::plane(100.0, 2);
    Effects effects(whole, bloody());
    effects.set_contacts(cut_at({7, 0, 12}));
    effects.seek(3.0);
    const double before = effects.amounts().blood_area;
    EXPECT_GT(before, 200.0);
    std::vector<std::uint32_t> origin(whole.positions.size());
    for (std::uint32_t v = 0; v < origin.size(); ++v) origin[v] = v;
    effects.set_topology(whole, origin);
    effects.set_contacts({});
    effects.seek(4.0);
    EXPECT_NEAR(effects.amounts().blood_area, before, 1e-6 * before);
}

TEST_F(EffectsTest, ACutOrganKeepsItsBloodAndNewBloodStaysOnItsSide) {
    const Organ whole = test::plane(100.0, 100);
    Effects effects(whole, bloody());
    effects.set_contacts(cut_at({-3, 0, 0}));
    effects.seek(2.0);
    const double before = effects.amounts().blood_area;
    // Cut along x = 0 into two sheets: the right one gets its own vertices along the cut, at a tiny distance.
    Organ cut;
    std::vector<std::uint32_t> origin;
    std::vector<glm::vec3> normals;
    const auto add = [&](std::uint32_t v, float shift) {
        cut.positions.push_back(whole.positions[v] + glm::vec3(shift, 0.0f, 0.0f));
        normals.push_back({0.0f, 1.0f, 0.0f});
        origin.push_back(v);
        return static_cast<std::uint32_t>(cut.positions.size() - 1);
    };
    for (std::uint32_t v = 0; v < whole.positions.size(); ++v) add(v, 0.0f);
    std::map<std::uint32_t, std::uint32_t> right;
    for (std::size_t t = 0; t < whole.indices.size(); t += 3) {
        const bool is_right = whole.positions[whole.indices[t]].x + whole.positions[whole.indices[t + 1]].x +
                                  whole.positions[whole.indices[t + 2]].x >
                              0.0f;
        for (std::size_t i = t; i < t + 3; ++i) {
            std::uint32_t v = whole.indices[i];
            if (is_right && whole.positions[v].x == 0.0f) {
                if (!right.contains(v)) right[v] = add(v, 0.01f);
                v = right[v];
            }
            cut.indices.push_back(v);
        }
    }
    cut = test::drawable(std::move(cut), normals);
    Preset no_bridges = bloody();
    no_bridges.bleeding.bridge_gap = 0.0;
    effects.set_preset(no_bridges);
    effects.set_topology(cut, origin);
    effects.seek(2.0);
    EXPECT_NEAR(effects.amounts().blood_area, before, 0.01 * before) << "blood that has crossed stays";
    effects.seek(60.0);
    // The left half of the final disc, and what had crossed before the cut.
    const double reach = 16.0 - 0.3, half_chord = std::acos(3.0 / reach);
    const double beyond = reach * reach * (half_chord - std::sin(half_chord) * std::cos(half_chord));
    const double early = 7.7, early_chord = std::acos(3.0 / early);
    const double crossed = early * early * (early_chord - std::sin(early_chord) * std::cos(early_chord));
    const double wanted = std::acos(-1.0) * reach * reach - beyond + crossed;
    EXPECT_NEAR(effects.amounts().blood_area, wanted, 0.03 * wanted);
    EXPECT_GT(red_of(effects).pixels, 100);
    const std::vector<std::uint32_t> all_new(whole.positions.size(), Effects::new_vertex);
    effects.set_contacts({});
    effects.set_topology(whole, all_new);
    effects.seek(61.0);
    EXPECT_EQ(effects.amounts().blood_area, 0.0) << "nothing survives where no vertex does";
}

}  // namespace
}  // namespace lapfx
