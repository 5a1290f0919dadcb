// No triangle is lost silently: in every format the triangles read are those kept and those left out, by reason.
#include <limits>
#include <sstream>

#include "support/folders.h"
#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

/// read, kept, unreadable, out of range, not finite, without area, repeated
using Row = std::array<std::size_t, 7>;

Row row_of(const Organ& organ) {
    const TriangleCounts& c = organ.counts;
    EXPECT_EQ(c.read, c.kept + c.dropped());
    EXPECT_EQ(c.kept, organ.triangle_count());
    return {c.read, c.kept, c.unreadable, c.out_of_range, c.not_finite, c.without_area, c.repeated};
}

class Counts : public testing::Test {
  protected:
    Row row(const char* name, const std::string& content, double scale = 0.0) {
        return row_of(load_organ(folder.write(name, content), {.scale = scale}));
    }
    TemporaryFolder folder;
};

TEST_F(Counts, Obj) {
    EXPECT_EQ(row("m.obj", cube_obj), (Row{12, 12, 0, 0, 0, 0, 0}));
    EXPECT_EQ(row("m.obj", std::string(cube_obj) + "v nan 0 0\n"
                                                   "f 1 2\nf 1 x 3\nf 1 2 3 y 5\n"  // 1, 1 and 3 that cannot be read
                                                   "f 1 2 99\nf 1 2 3 99\n"         // 1 and 2 with a missing vertex
                                                   "f 1 2 9\n"                      // NaN
                                                   "f 1 1 2\nf 1 2 1 2\n"           // 1 and 2 on a line
                                                   "f 4 3 2\n"),                    // there already
              (Row{25, 12, 5, 3, 1, 3, 1}));
}

/* A normal or a texture coordinate that cannot be read, or that there is none of, never costs the triangle.  */
TEST_F(Counts, ObjWithNormalsAndTextureCoordinatesThatAreNone) {
    const std::string cube = cube_obj;
    for (const char* corner : {"3/1/0", "3/1/99", "3//0", "3/0/1", "3/99", "3/x/y", "3/-9/-9", "3/1/1/7", "3/"})
        EXPECT_EQ(row("m.obj", cube + "vt 0 0\nvn 0 0 1\nv 9 9 9\nf 9/1/1 2/1/1 " + corner + "\n"),
                  (Row{13, 13, 0, 0, 0, 0, 0}))
            << corner;
    EXPECT_EQ(row("m.obj", cube + "v 9 9 9\nf 9 2 0/1\n"), (Row{13, 12, 1, 0, 0, 0, 0}));
}

TEST_F(Counts, Ply) {
    EXPECT_EQ(row("m.ply",
                  "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                  "element face 6\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n9 0 0\n9 9 0\n0 9 0\n18 0 0\n"
                  "4 0 1 2 3\n2 0 1\n0\n3 0 1 4\n3 0 1 7\n3 1 2 0\n"),
              (Row{7, 2, 2, 1, 0, 1, 1}));
}

TEST_F(Counts, Off) {
    EXPECT_EQ(
        row("m.off", "OFF\n5 5 0\n0 0 0\n9 0 0\n9 9 0\n0 9 0\n18 0 0\n4 0 1 2 3\n2 0 1\n3 0 1 4\n3 0 1 7\n3 1 2 0\n"),
        (Row{6, 2, 1, 1, 0, 1, 1}));
}

TEST_F(Counts, Stl) {
    const auto facet = [](const std::vector<float>& corners) {
        return bytes_of<float>({0, 0, 1}) + bytes_of(corners) + std::string(2, '\0');
    };
    const std::string good = facet({0, 0, 0, 9, 0, 0, 9, 9, 0});
    EXPECT_EQ(row("m.stl", std::string(80, ' ') + word(4) + good + facet({0, 0, 0, 9, 0, 0, 9, 0, 0}) +
                               facet({0, 0, 0, 9, 0, 0, 18, 0, 0}) + good),
              (Row{4, 1, 0, 0, 0, 2, 1}));
    const auto text = [](const char* a, const char* b, const char* c) {
        return std::string("facet normal 0 0 1\nouter loop\nvertex ") + a + "\nvertex " + b + "\nvertex " + c +
               "\nendloop\nendfacet\n";
    };
    EXPECT_EQ(
        row("m.stl", "solid s\n" + text("0 0 0", "9 0 0", "0 9 0") + text("0 0 0", "9 0 0", "9 0 0") + "endsolid s\n"),
        (Row{2, 1, 0, 0, 0, 1, 0}));
}

