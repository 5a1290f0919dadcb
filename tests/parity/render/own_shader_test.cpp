// What a host with its own organ shader gets: the text, the vertex buffer and the uniform block.
#include "gl/objects.h"
#include "gl/program.h"
#include "gl/shader_source.h"
#include "lapfx/effects.h"
#include "parity/render/host_shader.h"
#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

class OwnShader : public test::SceneTest {};

TEST_F(OwnShader, TheTextStandsAlone) {
    const std::string text = bleeding_shader();
    for (const char* const word : {"#version", "#include", "#line", "v_blood", "u_view"})
        EXPECT_EQ(text.find(word), std::string::npos) << word;
    const std::string own =
        "\nin vec2 v_in;\nout vec4 o_color;\nvoid main() {\n"
        "    LapfxBlood b = lapfx_blood(v_in, vec3(0.0), vec3(v_in, 0.0), vec3(0.0, 0.0, 1.0));\n"
        "    o_color = vec4(b.color * b.coverage + b.opacity + b.slope, b.depth + b.clot + b.gloss + b.level) *\n"
        "        lapfx_blood_film(0.1, 1.0, b.spread).wetness;\n}\n";
    for (const char* const version : {"#version 420 core\n", "#version 450 core\n"}) {
        const GLuint shader = test::host_shader(GL_FRAGMENT_SHADER, version + text + own);
        glDeleteShader(shader);
    }
}

TEST_F(OwnShader, TheBufferHoldsBleedValuesAndTheBlockIsBound) {
    const Organ organ = test::plane(80.0, 60);
    preset.smoke.clips.clear();
    preset.bleeding.gravity_bias = 0.0;
    preset.bleeding.speed = 4.0;
    Effects effects(organ, preset, {.seed = 3, .gravity = {0.0, -1.0, 0.0}, .clip_folders = {}});
    const GLuint name = effects.bleed_buffer();
    const ToolContact cut{.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = {}, .to = {}};
    effects.set_contacts({&cut, 1});
    effects.seek(2.0);
    EXPECT_EQ(effects.bleed_buffer(), name);
    std::vector<glm::vec2> values(organ.positions.size());
    glGetNamedBufferSubData(name, 0, static_cast<GLsizeiptr>(values.size() * sizeof(glm::vec2)), values.data());
    int wet = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = 8.0 - glm::length(glm::dvec3(organ.positions[i]));  // speed * time - distance
        if (expected < 0.0) continue;
        ++wet;
        EXPECT_NEAR(values[i].x, expected, 0.15) << "vertex " << i;
    }
    EXPECT_GT(wet, 80);

    glBindBufferBase(GL_UNIFORM_BUFFER, 1, 0);
    effects.bind_bleeding();
    GLint bound = 0;
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 1, &bound);
    ASSERT_NE(bound, 0);
    float edge[4] = {};
    glGetNamedBufferSubData(static_cast<GLuint>(bound), 0, sizeof edge, edge);
    EXPECT_FLOAT_EQ(edge[0], static_cast<float>(preset.bleeding.threshold));
    EXPECT_FLOAT_EQ(edge[2], static_cast<float>(preset.bleeding.noise_strength));
}

}  // namespace
}  // namespace lapfx
