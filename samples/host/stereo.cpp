// A stereo laparoscope: a host without a window, in an EGL context of its own. One update, then a picture for each eye,
// side by side in one PPM: EYES is the distance of the eyes, mm, and both see the same at the scene's target.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <lapfx/effects.h>
#include <lapfx/frame.h>
#include <lapfx/scene.h>

#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

namespace {

void require(bool holds, const char* reason, lapfx::Failure failure) {
    if (!holds) throw lapfx::Error(failure, lapfx::Fault{.file = "", .place = "", .reason = reason});
}

void make_context() {
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    const bool made =
        eglInitialize(display, nullptr, nullptr) == EGL_TRUE && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                       eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes)) == EGL_TRUE;
    require(made, "EGL gives no OpenGL 4.5 context without a window", lapfx::Failure::no_gl);
}

lapfx::Organ organ_of(const lapfx::Scene& scene) {
    const lapfx::SceneOrgan& o = scene.organ;
    const auto texture = o.texture.empty() ? std::filesystem::path() : scene.folder / o.texture;
    return lapfx::load_organ(scene.folder / o.file, {o.scale, o.rotation, texture});
}

/// From `side` mm right of the scene's camera. Its frustum is shifted rather than turned, so that what is as far away
/// as the target has no parallax.
lapfx::View eye(const lapfx::Scene& scene, double aspect, double side) {
    constexpr double nearest = 2.0, farthest = 5000.0;
    const lapfx::SceneCamera& c = scene.camera;
    const lapfx::SceneLight& l = scene.light;
    const double top = nearest * glm::tan(glm::radians(c.field_of_view) / 2.0), right = top * aspect;
    const double shift = side * nearest / glm::distance(c.eye, c.target);
    const glm::dmat4 centre = glm::lookAt(c.eye, c.target, c.up);
    return {glm::mat4(glm::translate(glm::dmat4(1.0), {-side, 0.0, 0.0}) * centre),
            glm::mat4(glm::frustum(-right - shift, right - shift, -top, top, nearest, farthest)),
            {l.intensity, l.focus_distance, l.beam_angle, lapfx::Lamp{}.ambient, l.color}};
}

using Picture = std::vector<std::uint8_t>;  // RGBA, rows from the top

Picture drawn(lapfx::Effects& effects, lapfx::Frame& frame, const lapfx::Scene& scene, glm::ivec2 size, double side) {
    const lapfx::View view = eye(scene, static_cast<double>(size.x) / size.y, side);
    frame.begin(size);
    effects.draw_organ(view);
    frame.begin_smoke();
    effects.draw_smoke(view, frame.depth());
    Picture picture(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    frame.read(picture, {scene.camera.exposure, scene.camera.vignette});
    return picture;
}

void write_side_by_side(const Picture& left, const Picture& right, glm::ivec2 size) {
    std::printf("P6\n%d %d\n255\n", 2 * size.x, size.y);
    const std::size_t row = 4 * static_cast<std::size_t>(size.x);
    for (std::size_t begin = 0; begin < left.size(); begin += row)
        for (const Picture* picture : {&left, &right})
            for (std::size_t i = begin; i < begin + row; i += 4) std::fwrite(&(*picture)[i], 1, 3, stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        require(argc == 8, "usage: lapfx_host_stereo SCENE PRESET CLIPS WIDTH HEIGHT SECONDS EYES",
                lapfx::Failure::bad_input);
        const glm::ivec2 size(std::atoi(argv[4]), std::atoi(argv[5]));
        make_context();
        const auto context = lapfx::Context::external(eglGetProcAddress);
        const lapfx::Scene scene = lapfx::load_scene(argv[1]);
        lapfx::Effects effects(organ_of(scene), lapfx::load_preset(argv[2]),
                               {.seed = static_cast<std::uint32_t>(scene.seed),
                                .gravity = scene.gravity,
                                .clip_folders = {argv[3]},
                                .wait_for_clips = true});
        effects.set_organ_color(scene.organ.color);
        effects.set_curves(scene.curves);
        effects.set_contacts(scene.events);
        lapfx::Frame frame;
        effects.seek(std::atof(argv[6]));  // once for both eyes
        const double half = std::atof(argv[7]) / 2.0;
        const Picture left = drawn(effects, frame, scene, size, -half);
        write_side_by_side(left, drawn(effects, frame, scene, size, half), size);
    } catch (const lapfx::Error& error) {
        std::fprintf(stderr, "lapfx_host_stereo: %s\n", error.what());
        return error.failure() == lapfx::Failure::no_gl ? 77 : error.failure() == lapfx::Failure::bad_input ? 2 : 1;
    }
}
