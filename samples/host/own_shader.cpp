// A host that keeps its own organ shader and adds lapfx's blood to it: plain Lambert, no textures, and the bleeding shader's
// text pasted in. It renders one frame of a scene to a binary PPM on standard output; tests/e2e compares the blood in it with
// that of `lapfx render`.
//
//     lapfx_host_own_shader samples/lagb.scene.json presets/brisk_bleed.json 6 320 256 > frame.ppm
#include <glad/gl.h>
#include <lapfx/effects.h>
#include <lapfx/refine.h>
#include <lapfx/scene.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace {

constexpr const char* vertex_text = R"(#version 450 core
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_blood;
layout(location = 0) uniform mat4 u_to_clip;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_blood;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_blood = a_blood;
    gl_Position = u_to_clip * vec4(a_position, 1.0);
}
)";

// Follows "#version" and lapfx::bleeding_shader().
constexpr const char* fragment_text = R"(
in vec3 v_position;
in vec3 v_normal;
in vec2 v_blood;
layout(location = 1) uniform vec3 u_eye;
out vec4 o_color;
void main() {
    vec3 normal = normalize(v_normal), albedo = vec3(0.55, 0.33, 0.28);
    LapfxBlood blood = lapfx_blood(v_blood, vec3(0.0), v_position, normal);
    albedo = mix(albedo, blood.color, blood.coverage * blood.opacity);
    normal = normalize(normal - blood.coverage * blood.slope);
    o_color = vec4(albedo * (0.1 + abs(dot(normal, normalize(u_eye - v_position)))), 1.0);
}
)";

GLuint shader(GLenum stage, const std::string& text) {
    const GLuint name = glCreateShader(stage);
    const char* const source = text.c_str();
    glShaderSource(name, 1, &source, nullptr);
    glCompileShader(name);
    GLint compiled = 0;
    glGetShaderiv(name, GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        char log[4096];
        glGetShaderInfoLog(name, sizeof log, nullptr, log);
        throw lapfx::Error(lapfx::Failure::runtime, lapfx::Fault{.file = "own shader", .place = "", .reason = log});
    }
    return name;
}

GLuint link_program() {
    const GLuint program = glCreateProgram();
    glAttachShader(program, shader(GL_VERTEX_SHADER, vertex_text));
    glAttachShader(program,
                   shader(GL_FRAGMENT_SHADER, "#version 450 core\n" + lapfx::bleeding_shader() + fragment_text));
    glLinkProgram(program);
    return program;
}

template <typename T>
GLuint buffer_of(const std::vector<T>& data) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), 0);
    return name;
}

GLuint vertex_array(const lapfx::Organ& organ, const lapfx::Effects& effects) {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    const GLuint buffers[] = {buffer_of(organ.positions), buffer_of(organ.normals), effects.bleed_buffer()};
    const GLint components[] = {3, 3, 2};
    for (GLuint i = 0; i < 3; ++i) {
        glVertexArrayVertexBuffer(name, i, buffers[i], 0, components[i] * static_cast<GLsizei>(sizeof(float)));
        glVertexArrayAttribFormat(name, i, components[i], GL_FLOAT, GL_FALSE, 0);
        glEnableVertexArrayAttrib(name, i);
    }
    glVertexArrayElementBuffer(name, buffer_of(organ.indices));
    return name;
}

/// A picture to draw into: colour that is sRGB-encoded on the way in, and depth.
void bind_frame(int width, int height) {
    GLuint color = 0, depth = 0, framebuffer = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &color);
    glTextureStorage2D(color, 1, GL_SRGB8_ALPHA8, width, height);
    glCreateTextures(GL_TEXTURE_2D, 1, &depth);
    glTextureStorage2D(depth, 1, GL_DEPTH_COMPONENT32F, width, height);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
    glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void draw(const lapfx::Scene& scene, const lapfx::Organ& organ, const lapfx::Effects& effects, double aspect) {
    const lapfx::SceneCamera& camera = scene.camera;
    const glm::mat4 to_clip(glm::perspective(glm::radians(camera.field_of_view), aspect, 2.0, 5000.0) *
                            glm::lookAt(camera.eye, camera.target, camera.up));
    const glm::vec3 eye(camera.eye);
    const GLuint program = link_program();
    glProgramUniformMatrix4fv(program, 0, 1, GL_FALSE, glm::value_ptr(to_clip));
    glProgramUniform3fv(program, 1, 1, glm::value_ptr(eye));
    glUseProgram(program);
    glBindVertexArray(vertex_array(organ, effects));
    effects.bind_bleeding();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(organ.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void write_ppm(int width, int height) {
    std::vector<unsigned char> pixels(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::printf("P6\n%d %d\n255\n", width, height);
    const std::size_t row = 3 * static_cast<std::size_t>(width);
    for (std::size_t y = static_cast<std::size_t>(height); y-- > 0;) std::fwrite(&pixels[y * row], 1, row, stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: lapfx_host_own_shader SCENE PRESET SECONDS WIDTH HEIGHT > frame.ppm\n");
        return 2;
    }
    try {
        const lapfx::Scene scene = lapfx::load_scene(argv[1]);
        const int width = std::atoi(argv[4]), height = std::atoi(argv[5]);
        const lapfx::Context context = lapfx::Context::create(lapfx::Backend::osmesa);
        // Refined, so that blood shows on long triangles too: on those of the file only where it reaches their corners.
        const lapfx::Organ organ =
            lapfx::refine(lapfx::load_organ(scene.folder / scene.organ.file,
                                            {.scale = scene.organ.scale, .rotation = scene.organ.rotation}))
                .organ;
        lapfx::Preset preset = lapfx::load_preset(argv[2]);
        preset.smoke.clips.clear();  // this host wants blood only
        lapfx::Effects effects(
            organ, preset,
            {.seed = static_cast<std::uint32_t>(scene.seed), .gravity = scene.gravity, .clip_folders = {}});
        effects.set_contacts(scene.events);
        effects.seek(std::atof(argv[3]));
        bind_frame(width, height);
        draw(scene, organ, effects, static_cast<double>(width) / height);
        write_ppm(width, height);
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults())
            std::fprintf(stderr, "lapfx_host_own_shader: %s\n", fault.text().c_str());
        return static_cast<int>(error.failure());
    }
    return 0;
}
