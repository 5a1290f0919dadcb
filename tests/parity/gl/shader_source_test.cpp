#include "gl/shader_source.h"

#include <gmock/gmock.h>

#include "gl/program.h"
#include "support/gpu_test.h"
#include "unit/preset/support.h"

namespace lapfx::gl {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A temporary shader folder.
class ShaderFolder : public test::GpuTest {
  protected:
    void SetUp() override {
        test::GpuTest::SetUp();
        set_shader_folder(folder.path());
    }
    void TearDown() override {
        set_shader_folder("");
        test::GpuTest::TearDown();
    }
    test::Folder folder;

    static std::vector<std::string> faults(const std::string& vertex, const std::string& fragment) {
        return test::faults_of([&] { Program(vertex, fragment); }, Failure::runtime);
    }
};

TEST_F(ShaderFolder, AMistakeIsNamedByFileAndLineWithItsSource) {
    folder.write("bad.frag",
                 "#version 450 core\nlayout(location = 0) out vec4 o_color;\nvoid main() {\n    float fine = 1.0;\n"
                 "    o_color = vec4(wrong_name);\n    // after\n}\n");
    const auto lines = faults("fullscreen.vert", "bad.frag");
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines[0], "bad.frag: the shader does not compile");
    EXPECT_THAT(lines, Contains(testing::AllOf(testing::StartsWith("bad.frag:5"), HasSubstr("wrong_name"))));
    EXPECT_THAT(lines, Contains("    3 | void main() {"));
    EXPECT_THAT(lines, Contains("    4 |     float fine = 1.0;"));
    EXPECT_THAT(lines, Contains("  > 5 |     o_color = vec4(wrong_name);"));
    EXPECT_THAT(lines, Contains("    6 |     // after"));
}

TEST_F(ShaderFolder, AMistakeInAnIncludedFileIsNamedThere) {
    folder.write("part.glsl", "// one\n// two\nfloat part() { return missing; }\n");
    folder.write(
        "whole.frag",
        "#version 450 core\n#include \"color.glsl\"\n#include \"part.glsl\"\nlayout(location = 0) out vec4 o;\n"
        "void main() { o = vec4(part()); }\n");
    const auto lines = faults("fullscreen.vert", "whole.frag");
    EXPECT_THAT(lines, Contains(testing::StartsWith("part.glsl:3")));
    EXPECT_THAT(lines, Contains("  > 3 | float part() { return missing; }"));
    folder.write("part.glsl", "float part() { return 1.0; }\n");
    folder.write(
        "whole.frag",
        "#version 450 core\n#include \"part.glsl\"\n#include \"color.glsl\"\nlayout(location = 0) out vec4 o;\n"
        "void main() {\n    o = vec4(part()) + behind;\n}\n");
    EXPECT_THAT(faults("fullscreen.vert", "whole.frag"), Contains("  > 6 |     o = vec4(part()) + behind;"))
        << "the lines after the includes are still counted from the top";
}

TEST_F(ShaderFolder, StagesThatDoNotFitAreNamedTogether) {
    folder.write("apart.frag",
                 "#version 450 core\nlayout(location = 0) in vec3 v_uv;\nuniform int u_a;\nvoid undefined_function();\n"
                 "layout(location = 0) out vec4 o;\nvoid main() { undefined_function(); o = vec4(v_uv, u_a); }\n");
    EXPECT_THAT(faults("fullscreen.vert", "apart.frag"),
                Contains("fullscreen.vert + apart.frag: the shader does not compile"));
}

TEST_F(ShaderFolder, AMissingFileIsNamedWithWhatIncludesIt) {
    folder.write("a.frag", "#version 450 core\n#include \"nowhere.glsl\"\nvoid main() {}\n");
    EXPECT_THAT(faults("fullscreen.vert", "a.frag"),
                ElementsAre("a.frag: the shader file \"nowhere.glsl\" is missing"));
    EXPECT_THAT(faults("none.vert", "a.frag"), ElementsAre("none.vert: the shader file \"none.vert\" is missing"));
}

TEST_F(ShaderFolder, FilesThereComeFirstAndTheRestIsEmbedded) {
    folder.write("color.glsl", "vec3 mine() { return vec3(1.0); }\n");
    EXPECT_THAT(shader_source("color.glsl").text, HasSubstr("mine()"));
    EXPECT_THAT(shader_source("noise.glsl").text, HasSubstr("lapfx_perlin"));
    set_shader_folder("");
    EXPECT_THAT(shader_source("color.glsl").text, HasSubstr("lapfx_to_linear"));
}

TEST_F(ShaderFolder, AFileIsIncludedOnceHoweverOftenItIsNamed) {
    folder.write("a.glsl", "#include \"b.glsl\"\nfloat a;\n");
    folder.write("b.glsl", "#include \"a.glsl\"\nfloat b;\n");
    folder.write("top.frag", "#version 450 core\n#include \"a.glsl\"\n#include \"b.glsl\"\nend\n");
    const ShaderSource source = shader_source("top.frag");
    EXPECT_EQ(source.files, (std::vector<std::string>{"top.frag", "a.glsl", "b.glsl"}));
    EXPECT_EQ(source.text,
              "#version 450 core\n#line 1 1\n#line 1 2\n#line 2 2\nfloat b;\n#line 2 1\nfloat a;\n#line 3 0\n#line 4 "
              "0\nend\n");
}

TEST_F(ShaderFolder, EveryShippedProgramCompiles) {
    for (const auto& [vertex, fragment] : {std::pair{"organ.vert", "organ.frag"},
                                           {"wounded.vert", "wounded.frag"},
                                           {"plume.vert", "plume.frag"},
                                           {"fullscreen.vert", "haze.frag"},
                                           {"fullscreen.vert", "post.frag"}})
        EXPECT_THAT(faults(vertex, fragment), testing::IsEmpty()) << fragment;
}

}  // namespace
}  // namespace lapfx::gl
