// Nothing is left of organs, effects, frames and contexts that a host makes and destroys in any order: no object of
// OpenGL, as counted at the calls themselves, and no memory. The driver's debug output says that no call was wrong.
#include "lapfx/context.h"

#include <gmock/gmock.h>

#include <random>

#include "lapfx.h"
#include "lapfx/effects.h"
#include "lapfx/frame.h"
#include "lapfx/prepared_organ.h"
#include "leaks/counted_gl.h"
#include "leaks/heap.h"
#include "media/schemes.h"
#include "render/camera.h"
#include "support/clips.h"
#include "support/host_context.h"
#include "support/meshes.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

using test::HostContext;
using test::counted_gl::counted;
using test::counted_gl::live;
using testing::IsEmpty;

constexpr int turns = 100, stretch = 20;
constexpr glm::ivec2 extent{32, 24};
// Bytes by which the heap may grow in a stretch of turns. A leak grows in each, and the least counts: Mesa fills caches
// at some time, by up to 400 kB. Mesa 22 keeps 128 bytes of each context that has been drawn in. An object that each
// turn left behind would be above, if it has 52 bytes.
constexpr std::ptrdiff_t kept_of_contexts = 2 * 128 * stretch + 1024, kept_of_nothing = 1024;

std::ptrdiff_t least_growth(const std::vector<std::size_t>& heap) {
    std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
    for (std::size_t i = 2; i < heap.size(); ++i)  // much is made once in the first stretch
        least = std::min(least, static_cast<std::ptrdiff_t>(heap[i] - heap[i - 1]));
    return least;
}

void hear(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* told) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
        static_cast<std::vector<std::string>*>(const_cast<void*>(told))->emplace_back(message);
}

/// A context that a host made for debugging, and what OpenGL said of the calls in it.
struct Told : HostContext {
    explicit Told(std::vector<std::string>& told)
        : HostContext(EGL_OPENGL_API, {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                                       EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE, EGL_NONE}) {
        if (context == EGL_NO_CONTEXT) return;
        Context::external(test::counted_gl::get_proc_address);  // loads the functions
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(hear, &told);
    }
};

/// Something to destroy, and the context that has to be current then.
struct Made {
    std::shared_ptr<HostContext> in;
    std::shared_ptr<void> object;
};

class LeaksTest : public testing::Test {
  protected:
    LeaksTest() {
        test::write_clip(folder / "clip.avi", 4);
        preset.folder = folder.path();
        preset.smoke.clips = {{.file = "clip.avi", .role = ClipRole::plume},
                              {.file = "clip.avi", .role = ClipRole::haze}};
    }
    void SetUp() override {
        if (host()->context == EGL_NO_CONTEXT) GTEST_SKIP() << "no OpenGL 4.5 by EGL without a surface";
    }

    std::shared_ptr<Told> host() { return std::make_shared<Told>(told); }

    /// What a simulator makes, in the context that is current: each way of streaming in turn.
    std::vector<Made> simulator(const std::shared_ptr<HostContext>& in, int turn) {
        constexpr std::size_t schemes = std::size(media::scheme_rows);
        const Scheme scheme = media::scheme_rows[static_cast<std::size_t>(turn) % schemes].scheme;
        const auto organ = prepare_organ(test::plane(20.0, 8), preset.vessels);
        const auto context = std::make_shared<Context>(Context::external(test::counted_gl::get_proc_address));
        const auto effects = std::make_shared<Effects>(
            organ, preset,
            EffectsOptions{.wait_for_clips = true, .streaming = {.scheme = scheme, .gpu_timings = turn % 3 == 0}});
        const auto frame = std::make_shared<Frame>();
        const ToolContact burn{.action = ToolAction::cauterise, .duration = 2.0}, clip{.action = ToolAction::clip};
        effects->set_contacts(std::vector{burn, clip});
        if (turn % 2 == 0) effects->set_overlay(Overlay::vessels);
        if (turn % 5 == 0)
            effects->set_topology(test::plane(20.0, 4), std::vector<std::uint32_t>(25, Effects::new_vertex));
        if (turn % 4 == 1) effects->set_organ(organ);  // comes and goes
        draw(*effects, *frame);
        for (int i = 0; turn % 4 == 1 && i < turn % 16; ++i) effects->seek(1.0);  // the first one goes in parts
        if (turn % 8 == 1) effects->set_organ(organ);                             // is on its way when all ends
        EXPECT_GT(live(in->context).at("Textures"), 10);
        return {{in, std::const_pointer_cast<PreparedOrgan>(organ)}, {in, context}, {in, effects}, {in, frame}};
    }
    static void draw(Effects& effects, Frame& frame) {
        const View view = render::view_of({.eye = {0.0, 30.0, 10.0}, .target = {}, .up = {0.0, 0.0, -1.0}}, {}, extent);
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * extent.x * extent.y));
        effects.seek(1.0);
        frame.begin(extent);
        effects.draw_organ(view);
        frame.begin_smoke();
        effects.draw_smoke(view, frame.depth());
        frame.read(pixels);
    }

    void expect_nothing_left(int turn) const {
        EXPECT_THAT(live(), IsEmpty()) << "turn " << turn;
        EXPECT_THAT(counted().faults, IsEmpty()) << "turn " << turn;
        EXPECT_THAT(told, IsEmpty()) << "turn " << turn;
    }

    /// Destroys all in any order.
    void destroy(std::vector<Made>& all) {
        std::ranges::shuffle(all, random);
        while (!all.empty()) {
            all.back().in->make_current();
            all.back().object = nullptr;
            all.pop_back();
        }
    }

    test::Folder folder;
    Preset preset;
    std::vector<std::string> told;
    std::mt19937 random{11};
};

