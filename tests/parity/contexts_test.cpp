// Several contexts in one process, each with objects of its own, made and destroyed in any order.
#include "lapfx/context.h"

#include <gmock/gmock.h>

#include <random>
#include <thread>

#include "gl/gl.h"
#include "lapfx/effects.h"
#include "lapfx/error.h"
#include "lapfx/frame.h"
#include "render/camera.h"
#include "support/gpu_test.h"
#include "support/host_context.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

using test::HostContext;
using testing::HasSubstr;
using Pixels = std::vector<std::uint8_t>;

constexpr glm::ivec2 extent{64, 48};

/// How many objects of OpenGL the current context has.
int live_objects() {
    int live = 0;
    for (GLuint name = 1; name < 2000; ++name)
        live += glIsBuffer(name) + glIsTexture(name) + glIsFramebuffer(name) + glIsVertexArray(name) +
                glIsProgram(name) + glIsShader(name) + glIsQuery(name) + glIsSampler(name) + glIsRenderbuffer(name);
    return live;
}

/// What a simulator has for one organ.
struct Drawn {
    explicit Drawn(std::uint32_t seed) : effects(test::plane(60.0, 20), Preset{}, {.seed = seed}) {
        const ToolContact cut{.action = ToolAction::cut, .position = glm::dvec3(0.0), .to = glm::dvec3(0.0)};
        effects.set_contacts({&cut, 1});
    }
    Pixels at(double time) {
        const View view = render::view_of({.eye = {0.0, 60.0, 20.0}, .target = {}, .up = {0.0, 0.0, -1.0}}, {}, extent);
        effects.seek(time);
        frame.begin(extent);
        effects.draw_organ(view);
        frame.begin_smoke();
        effects.draw_smoke(view, frame.depth());
        Pixels pixels(static_cast<std::size_t>(4 * extent.x * extent.y));
        frame.read(pixels, {.exposure = 1.5, .vignette = 0.0});
        return pixels;
    }
    Effects effects;
    Frame frame;
};

class ContextsTest : public test::GpuTest {
  protected:
    static Context another() { return Context::create(Backend::automatic); }
    static Pixels alone(std::uint32_t seed) {
        const Context context = another();
        return Drawn(seed).at(3.0);
    }
};

TEST_F(ContextsTest, EachDrawsWhatItDrawsAlone) {
    const Pixels one_alone = alone(1), two_alone = alone(2);
    EXPECT_NE(one_alone, two_alone);
    const Context first = another();
    Drawn one(1);
    const Context second = another();
    Drawn two(2);
    for (int i = 0; i < 2; ++i) {
        first.make_current();
        EXPECT_EQ(one.at(3.0), one_alone);
        second.make_current();
        EXPECT_EQ(two.at(3.0), two_alone);
    }
}

TEST_F(ContextsTest, ObjectsAreDestroyedWhileAnotherContextIsCurrent) {
    const Context first = another();
    const int nothing = live_objects();
    auto one = std::make_unique<Drawn>(1);
    EXPECT_GT(live_objects(), nothing + 20);
    const Context second = another();
    Drawn two(2);
    const Pixels before = two.at(3.0);
    const int of_two = live_objects();
    one = nullptr;
    EXPECT_EQ(live_objects(), of_two) << "the other context is current, as before, and has lost nothing";
    EXPECT_EQ(two.at(3.0), before);
    first.make_current();
    EXPECT_EQ(live_objects(), nothing) << "all objects of the first are gone";
}

TEST_F(ContextsTest, TheContextMayGoFirst) {
    auto context = std::make_unique<Context>(another());
    Drawn one(1);
    const Pixels before = one.at(3.0);
    context = nullptr;
    EXPECT_EQ(one.at(3.0), before) << "its objects hold it";
}

