// A host simulator as a stranger would write it: lapfx's public headers, its own window and loop, a thread that reads
// the tool 1000 times a second, its own organ shader ("own"; "lapfx": the core draws), and a preset that may be written
// anew meanwhile. A scene's events are the hand. With SECONDS it writes that frame as a PPM, without a window: as
// `lapfx render`, without the instrument.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <glad/gl.h>  // this host's loader; a simulator has its own
#include <lapfx/clip_cache.h>
#include <lapfx/effects.h>
#include <lapfx/frame.h>
#include <lapfx/refine.h>
#include <lapfx/scene.h>
#include <array>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <mutex>
#include <thread>
#include <utility>

namespace {

constexpr const char* vertex_text = R"(#version 450 core
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_blood;
layout(location = 0) uniform mat4 u_to_clip;
out vec3 v_position, v_normal;
out vec2 v_blood;
void main() {
    v_position = a_position, v_normal = a_normal, v_blood = a_blood;
    gl_Position = u_to_clip * vec4(a_position, 1.0);
})";

constexpr const char* fragment_text = R"(  // plain Lambert
in vec3 v_position, v_normal;
in vec2 v_blood;
layout(location = 1) uniform vec3 u_eye;
out vec4 o_color;
void main() {
    vec3 normal = normalize(v_normal), albedo = vec3(0.55, 0.33, 0.28);
    LapfxBlood blood = lapfx_blood(v_blood, vec3(0.0), v_position, normal);
    albedo = mix(albedo, blood.color, blood.coverage * blood.opacity);
    normal = normalize(normal - blood.coverage * blood.slope);
    o_color = vec4(albedo * (0.1 + abs(dot(normal, normalize(u_eye - v_position)))), 1.0);
})";

void require(bool holds, const char* reason, lapfx::Failure failure = lapfx::Failure::bad_input) {
    if (!holds) throw lapfx::Error(failure, lapfx::Fault{.file = "", .place = "", .reason = reason});
}

GLuint link_program(const std::string& vertex, const std::string& fragment) {
    const GLuint program = glCreateProgram();
    for (const std::string* text : {&vertex, &fragment}) {
        const GLuint shader = glCreateShader(text == &vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        glShaderSource(shader, 1, std::array{text->c_str()}.data(), nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    require(linked != 0, "this host's own shader does not compile", lapfx::Failure::runtime);
    return program;
}

template <typename T>
GLuint buffer_of(const std::vector<T>& data) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), 0);
    return name;
}

std::filesystem::path texture_of(const lapfx::Scene& scene) {
    return scene.organ.texture.empty() ? std::filesystem::path() : scene.folder / scene.organ.texture;
}

void tell(const lapfx::Error& error) {
    std::fprintf(stderr, "lapfx_host: %s\n", error.what());
}

/// A preset's file, read again whenever it is written: on a thread of its own, and its clips too, so that no frame
/// waits.
class PresetFile {
  public:
    /// Before the preset is read for the first time: what is written after that is seen.
    PresetFile(std::filesystem::path file, std::filesystem::path clip_folder)
        : file_(std::move(file)), folders_{std::move(clip_folder)}, read_(written({})) {}
    void watch() {
        std::fprintf(stderr, "lapfx_host: %s may be written anew\n", file_.c_str());
        thread_ = std::jthread([this](const std::stop_token& stop) {
            for (auto before = read_; !stop.stop_requested();
                 std::this_thread::sleep_for(std::chrono::milliseconds(100))) {
                const auto now = written(read_);
                if (now != read_ && now == before) read_ = now, read();  // nobody writes it any more
                before = now;
            }
        });
    }
    std::shared_ptr<lapfx::ClipCache> clips() const { return clips_; }
    /// What has been read and not been taken yet.
    std::optional<lapfx::Preset> take() {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        return lock ? std::exchange(next_, std::nullopt) : std::nullopt;
    }

