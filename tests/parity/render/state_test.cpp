// The GL state belongs to the host: draw calls leave it as they found it.
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/state_guard.h"
#include "lapfx/effects.h"
#include "lapfx/prepared_organ.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "support/gl_state.h"
#include "support/wait_until.h"

namespace lapfx {
namespace {

constexpr GLenum switches[] = {GL_BLEND,        GL_DEPTH_TEST,   GL_CULL_FACE,        GL_MULTISAMPLE,
                               GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB, GL_POLYGON_OFFSET_FILL};

constexpr int units = 16;

/// All of 4.5, and what newer drivers have beside it.
test::GlState state() {
    test::GlState all = test::gl_state();
    if (gl::polygon_offset_clamp() != nullptr) {
        GLdouble clamp = 0.0;
        glGetDoublev(gl::polygon_offset_clamp_query, &clamp);
        all["value of glPolygonOffsetClamp"] = {clamp};
    }
    return all;
}

/// Binds and sets what has no part in drawing a picture, to other values than those of a new context.
class Elsewhere {
  public:
    explicit Elsewhere(GLuint buffer) {
        for (const GLenum target : targets) glBindBuffer(target, buffer);
        for (const GLenum target : {GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER})
            for (GLuint i = 0; i < 2; ++i) glBindBufferRange(target, i, buffer, 256 * (i + 1), 256);
        for (const auto& [kind, unit] : textures) {
            GLuint& name = names_.emplace_back();
            glCreateTextures(kind, 1, &name);
            glBindTextureUnit(unit, name);
        }
        glCreateRenderbuffers(1, &renderbuffer_);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_);
        glCreateProgramPipelines(1, &pipeline_);
        glBindProgramPipeline(pipeline_);
        set(true);
    }
    ~Elsewhere() {
        for (const GLenum target : targets) glBindBuffer(target, 0);
        for (const GLenum target : {GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER})
            for (GLuint i = 0; i < 2; ++i) glBindBufferBase(target, i, 0);
        glDeleteTextures(static_cast<GLsizei>(names_.size()), names_.data());
        glDeleteRenderbuffers(1, &renderbuffer_);
        glDeleteProgramPipelines(1, &pipeline_);
        set(false);
    }
    Elsewhere(const Elsewhere&) = delete;
    Elsewhere& operator=(const Elsewhere&) = delete;

  private:
    static constexpr GLenum targets[] = {GL_COPY_READ_BUFFER,   GL_COPY_WRITE_BUFFER,        GL_DRAW_INDIRECT_BUFFER,
                                         GL_PIXEL_PACK_BUFFER,  GL_DISPATCH_INDIRECT_BUFFER, GL_QUERY_BUFFER,
                                         GL_PIXEL_UNPACK_BUFFER};
    /// Beside the 2D textures of the core's units, and above them.
    static constexpr std::pair<GLenum, GLuint> textures[] = {
        {GL_TEXTURE_3D, 0},        {GL_TEXTURE_CUBE_MAP, 1}, {GL_TEXTURE_BUFFER, 2},         {GL_TEXTURE_RECTANGLE, 13},
        {GL_TEXTURE_1D_ARRAY, 13}, {GL_TEXTURE_2D, 20},      {GL_TEXTURE_2D_MULTISAMPLE, 21}};

    static void set(bool other) {
        const float value = other ? 0.25f : 0.0f;
        glBlendColor(value, value, value, value);
        glClearColor(value, value, value, value);
        glClearDepth(other ? 0.5 : 1.0);
        glClearStencil(other ? 3 : 0);
        glPixelStorei(GL_PACK_ALIGNMENT, other ? 2 : 4);
        glPixelStorei(GL_PACK_ROW_LENGTH, other ? 99 : 0);
        for (const GLenum name : {GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_SKIP_ROWS})
            glPixelStorei(name, other ? 7 : 0);
        glPatchParameteri(GL_PATCH_VERTICES, other ? 4 : 3);
        glPrimitiveRestartIndex(other ? 77 : 0);
        glVertexAttrib4f(5, value, value, value, other ? 0.5f : 1.0f);
        glLogicOp(other ? GL_XOR : GL_COPY);
        for (const GLenum name : {GL_PROGRAM_POINT_SIZE, GL_TEXTURE_CUBE_MAP_SEAMLESS})
            other ? glEnable(name) : glDisable(name);
    }