TEST_F(ContextsTest, NothingIsLeftAfterAHundredTimesInAnyOrder) {
    std::mt19937 random(3);
    const Context lasting = another();
    Drawn kept(5);
    const Pixels before = kept.at(2.0);
    const int objects = live_objects();
    for (int turn = 0; turn < 100; ++turn) {
        std::vector<std::shared_ptr<void>> all;
        for (std::uint32_t i = 0; i < 2; ++i) {
            const auto context = std::make_shared<Context>(another());
            const auto effects = std::make_shared<Effects>(test::plane(20.0, 4), Preset{});
            effects->seek(0.5);
            all.insert(all.end(), {context, effects, std::make_shared<Frame>()});
        }
        if (turn % 2 == 0) lasting.make_current();
        std::ranges::shuffle(all, random);
        while (!all.empty()) all.pop_back();
        lasting.make_current();
        ASSERT_EQ(live_objects(), objects) << "turn " << turn;
    }
    EXPECT_EQ(kept.at(2.0), before);
}

TEST_F(ContextsTest, OneThreadEach) {
    const Pixels one_alone = alone(1), two_alone = alone(2);
    const auto draw = [](std::uint32_t seed, Pixels& pixels) {
        const Context context = another();
        Drawn drawn(seed);
        for (int i = 1; i <= 3; ++i) pixels = drawn.at(i);
    };
    Pixels one, two;
    { const std::jthread first(draw, 1, std::ref(one)), second(draw, 2, std::ref(two)); }
    EXPECT_EQ(one, one_alone);
    EXPECT_EQ(two, two_alone);
}

TEST_F(ContextsTest, WithoutAContextNothingIsMade) {
    const Context here = Context::create(Backend::automatic);  // current on this thread, not on the other one
    const auto refused = [](const auto& make) {
        std::string told;
        std::jthread([&] {
            try {
                make();
            } catch (const Error& error) {
                if (error.failure() == Failure::no_gl) told = error.what();
            }
        }).join();
        return told;
    };
    EXPECT_THAT(refused([] { Frame(); }), testing::HasSubstr("no OpenGL context is current on this thread"));
    EXPECT_THAT(refused([] { Effects(test::plane(20.0, 4), Preset{}); }),
                testing::HasSubstr("no OpenGL context is current on this thread"));
}

TEST_F(ContextsTest, AContextOfAnotherThreadIsRefused) {
    const Context context = another();
    if (context.get_proc_address() != eglGetProcAddress) GTEST_SKIP() << "only EGL tells";
    std::string told;
    std::jthread([&] {
        try {
            context.make_current();
        } catch (const Error& error) {
            told = error.what();
        }
    }).join();
    EXPECT_EQ(told, "EGL's context cannot be made current: another thread may have it");
}

std::string refusal(Context::GetProcAddress get_proc_address) {
    try {
        Context::external(get_proc_address);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::no_gl);
        return error.what();
    }
    return "it was accepted";
}

/// A driver that cannot do enough.
const GLubyte* old_string(GLenum) {
    return reinterpret_cast<const GLubyte*>("3.3 (Core Profile) of a test");
}
Context::Function old_driver(const char* name) {
    return std::string_view(name) == "glGetString" ? reinterpret_cast<Context::Function>(old_string)
                                                   : eglGetProcAddress(name);
}
Context::Function no_driver(const char*) {
    return nullptr;
}