TEST_F(LeaksTest, TheCountersTell) {
    const auto in = host();
    GLuint names[2] = {};
    glCreateBuffers(2, names);
    EXPECT_EQ(live(in->context), (std::map<std::string, int>{{"Buffers", 2}}));
    glDeleteBuffers(1, names);
    EXPECT_EQ(live(in->context), (std::map<std::string, int>{{"Buffers", 1}}));
    EXPECT_THAT(counted().faults, IsEmpty());
    glDeleteBuffers(2, names);
    EXPECT_THAT(live(in->context), IsEmpty());
    EXPECT_THAT(counted().faults,
                testing::ElementsAre("Buffers " + std::to_string(names[0]) + " deleted, which does not live"));
    counted().faults.clear();
    EXPECT_THAT(told, IsEmpty());
    glEnable(GL_TEXTURE);
    EXPECT_EQ(told.size(), 1u) << "a name that glEnable does not take";
}

TEST_F(LeaksTest, AHundredTimesInAnyOrder) {
    std::vector<std::size_t> heap;
    for (int turn = 0; turn < turns; ++turn) {
        if (turn % stretch == 0) heap.push_back(test::allocated_bytes());
        std::vector<Made> all;
        for (int i = 0; i < 2; ++i) {
            const auto in = host();
            std::ranges::move(simulator(in, turn + i), std::back_inserter(all));
        }
        destroy(all);
        expect_nothing_left(turn);
        if (HasFailure()) return;
    }
    heap.push_back(test::allocated_bytes());
    EXPECT_LT(least_growth(heap), kept_of_contexts);
    for (const char* kind : {"Buffers", "Textures", "Framebuffers", "VertexArrays", "Program", "Shader"})
        EXPECT_GE(counted().made[kind], 2 * turns) << kind;
    for (const char* kind : {"Queries", "Mapping"}) EXPECT_GE(counted().made[kind], turns / 4) << kind;
}

TEST_F(LeaksTest, AHundredTimesAndMoreInC) {
    const auto in = host();
    const Organ flat = test::plane(20.0, 8);
    lapfx_mesh mesh = LAPFX_MESH;
    mesh.vertex_count = flat.positions.size();
    mesh.positions = &flat.positions.data()->x;
    mesh.index_count = flat.indices.size();
    mesh.indices = flat.indices.data();
    const std::string json =
        R"({"format": "lapfx.preset", "version": 1, "name": "a", "smoke": {"clips": [{"file": "clip.avi"}]}})";
    lapfx_view view = LAPFX_VIEW;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * extent.x * extent.y));
    lapfx_effects_options options = LAPFX_EFFECTS_OPTIONS;
    options.wait_for_clips = 1;
    lapfx_contact cut = LAPFX_CONTACT;
    cut.action = LAPFX_CUT;
    std::vector<std::size_t> heap;
    for (int turn = 0; turn < 3 * turns; ++turn) {
        if (turn % stretch == 0) heap.push_back(test::allocated_bytes());
        lapfx_context* context = nullptr;
        lapfx_organ* organ = nullptr;
        lapfx_preset* tuned = nullptr;
        lapfx_effects* effects = nullptr;
        lapfx_frame* frame = nullptr;
        unsigned depth = 0;
        const lapfx_status done[] = {
            lapfx_context_external(test::counted_gl::get_proc_address, &context),
            lapfx_organ_create(&mesh, &organ),
            lapfx_preset_parse(json.c_str(), folder.path().c_str(), &tuned),
            turn % 2 == 0 ? lapfx_organ_prepare(organ, tuned) : LAPFX_OK,
            lapfx_effects_create(context, organ, tuned, &options, &effects),
            lapfx_frame_create(context, &frame),
            lapfx_effects_set_contacts(effects, &cut, 1),
            lapfx_effects_seek(effects, 1.0),
            lapfx_frame_begin(frame, extent.x, extent.y),
            lapfx_effects_draw_organ(effects, &view),
            lapfx_frame_begin_smoke(frame),
            lapfx_frame_get_depth(frame, &depth),
            lapfx_effects_draw_smoke(effects, &view, depth),
            lapfx_frame_read(frame, nullptr, pixels.data(), pixels.size()),
        };
        ASSERT_THAT(done, testing::Each(LAPFX_OK)) << lapfx_last_message();
        EXPECT_GT(live().at("Textures"), 5);
        std::function<lapfx_status()> destroys[] = {
            [&] { return lapfx_context_destroy(context); }, [&] { return lapfx_organ_destroy(organ); },
            [&] { return lapfx_preset_destroy(tuned); }, [&] { return lapfx_effects_destroy(effects); },
            [&] { return lapfx_frame_destroy(frame); }};
        std::ranges::shuffle(destroys, random);
        for (const auto& one : destroys) EXPECT_EQ(one(), LAPFX_OK) << lapfx_last_message();
        expect_nothing_left(turn);
        if (HasFailure()) return;
    }
    heap.push_back(test::allocated_bytes());
    EXPECT_LT(least_growth(heap), kept_of_nothing);
}

}  // namespace
}  // namespace lapfx
