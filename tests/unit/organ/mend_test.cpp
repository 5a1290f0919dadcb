// Mending, completing, reports.
#include "lapfx/authoring/organ_report.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

Organ load(const std::string& text) {
    const TemporaryFolder folder;
    return load_organ(folder.write("m.obj", text));
}

TEST(Mend, EachKindIsCounted) {
    const Organ organ =
        load(std::string(cube_obj).append("v 5 5 5\n"             // unused
                                          "v 20 0 0\nv 30 0 0\n"  // on a line with the first
                                          "f 1 10 11\n"           // no area
                                          "f 4 3 2\nf 3 2 4\n"    // repeated, with its corners rotated
                                          "f 2 3 4\n"));          // its back: another triangle
    EXPECT_EQ(organ.triangle_count(), 13u);
    EXPECT_TRUE(has_warning(organ.warnings, "1 triangle without area left out"));
    EXPECT_TRUE(has_warning(organ.warnings, "3 vertices belong to no triangle; left out"));
    EXPECT_EQ(organ.positions.size(), 8u);
}

TEST(Mend, DuplicateTriangles) {
    const Organ organ = load("v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 2 3 1\nf 3 1 2\n");
    EXPECT_EQ(organ.triangle_count(), 1u);
    EXPECT_TRUE(has_warning(organ.warnings, "2 triangles are in the file more than once; drawn once"));
}

TEST(Complete, NormalsAreSmoothAcrossSplitVertices) {
    // The cube's corners, each face with its own texture coordinates.
    std::string text(cube_obj, std::strchr(cube_obj, 'f'));
    text +=
        "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        "f 4/1 3/2 2/3 1/4\nf 5/1 6/2 7/3 8/4\nf 1/1 2/2 6/3 5/4\nf 2/2 3/3 7/4 6/1\nf 3/3 4/4 8/1 7/2\nf "
        "4/2 1/3 5/4 8/1\n";
    const Organ organ = load(text);
    EXPECT_GT(organ.positions.size(), 8u);
    for (std::size_t v = 0; v < organ.positions.size(); ++v) {
        EXPECT_NEAR(glm::length(organ.normals[v]), 1.0f, 1e-5f);
        // Outwards, and the same at every copy of a corner, except for how a quad is split.
        EXPECT_GT(glm::dot(organ.normals[v], organ.positions[v] - glm::vec3(5)), 0.0f);
        for (std::size_t w = 0; w < v; ++w) {
            if (organ.positions[w] == organ.positions[v]) {
                EXPECT_EQ(organ.normals[w], organ.normals[v]);
            }
        }
    }
}

/*  u grows to the right and v down in the image, y of a normal map up: on an unmirrored square the tangent is
   +x, the bitangent +y and w = 1. Mirrored in u, the tangent turns and w with it.  */
TEST(Complete, TangentsFollowTheTexture) {
    const std::string square = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\n";
    const Organ plain = load(square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    for (const glm::vec4& t : plain.tangents) EXPECT_EQ(t, glm::vec4(1, 0, 0, 1));
    const Organ mirrored = load(square + "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n");
    for (const glm::vec4& t : mirrored.tangents) EXPECT_EQ(t, glm::vec4(-1, 0, 0, -1));
}

TEST(Complete, MadeCoordinatesRepeatEvery50Millimetres) {
    const Organ organ = load("v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n");
    EXPECT_FALSE(organ.has_uvs);
    EXPECT_EQ(organ.uvs[1] - organ.uvs[0], glm::vec2(2, 0));
    EXPECT_EQ(organ.uvs[2] - organ.uvs[0], glm::vec2(0, -2));
    for (const glm::vec4& t : organ.tangents) EXPECT_EQ(t, glm::vec4(1, 0, 0, 1));
}

TEST(Complete, CoordinatesThatAreAllAlikeAreReplaced) {
    const Organ organ = load("v 0 0 0\nv 100 0 0\nv 0 100 0\nvt 0.5 0.5\ng lobe\nf 1/1 2/1 3/1\n");
    EXPECT_FALSE(organ.has_uvs);
    EXPECT_EQ(organ.uvs[1] - organ.uvs[0], glm::vec2(2, 0));
    EXPECT_TRUE(has_warning(organ.warnings, "part lobe: its texture coordinates cover no area; new ones were made"));
}

TEST(Complete, BothSidesOfASheetHaveNormals) {
    const Organ organ = load("v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 1 3 2\n");
    for (const glm::vec3& n : organ.normals) EXPECT_NEAR(std::abs(n.z), 1.0f, 1e-6f);
}

TEST(Report, ComponentsAndSize) {
    const Organ organ = load("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 7\nv 9 0 7\nv 0 9 7\nf 1 2 3\nf 4 5 6\n");
    const OrganReport r = report(organ);
    EXPECT_EQ(r.components, 2u);
    EXPECT_EQ(r.boundary_edges, 6u);
    EXPECT_EQ(r.minimum, glm::dvec3(0));
    EXPECT_EQ(r.maximum, glm::dvec3(9, 9, 7));
    EXPECT_TRUE(r.warnings.empty());
}

TEST(Report, SizesThatAnOrganCannotHave) {
    const TemporaryFolder folder;
    for (const auto& [size, odd] :
         {std::pair{"4.9", true}, {"5", false}, {"600", false}, {"601", true}, {"980", true}}) {
        const std::string s = size;
        const Organ organ = load_organ(folder.write("m.obj", "v 0 0 0\nv " + s + " 0 0\nv 0 4 0\nf 1 2 3\n"));
        EXPECT_EQ(has_warning(report(organ).warnings, "unusual for an organ (5 to 600 mm)"), odd) << size;
    }
}

TEST(Report, SizeThatCannotBeNamesAScale) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("m.obj", "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nf 1 2 3\n");
    EXPECT_EQ(report(load_organ(file)).warnings,
              std::vector<std::string>{
                  "its longest side is 0.2 mm, which is unusual for an organ (5 to 600 mm); is the unit wrong? scale "
                  "1000 would make it 200 mm"});
    EXPECT_TRUE(has_warning(report(load_organ(file, {.scale = 1e5})).warnings, "scale 1000 would make it 200 mm"));
    EXPECT_TRUE(report(load_organ(file, {.scale = 1000.0})).warnings.empty());
}

}  // namespace
}  // namespace lapfx::test
