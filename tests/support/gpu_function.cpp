#include "support/gpu_function.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gl/shader_source.h"
#include "unit/preset/support.h"

namespace lapfx::test {

namespace {

constexpr int width = 256;

gl::Program compile(const std::vector<std::string>& includes, const std::string& expression,
                    const std::string& declarations) {
    std::string text = "#version 450 core\n";
    for (const std::string& file : includes) text += "#include \"" + file + "\"\n";
    text +=
        "layout(binding = 0) uniform sampler2D u_inputs;\nuniform vec4 u_0, u_1, u_2;\n"
        "layout(location = 0) out vec4 o_result;\n" +
        declarations +
        "\nvoid main() {\n    vec4 a = texelFetch(u_inputs, ivec2(gl_FragCoord.xy), 0);\n    o_result = " + expression +
        ";\n}\n";
    const Folder folder;
    folder.write("probe.frag", text);
    gl::set_shader_folder(folder.path());
    try {
        gl::Program program("fullscreen.vert", "probe.frag");
        gl::set_shader_folder("");
        return program;
    } catch (...) {
        gl::set_shader_folder("");
        throw;
    }
}

}  // namespace

GpuFunction::GpuFunction(const std::vector<std::string>& includes, const std::string& expression,
                         const std::string& declarations)
    : program_(compile(includes, expression, declarations)) {}

std::vector<glm::vec4> GpuFunction::operator()(std::span<const glm::vec4> inputs,
                                               const std::array<glm::vec4, 3>& parameters) const {
    const int height = static_cast<int>((inputs.size() + width - 1) / width);
    std::vector<glm::vec4> texels(inputs.begin(), inputs.end());
    texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const gl::Texture source({.size = {width, height}, .format = GL_RGBA32F, .filter = GL_NEAREST});
    const gl::Texture target({.size = {width, height}, .format = GL_RGBA32F, .filter = GL_NEAREST});
    glTextureSubImage2D(source.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, texels.data());
    const gl::Framebuffer framebuffer(target, nullptr);
    const gl::VertexArray no_attributes;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glViewport(0, 0, width, height);
    for (const GLenum state : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST}) glDisable(state);
    glBindTextureUnit(0, source.name());
    glBindVertexArray(no_attributes.name());
    program_.set("u_0", parameters[0]);
    program_.set("u_1", parameters[1]);
    program_.set("u_2", parameters[2]);
    program_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glGetTextureImage(target.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)),
                      texels.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    texels.resize(inputs.size());
    return texels;
}

void expect_near(std::span<const glm::vec4> inputs, std::span<const glm::vec4> cpu, std::span<const glm::vec4> gpu,
                 int component, double tolerance, const std::string& what) {
    ASSERT_EQ(inputs.size(), cpu.size());
    ASSERT_EQ(inputs.size(), gpu.size());
    double worst = -1.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double error = std::abs(static_cast<double>(cpu[i][component]) - gpu[i][component]);
        if (!(error <= worst)) {
            worst = error;
            at = i;
        }
        if (std::isnan(error)) break;
    }
    const glm::vec4 input = inputs[at];
    EXPECT_LE(worst, tolerance) << what << ": largest difference at input (" << input.x << ", " << input.y << ", "
                                << input.z << ", " << input.w << "): CPU " << cpu[at][component] << ", GPU "
                                << gpu[at][component];
}

}  // namespace lapfx::test