  private:
    std::filesystem::file_time_type written(std::filesystem::file_time_type if_gone) const {
        std::error_code gone;  // the file is gone for a moment, as some programs write
        const auto when = std::filesystem::last_write_time(file_, gone);
        return gone ? if_gone : when;
    }
    void read() {
        try {
            lapfx::Preset preset = lapfx::load_preset(file_);
            clips_->look_through(preset, folders_);
            const std::lock_guard lock(mutex_);
            next_ = std::move(preset);
        } catch (const lapfx::Error& error) {  // the loop keeps what it has
            tell(error);
        }
    }
    std::filesystem::path file_;
    std::vector<std::filesystem::path> folders_;
    std::shared_ptr<lapfx::ClipCache> clips_ = std::make_shared<lapfx::ClipCache>();
    std::filesystem::file_time_type read_;  // when that was written which has been read
    std::mutex mutex_;
    std::optional<lapfx::Preset> next_;
    std::jthread thread_;
};

struct Host {
    lapfx::Scene scene;
    glm::ivec2 size;
    bool own;
    lapfx::Organ organ;
    lapfx::Effects effects;
    lapfx::Frame frame;
    GLuint program = link_program(vertex_text, "#version 450 core\n" + lapfx::bleeding_shader() + fragment_text);
    GLuint vertices = 0;

    Host(char** arguments, glm::ivec2 pixels, bool wait, const std::shared_ptr<lapfx::ClipCache>& clips)
        : scene(lapfx::load_scene(arguments[1])),
          size(pixels),
          own(std::string(arguments[4]) == "own"),
          organ(lapfx::load_organ(scene.folder / scene.organ.file,
                                  {scene.organ.scale, scene.organ.rotation, texture_of(scene)})),
          effects(own ? organ = lapfx::refine(organ).organ : organ, lapfx::load_preset(arguments[2]),
                  {static_cast<std::uint32_t>(scene.seed), scene.gravity, {arguments[3]}, wait, {}, clips}) {
        effects.set_curves(scene.curves);
        glCreateVertexArrays(1, &vertices);
        const GLuint buffers[] = {buffer_of(organ.positions), buffer_of(organ.normals), effects.bleed_buffer()};
        for (GLuint i = 0; i < 3; ++i) {
            glVertexArrayVertexBuffer(vertices, i, buffers[i], 0, i < 2 ? sizeof(glm::vec3) : sizeof(glm::vec2));
            glVertexArrayAttribFormat(vertices, i, i < 2 ? 3 : 2, GL_FLOAT, GL_FALSE, 0);
            glEnableVertexArrayAttrib(vertices, i);
        }
        glVertexArrayElementBuffer(vertices, buffer_of(organ.indices));
    }

    lapfx::CameraResponse response() const { return {scene.camera.exposure, scene.camera.vignette}; }

    /// All of the frame but its finish.
    void draw(double time) {
        const lapfx::SceneCamera& c = scene.camera;
        const lapfx::SceneLight& l = scene.light;
        const double field = glm::radians(c.field_of_view), aspect = static_cast<double>(size.x) / size.y;
        const lapfx::View view{glm::mat4(glm::lookAt(c.eye, c.target, c.up)),
                               glm::mat4(glm::perspective(field, aspect, 2.0, 5000.0)),
                               {l.intensity, l.focus_distance, l.beam_angle, lapfx::Lamp{}.ambient, l.color}};
        effects.seek(time);
        frame.begin(size);
        own ? draw_organ(view) : effects.draw_organ(view);
        frame.begin_smoke();
        effects.draw_smoke(view, frame.depth());
    }

    void show(const lapfx::Preset& preset) {
        try {
            effects.set_preset(preset);
            std::fprintf(stderr, "lapfx_host: now with \"%s\"\n", preset.name.c_str());
        } catch (const lapfx::Error& error) {  // a clip that cannot be played; it keeps the previous preset
            tell(error);
        }
    }

    void draw_organ(const lapfx::View& view) {
        glProgramUniformMatrix4fv(program, 0, 1, GL_FALSE, glm::value_ptr(view.projection * view.view));
        glProgramUniform3fv(program, 1, 1, glm::value_ptr(glm::vec3(scene.camera.eye)));
        glUseProgram(program);
        glBindVertexArray(vertices);
        glEnable(GL_DEPTH_TEST);
        effects.bind_bleeding();
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(organ.indices.size()), GL_UNSIGNED_INT, nullptr);
        effects.draw_metal_clips(view);
    }
};