TEST_F(ContextsTest, AHostsContextThatWillNotDoIsRefused) {
    std::string without_context;
    std::jthread([&] { without_context = refusal(eglGetProcAddress); }).join();
    if (another().get_proc_address() != eglGetProcAddress) GTEST_SKIP() << "the functions of this test are EGL's";
    EXPECT_EQ(without_context, "no usable OpenGL: the host's context is not current on this thread");
    EXPECT_EQ(refusal(nullptr), "no usable OpenGL: get_proc_address is null");
    EXPECT_EQ(refusal(old_driver),
              "no usable OpenGL: the host's context gives version 3.3 (Core Profile) of a test; OpenGL 4.5 is needed");
    EXPECT_EQ(refusal(no_driver),
              "the host's context has other OpenGL functions than EGL, which is in use; one "
              "backend per process");
    try {
        Context::create(Backend::osmesa);
        ADD_FAILURE() << "OSMesa's functions replaced EGL's";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("OSMesa has other OpenGL functions than EGL, which is in use"));
    }
    const test::HostContext host(EGL_OPENGL_API,
                                 {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE});
    EXPECT_THROW(Context::create(Backend::osmesa), Error);
    EXPECT_EQ(eglGetCurrentContext(), host.context);
    EXPECT_NE(glGetString(GL_VERSION), nullptr) << "the host's context has no functions any more";
}

TEST_F(ContextsTest, ACompatibilityContextDrawsTheSame) {
    const Pixels expected = alone(1);
    const HostContext host(EGL_OPENGL_API,
                           {EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_NONE});
    if (host.context == EGL_NO_CONTEXT) GTEST_SKIP() << "the driver has no compatibility context";
    const Context context = Context::external(eglGetProcAddress);
    if (std::string(context.renderer()).find("llvmpipe") == std::string::npos) GTEST_SKIP() << "of another driver";
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    ASSERT_EQ(profile, GL_CONTEXT_COMPATIBILITY_PROFILE_BIT);
    EXPECT_EQ(Drawn(1).at(3.0), expected);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(ContextsTest, OpenGlEsIsRefused) {
    const HostContext host(EGL_OPENGL_ES_API, {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE});
    if (host.context == EGL_NO_CONTEXT) GTEST_SKIP() << "the driver has no OpenGL ES";
    EXPECT_THAT(refusal(eglGetProcAddress), HasSubstr("the host's context gives version OpenGL ES 3"));
}

TEST_F(ContextsTest, AHostsContextIsCurrentAgainAfterwards) {
    auto ours = std::make_unique<Drawn>(1);  // in the context of all tests
    const HostContext host(EGL_OPENGL_API, {EGL_NONE});
    ASSERT_NE(host.context, EGL_NO_CONTEXT);
    ours = nullptr;
    EXPECT_EQ(eglGetCurrentContext(), host.context);
}

TEST_F(ContextsTest, TheThreadsOwnApiStays) {
    eglBindAPI(EGL_OPENGL_ES_API);
    { const Context context = another(); }
    EXPECT_EQ(eglQueryAPI(), static_cast<EGLenum>(EGL_OPENGL_ES_API));
}

TEST_F(ContextsTest, ReadingAFrameLeavesTheHostsPacking) {
    const Context context = another();
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, 64, nullptr, 0);
    Drawn drawn(1);
    const Pixels before = drawn.at(3.0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_PACK_ROW_LENGTH, 200);
    EXPECT_EQ(drawn.at(3.0), before);
    GLint alignment = 0, length = 0, bound = 0;
    glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
    glGetIntegerv(GL_PACK_ROW_LENGTH, &length);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bound);
    EXPECT_EQ(alignment, 8);
    EXPECT_EQ(length, 200);
    EXPECT_EQ(static_cast<GLuint>(bound), buffer);
    EXPECT_EQ(before[3], 255);
    EXPECT_GT(before[4 * (24 * 64 + 32)], 10) << "tissue in the middle of the frame";
}

TEST_F(ContextsTest, ReadingNeedsAFrameAndItsSize) {
    const Context context = another();
    Frame frame;
    Pixels pixels(16);
    const auto told = [&] {
        try {
            frame.read(pixels);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(told(), "rgba: begin() has not been called");
    frame.begin({3, 2});
    EXPECT_EQ(told(), "rgba: 16 bytes; a frame of 3x2 pixels has 24");
    pixels.resize(24);
    EXPECT_EQ(told(), "");
}

}  // namespace
}  // namespace lapfx