    std::vector<GLuint> names_;
    GLuint renderbuffer_ = 0, pipeline_ = 0;
};

class StateTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 extent{64, 48};

    void SetUp() override {
        test::SceneTest::SetUp();
        if (IsSkipped()) return;
        color = gl::Texture({.size = extent, .format = GL_RGBA16F});
        depth = gl::Texture({.size = extent, .format = GL_DEPTH_COMPONENT32F, .filter = GL_NEAREST});
        whole = gl::Framebuffer(color, &depth);
        smoke_only = gl::Framebuffer(color, nullptr);
    }
    void TearDown() override {
        if (!IsSkipped()) put_back();
        test::SceneTest::TearDown();
    }

    Effects effects() const {
        Effects made(test::plane(80.0, 10), preset, {.clip_folders = {}, .wait_for_clips = true});
        made.set_contacts(scene.events);
        return made;
    }
    View view() const { return render::view_of(scene.camera, scene.light, extent); }

    void clear() const {
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(whole.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(whole.name(), GL_DEPTH, 0, &far);
        glViewport(0, 0, extent.x, extent.y);
    }
    std::vector<float> pixels() const {
        std::vector<float> all(4 * static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(all.size() * sizeof(float)),
                          all.data());
        return all;
    }
    static void put_back() {
        for (const GLenum query : switches) glDisable(query);
        glDepthMask(GL_TRUE);
        glPolygonOffset(0.0f, 0.0f);
        glBlendFunc(GL_ONE, GL_ZERO);
        glBlendEquation(GL_FUNC_ADD);
        glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glUseProgram(0);
        glBindVertexArray(0);
        glActiveTexture(GL_TEXTURE0);
        for (GLuint i = 0; i < units; ++i) glBindSampler(i, 0);
    }

    gl::Texture color, depth;
    gl::Framebuffer whole, smoke_only;
};

TEST_F(StateTest, DrawCallsLeaveTheHostsStateAsTheyFindIt) {
    scene.events.push_back({.action = ToolAction::clip, .time = 1.0, .duration = 0.2});
    Effects e = effects();
    e.seek(2.5);
    const gl::Buffer buffer(4096);
    const gl::Texture texture({.size = {2, 2}}), texture_array({.size = {2, 2}, .layers = 3});
    const gl::VertexArray vertex_array;
    const gl::Program program("fullscreen.vert", "post.frag");
    GLuint sampler = 0;
    glCreateSamplers(1, &sampler);
    for (const bool on : {true, false}) {
        clear();
        for (const GLenum query : switches)
            if (query != GL_SCISSOR_TEST) on ? glEnable(query) : glDisable(query);
        on ? glDisable(GL_SCISSOR_TEST) : glEnable(GL_SCISSOR_TEST);
        glScissor(1, 2, 60, 40);
        glDepthFunc(on ? GL_GEQUAL : GL_NOTEQUAL);
        glDepthMask(on ? GL_FALSE : GL_TRUE);
        glPolygonOffset(on ? 3.0f : 0.0f, on ? -2.0f : 0.0f);
        if (const gl::PolygonOffsetClamp offset = gl::polygon_offset_clamp(); on && offset != nullptr)
            offset(3.0f, -2.0f, 5.0f);
        glBlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_SRC_ALPHA);
        glBlendEquationSeparate(GL_FUNC_SUBTRACT, GL_MAX);
        for (GLuint i = 0; i < units; ++i) {
            glBindTextureUnit(i, texture.name());
            glBindTextureUnit(i, texture_array.name());  // beside it: another target
            glBindSampler(i, on ? sampler : 0);
        }
        glViewport(3, 5, 50, 40);
        for (GLuint i = 0; i < 4; ++i)  // whole buffers, parts of buffers, and nothing
            if (on)
                glBindBufferRange(GL_UNIFORM_BUFFER, i, buffer.name(), 256 * i, 512);
            else
                glBindBufferBase(GL_UNIFORM_BUFFER, i, i % 2 == 0 ? buffer.name() : 0);
        glBindBuffer(GL_UNIFORM_BUFFER, on ? buffer.name() : 0);
        glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
        glBindVertexArray(vertex_array.name());
        glUseProgram(program.name());
        glActiveTexture(GL_TEXTURE3);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
        const Elsewhere elsewhere(buffer.name());
        glBindFramebuffer(GL_FRAMEBUFFER, whole.name());

        const test::GlState before = state();
        e.draw_organ(view());
        EXPECT_EQ(test::changes(before, state()), "") << "after draw_organ";
        e.draw_metal_clips(view());
        EXPECT_EQ(test::changes(before, state()), "") << "after draw_metal_clips";
        glBindFramebuffer(GL_FRAMEBUFFER, smoke_only.name());
        const test::GlState smoky = state();
        e.draw_smoke(view(), depth.name());
        EXPECT_EQ(test::changes(smoky, state()), "") << "after draw_smoke";
        e.seek(on ? 3.0 : 2.0);
        EXPECT_EQ(test::changes(smoky, state()), "") << "after seek";
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        put_back();
    }
    glDeleteSamplers(1, &sampler);
}