GLFWwindow* open_window(glm::ivec2 size) {
    require(glfwInit() == GLFW_TRUE, "no window can be opened", lapfx::Failure::no_gl);
    std::atexit(glfwTerminate);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* const window = glfwCreateWindow(size.x, size.y, "lapfx_host", nullptr, nullptr);
    require(window != nullptr, "no window with OpenGL 4.5 can be opened", lapfx::Failure::no_gl);
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return window;
}

/// The sample of the hand at a time, s.
lapfx::ToolSample sample_at(const lapfx::Scene& scene, double time) {
    for (const lapfx::ToolContact& c : scene.events)
        if (time >= c.time && time < c.end()) return {time, c.tip(time), true, c.action, c.power, c.strength};
    return {.time = time};
}

void run(Host& host, PresetFile& file, GLFWwindow* window) {
    file.watch();
    int samples = 0, frames = 0;
    glfwSetTime(0.0);
    std::jthread hand([&](const std::stop_token& stop) {  // 1 kHz, independent of frames, on the device's own clock
        auto tick = std::chrono::steady_clock::now();
        for (int ms = 0; ms <= 1000 * host.scene.duration && !stop.stop_requested(); ++ms) {
            if (host.effects.tool_queue().push(sample_at(host.scene, 1e-3 * ms))) ++samples;
            std::this_thread::sleep_until(tick += std::chrono::milliseconds(1));
        }
    });
    for (; glfwGetTime() < host.scene.duration && glfwWindowShouldClose(window) == 0; ++frames, glfwPollEvents()) {
        if (const auto preset = file.take()) host.show(*preset);
        host.draw(glfwGetTime());
        host.frame.finish(0, host.response());
        glfwSwapBuffers(window);
    }
    if (glfwWindowShouldClose(window) == 0) hand.join();  // the hand may be behind on a busy computer
    hand = {};                                            // stopped and joined
    host.effects.seek(host.scene.duration);
    const lapfx::Amounts amounts = host.effects.amounts();
    std::printf("%d samples, %d lost, %d frames, %d wounds, %.1f mm2 of blood\n", samples,
                static_cast<int>(amounts.lost_samples), frames, amounts.wounds, amounts.blood_area);
}

void write_picture(Host& host, double time) {
    std::vector<lapfx::ToolContact> events = host.scene.events;
    std::ranges::stable_sort(events, {}, &lapfx::ToolContact::time);
    for (std::size_t i = 0; i < events.size() && events[i].time <= time; host.effects.seek(events[i++].time))
        host.effects.set_contacts(std::span(events).first(i + 1));  // each contact comes as the hand continues
    host.draw(time);
    std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(host.size.x) * static_cast<std::size_t>(host.size.y));
    host.frame.read(pixels, host.response());
    std::printf("P6\n%d %d\n255\n", host.size.x, host.size.y);
    for (std::size_t i = 0; i < pixels.size(); i += 4) std::fwrite(&pixels[i], 1, 3, stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        require(argc == 7 || argc == 8, "usage: lapfx_host SCENE PRESET CLIPS own|lapfx WIDTH HEIGHT [SECONDS]");
        const glm::ivec2 size(std::atoi(argv[5]), std::atoi(argv[6]));
        GLFWwindow* const window = argc == 7 ? open_window(size) : nullptr;
        const auto context = window != nullptr ? lapfx::Context::external(glfwGetProcAddress)
                                               : lapfx::Context::create(lapfx::Backend::osmesa);
        gladLoadGL(context.get_proc_address());
        PresetFile file(argv[2], argv[3]);
        Host host(argv, size, window == nullptr, file.clips());
        window != nullptr ? run(host, file, window) : write_picture(host, std::atof(argv[7]));
    } catch (const lapfx::Error& error) {
        tell(error);
        return error.failure() == lapfx::Failure::no_gl ? 77 : error.failure() == lapfx::Failure::bad_input ? 2 : 1;
    }
}
