#include "gl/program.h"

#include <gmock/gmock.h>

#include "gl/shader_source.h"
#include "support/gpu_test.h"
#include "unit/preset/support.h"

namespace lapfx::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ProgramTest : public test::GpuTest {
  protected:
    void TearDown() override {
        set_shader_folder("");
        test::GpuTest::TearDown();
    }
    template <typename T>
    static std::vector<std::string> faults(const Program& program, const char* uniform, const T& value) {
        return test::faults_of([&] { program.set(uniform, value); }, Failure::runtime);
    }
    /// The shader has this value.
    static float value_of(const Program& program, const char* uniform) {
        float value = -1.0f;
        glGetUniformfv(program.name(), glGetUniformLocation(program.name(), uniform), &value);
        return value;
    }
};

TEST_F(ProgramTest, AValueOfTheDeclaredTypeArrives) {
    const Program program("resolve.vert", "resolve.frag", "#define LAPFX_EVEN\n");
    program.set("u_even", 1.5f);
    program.set("u_scene_depth", 0);
    program.set("u_color", glm::vec3(0.5f));
    EXPECT_EQ(value_of(program, "u_even"), 1.5f);
}

TEST_F(ProgramTest, AnUnknownUniformIsRefused) {
    const Program program("resolve.vert", "resolve.frag", "#define LAPFX_EVEN\n");
    EXPECT_THAT(faults(program, "u_eve", 1.5f),
                ElementsAre("resolve.vert + resolve.frag: u_eve: is set, but not declared as a uniform"));
    EXPECT_THAT(faults(program.rebuilt(), "u_eve", 1.5f), testing::SizeIs(1));
}

TEST_F(ProgramTest, AValueOfAnotherTypeIsRefusedAndTheOldOneStays) {
    const Program program("resolve.vert", "resolve.frag", "#define LAPFX_EVEN\n");
    program.set("u_even", 1.5f);
    EXPECT_THAT(
        faults(program, "u_even", glm::vec3(2.0f)),
        ElementsAre("resolve.vert + resolve.frag: u_even: a value of type vec3 is set; it is declared as float"));
    EXPECT_THAT(faults(program, "u_even", 2),
                ElementsAre("resolve.vert + resolve.frag: u_even: a value of type int is set; it is declared as "
                            "float"));
    EXPECT_THAT(faults(program, "u_scene_depth", 0.0f), testing::SizeIs(1)) << "a sampler's unit is an int";
    EXPECT_EQ(value_of(program, "u_even"), 1.5f);
}

// organ.vert does not use all uniforms of organ.frag, and a variant of a shader may not use those of another.
TEST_F(ProgramTest, ADeclaredUniformThatTheCompilerLeftOutIsSetInVain) {
    const Program program("resolve.vert", "resolve.frag", "#define LAPFX_PLUME\n");
    ASSERT_EQ(glGetUniformLocation(program.name(), "u_even"), -1) << "the plume has come to use it: choose another";
    EXPECT_THAT(faults(program, "u_even", 1.0f), IsEmpty());
    EXPECT_THAT(faults(program, "u_even", glm::vec3(1.0f)), testing::SizeIs(1)) << "its type is checked all the same";
    EXPECT_THAT(faults(program, "u_evn", 1.0f), testing::SizeIs(1));
}

// Uniforms unknown to GL are found in the code of the text, wherever its lines end.
TEST_F(ProgramTest, WhatIsDeclaredIsToldFromCommentsBlocksAndOtherWords) {
    const Program program(
        "fullscreen.vert", "post.frag",
        "/* uniform float u_in_block_comment; */ // uniform float u_in_line_comment;\n"
        "/* several\nlines uniform float u_in_lines; */ uniform /* of */ float u_after_comment; // and\n"
        "uniform uint\n    u_count,\n    u_list[3], u_last; uniform int u_initial = 3, u_after_it;\n"
        "layout(std140, binding = 5) uniform Block { float u_member; };\n"
        "const float not_uniform = 1.0, uniform_not = 2.0;\n");
    for (const char* uniform : {"u_initial", "u_after_it"})
        EXPECT_THAT(faults(program, uniform, 1), IsEmpty()) << uniform;
    EXPECT_THAT(faults(program, "u_after_comment", 1.0f), IsEmpty());
    for (const char* uniform : {"u_count", "u_list", "u_last"})
        EXPECT_THAT(faults(program, uniform, 1), ElementsAre(std::string("fullscreen.vert + post.frag: ") + uniform +
                                                             ": a value of type int is set; it is declared as uint"));
    for (const char* uniform : {"u_in_block_comment", "u_in_line_comment", "u_in_lines", "u_member", "not_uniform",
                                "uniform_not", "u_cou", "uint", "3", ""})
        EXPECT_THAT(faults(program, uniform, 1), testing::SizeIs(1)) << uniform;
}

// Names and types come from GL, so it does not matter how a text spells them.
TEST_F(ProgramTest, AUniformThatAMacroDeclaresIsKnownWithItsType) {
    const Program program("fullscreen.vert", "post.frag", "#define u_frame u_picture\n");
    EXPECT_THAT(faults(program, "u_picture", 1), IsEmpty());
    EXPECT_THAT(faults(program, "u_picture", 1.0f),
                ElementsAre("fullscreen.vert + post.frag: u_picture: a value of type float is set; it is declared as "
                            "sampler2D"));
}

TEST_F(ProgramTest, WhileAShaderIsEditedOnDiskItsUniformsComeAndGo) {
    const test::Folder folder;
    folder.write(
        "edited.frag",
        "#version 450 core\n// uniform float u_gone;\nuniform vec4 u_a, u_b[2];\nuniform uint u_n; uniform bool u_on;\n"
        "layout(location = 0) out vec4 o;\nvoid main() { o = u_a + u_b[0] + u_b[1] + float(u_n) + float(u_on); }\n");
    set_shader_folder(folder.path());
    const Program program("fullscreen.vert", "edited.frag");
    EXPECT_THAT(faults(program, "u_gone", 1.0f), IsEmpty());
    EXPECT_THAT(faults(program, "u_a", 1.0f), IsEmpty());
    program.set("u_a", glm::vec4(0.25f));
    EXPECT_EQ(value_of(program, "u_a"), 0.25f) << "of several in a line";
    program.set("u_b", glm::vec4(0.5f));
    EXPECT_EQ(value_of(program, "u_b"), 0.5f);
    EXPECT_THAT(faults(program, "u_n", 3), IsEmpty());
    EXPECT_EQ(value_of(program, "u_n"), 0.0f) << "an int is no uint: GL would refuse it";
    program.set("u_on", 1);
    EXPECT_EQ(value_of(program, "u_on"), 1.0f) << "a bool takes an int";
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace lapfx::gl