/// With the host's buffer to read pixels from, its rows, its vertex array and its uniform block, at every stage.
TEST_F(StateTest, AnOrganThatComesAndOneThatGoesLeaveTheHostsState) {
    Organ spotted = test::plane(80.0, 20);
    spotted.images = {{.width = 1000, .height = 1500, .pixels = {}, .name = "spots"}};
    for (std::size_t i = 0; i < std::size_t{4} * 1000 * 1500; ++i)
        spotted.images[0].pixels.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : 100 + i / 4 * 7 % 100));
    spotted.materials[0].base_color_image = 0;
    for (std::size_t v = 0; v < spotted.uvs.size(); ++v)
        spotted.uvs[v] = glm::vec2(spotted.positions[v].x, spotted.positions[v].z) / 80.0f;
    const auto other = prepare_organ(spotted, preset.vessels);
    const auto drawn = [&](Effects& one) {
        clear();
        glBindFramebuffer(GL_FRAMEBUFFER, whole.name());
        one.draw_organ(view());
        return pixels();
    };
    Effects wanted(other, preset, {.clip_folders = {}, .wait_for_clips = true});
    Effects e(test::plane(80.0, 10), preset, {.clip_folders = {}});
    e.set_contacts(scene.events);
    e.seek(2.5);
    wanted.seek(2.5);
    const std::vector<float> direct = drawn(wanted), former = drawn(e);
    int seeks = 0;
    {
        const gl::Buffer buffer(4096);
        const gl::VertexArray vertex_array;
        glBindBufferRange(GL_UNIFORM_BUFFER, 1, buffer.name(), 256, 512);
        glBindVertexArray(vertex_array.name());
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
        const Elsewhere elsewhere(buffer.name());
        const test::GlState before = state();
        const auto expect_same = [&](const char* when) {
            EXPECT_EQ(test::changes(before, state()), "") << when << " " << seeks;
        };
        e.set_organ(other);
        expect_same("set_organ");
        EXPECT_TRUE(test::wait_until([&] { return !e.organ_coming(); },
                                     [&] {
                                         e.seek(2.5);
                                         ++seeks;
                                         expect_same("on its way");
                                     }));
        for (int i = 0; i < 10; ++i) {
            e.seek(2.5);
            expect_same("the other one goes");
        }
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    }
    put_back();
    EXPECT_GE(seeks, 3);
    EXPECT_NE(direct, former);
    EXPECT_EQ(drawn(e), direct);
}