/* Also where two such corners are equal: no place is theirs.  */
TEST_F(Counts, StlThatIsNotFinite) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    std::string binary = std::string(80, ' ') + word(6), text = "solid s\n";
    const auto add = [&](const std::vector<float>& corners) {
        binary += bytes_of<float>({0, 0, 1}) + bytes_of(corners) + std::string(2, '\0');
        text += "facet normal 0 0 1\n  outer loop\n";
        for (std::size_t i = 0; i < 9; i += 3) {
            std::ostringstream line;
            line << "  vertex " << corners[i] << ' ' << corners[i + 1] << ' ' << corners[i + 2] << '\n';
            text += line.str();
        }
        text += "  endloop\nendfacet\n";
    };
    add({0, 0, 0, 9, 0, 0, 9, 9, 0});
    add({nan, 0, 0, 9, 0, 0, 9, 9, 0});
    add({nan, nan, nan, nan, nan, nan, 9, 9, 0});
    add({inf, 0, 0, inf, 0, 0, -inf, 0, 0});
    add({nan, 0, 0, 9, 0, 0, 9, 0, 0});
    add({9, 0, 0, 9, 0, 0, 9, 9, 0});
    const Row row_of_both{6, 1, 0, 0, 4, 1, 0};
    EXPECT_EQ(row("binary.stl", binary), row_of_both);
    EXPECT_EQ(row("text.stl", text + "endsolid s\n"), row_of_both);
    // A corner that is not a number, and a missing one; the facet after them is complete.
    EXPECT_EQ(row("text.stl",
                  "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\nvertex 9 0 0\nvertex 9 9 0\nendloop\n"
                  "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nendloop\nendfacet\n"
                  "FACET NORMAL 0 0 1\nOuter Loop\nVERTEX 0 0 0\nVERTEX 9 0 0\nVERTEX 9 9 0\nENDLOOP\nENDFACET\n"
                  "endsolid s\n"),
              (Row{3, 1, 0, 0, 2, 0, 0}));
}

TEST_F(Counts, StlWhoseNameHoldsWordsOfTheFormat) {
    const std::string facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\n";
    for (const char* name : {"outer_liver", "the outer loop", "vertex 1 2 3", "nan", ""})
        for (const char* end : {"endsolid ", "end solid ", "EndSolid "})
            EXPECT_EQ(row("m.stl", std::string("solid ") + name + '\n' + facet + end + name + '\n'),
                      (Row{1, 1, 0, 0, 0, 0, 0}))
                << name;
    EXPECT_EQ(load_organ(folder.path() / "m.stl").positions[1], glm::vec3(9, 0, 0));
}

TEST_F(Counts, Gltf) {
    Triangle triangle;
    triangle.primitive()["indices"] =
        triangle.add_accessor(bytes_of<std::uint16_t>({0, 1, 2, 0, 1, 7, 0, 1, 1, 1, 2, 0, 0, 1}), 5123, 14, "SCALAR");
    const Organ organ = load_organ(folder.write("t.glb", triangle.file()));
    EXPECT_EQ(row_of(organ), (Row{5, 1, 1, 1, 0, 1, 1}));
    EXPECT_TRUE(has_warning(organ.warnings, "1 primitive ends within a triangle, which is left out"));
}

/* Thin, but not flat: in millimetres, or a tenth of them, rounding would make another number of them flat.  */
TEST_F(Counts, DoNotDependOnTheScale) {
    std::string text;
    for (int i = 0; i < 2000; ++i) {
        const double x = 1000.0 + 0.37 * i, bend = 3e-6 * (i % 40);
        char line[200];
        std::snprintf(line, sizeof line, "v %.9g 500 0\nv %.9g %.9g 0\nv %.9g 500.1 0\nf -3 -2 -1\n", x, x + 0.1,
                      500.05 + bend, x + 0.2);
        text += line;
    }
    const Row one = row("m.obj", text);
    EXPECT_GT(one[5], 0u) << "some are flat";
    EXPECT_GT(one[1], 0u) << "and some are not";
    for (const double scale : {0.1, 0.001, 25.4, 1000.0}) EXPECT_EQ(row("m.obj", text, scale), one) << scale;
}

TEST_F(Counts, SampleFiles) {
    for (const char* name : {"lagb.glb", "liver_lobe.glb", "hook_cautery.glb"}) {
        const Organ organ = load_organ(source_folder() / "samples" / name);
        EXPECT_GT(row_of(organ)[0], 0u) << name;
        EXPECT_EQ(organ.counts.dropped(), 0u) << name;
    }
}

}  // namespace
}  // namespace lapfx::test