TEST_F(StateTest, AHostsShaderGetsOneUniformBindingAndAllElseStays) {
    const Effects e = effects();
    const test::GlState before = state();
    e.bind_bleeding();
    test::GlState after = state();
    GLint bound = 0;
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 1, &bound);
    EXPECT_NE(bound, 0);
    after.erase(test::gl_state_parts::named("value", GL_UNIFORM_BUFFER_BINDING));
    for (const GLenum query : {GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE})
        after.erase(test::gl_state_parts::named("binding", query, 1));
    EXPECT_EQ(test::changes(before, after), "");
}

TEST_F(StateTest, WhatTheHostHasSetDoesNotChangeThePicture) {
    const auto drawn = [&](const auto& set_up) {
        Effects e = effects();
        e.seek(2.5);
        clear();
        set_up();
        glBindFramebuffer(GL_FRAMEBUFFER, whole.name());
        e.draw_organ(view());
        glBindFramebuffer(GL_FRAMEBUFFER, smoke_only.name());
        e.draw_smoke(view(), depth.name());
        put_back();
        return pixels();
    };
    const std::vector<float> plain = drawn([] {});
    EXPECT_GT(*std::max_element(plain.begin(), plain.end()), 0.1f);
    EXPECT_TRUE(plain == drawn([] {
                    glEnable(GL_BLEND);
                    glBlendFunc(GL_ZERO, GL_ONE);
                    glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
                    glEnable(GL_CULL_FACE);
                    glEnable(GL_DEPTH_TEST);
                    glDepthFunc(GL_NEVER);
                    glDepthMask(GL_FALSE);
                    glEnable(GL_POLYGON_OFFSET_FILL);
                    glPolygonOffset(1.0f, 1e6f);
                }));
    const gl::Buffer buffer(1 << 20);
    EXPECT_TRUE(plain == drawn([&] {
                    glPixelStorei(GL_UNPACK_ROW_LENGTH, 777);
                    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
                    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
                    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer.name());
                }))
        << "clip frames are uploaded while drawing";
    GLuint sampler = 0;  // a host that draws text has one, and so has the editor: no mipmaps, no repeating
    glCreateSamplers(1, &sampler);
    for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(sampler, name, GL_CLAMP_TO_EDGE);
    for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(sampler, name, GL_NEAREST);
    EXPECT_TRUE(plain == drawn([&] {
                    for (GLuint i = 0; i < units; ++i) glBindSampler(i, sampler);
                }))
        << "a sampler of the host's wins over the filter of a texture";
    glDeleteSamplers(1, &sampler);
}

TEST_F(StateTest, AColourWithoutExtinctionPassesWholeEvenThroughThickSmoke) {
    preset.smoke.keying = {.luma_low = 0.0, .luma_high = 1.0, .noise_strength = 0.0};
    preset.smoke.plume.extinction = {0.0, 1.0, 1.0};
    preset.smoke.plume.density = 4.0;
    preset.smoke.haze.accumulation = 5.0;
    preset.smoke.haze.ventilation = 0.0;
    preset.smoke.haze.extinction = {0.0, 1.0, 1.0};
    scene.events[1].duration = 100.0;
    Effects e = effects();
    e.seek(90.0);
    clear();
    glBindFramebuffer(GL_FRAMEBUFFER, whole.name());
    e.draw_organ(view());
    const std::vector<float> tissue = pixels();
    glBindFramebuffer(GL_FRAMEBUFFER, smoke_only.name());
    e.draw_smoke(view(), depth.name());
    const std::vector<float> smoky = pixels();
    for (std::size_t i = 0; i < smoky.size(); i += 4) {
        ASSERT_EQ(smoky[i], tissue[i]) << "red of pixel " << i / 4;
        ASSERT_TRUE(std::isfinite(smoky[i + 1]) && std::isfinite(smoky[i + 2]));
    }
    EXPECT_GT(e.amounts().haze, 100.0);
}

}  // namespace
}  // namespace lapfx
