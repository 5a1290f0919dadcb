// make_organ(): organs of a host's own arrays.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "lapfx/amounts.h"
#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/refine.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A square of two triangles, a vertex without a triangle between them, and one triangle without area.
struct Square {
    std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {0, 1, 0}, {1, 1, 0}};
    std::vector<std::uint32_t> indices{0, 1, 4, 0, 0, 1, 0, 4, 3};
    Mesh mesh() const { return {.positions = positions, .indices = indices}; }
};

TEST(MakeOrgan, KeepsTheVerticesOfTheHostAndMakesWhatIsMissing) {
    const Square square;
    const Organ organ = make_organ(square.mesh(), {.scale = 10.0, .rotation = {0.0, 0.0, 90.0}});
    ASSERT_EQ(organ.positions.size(), 5u);
    EXPECT_NEAR(organ.positions[1].x, 0.0f, 1e-5f);  // turned about z
    EXPECT_NEAR(organ.positions[1].y, 10.0f, 1e-5f);
    EXPECT_THAT(organ.indices, ElementsAre(0, 1, 4, 0, 4, 3));
    EXPECT_EQ(organ.parts.at(0).index_count, 6u);
    EXPECT_EQ(organ.counts.read, 3u);
    EXPECT_EQ(organ.counts.without_area, 1u);
    EXPECT_THAT(organ.warnings, ElementsAre("1 triangle has no area: left out"));
    for (const glm::vec3& normal : organ.normals) EXPECT_NEAR(normal.z, 1.0f, 1e-6f);
    for (const glm::vec4& tangent : organ.tangents)
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-5f) << "also that of the vertex without a triangle";
    EXPECT_FALSE(organ.has_uvs);
    EXPECT_NE(organ.uvs[0], organ.uvs[1]);
    EXPECT_EQ(organ.name, "organ");
    EXPECT_EQ(organ.scale, 10.0);
}

TEST(MakeOrgan, TakesWhatIsGiven) {
    const Square square;
    const std::vector<glm::vec3> normals(5, {0, 3, 4});
    const std::vector<glm::vec2> uvs{{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 1}};
    const std::vector<glm::vec4> colors(5, {0.5, 0.25, 0.125, 1});
    const Image image{.width = 1, .height = 1, .pixels = {1, 2, 3, 255}, .name = "pixel"};
    Mesh mesh = square.mesh();
    mesh.normals = normals, mesh.uvs = uvs, mesh.colors = colors, mesh.images = {&image, 1}, mesh.name = "liver";
    mesh.material.base_color_image = 0;
    const Organ organ = make_organ(mesh);
    EXPECT_EQ(organ.normals[0], glm::vec3(0.0f, 0.6f, 0.8f));
    EXPECT_EQ(organ.uvs, uvs);
    EXPECT_EQ(organ.colors, colors);
    EXPECT_TRUE(organ.has_uvs && organ.has_colors);
    EXPECT_EQ(organ.images.at(0).pixels, image.pixels);
    EXPECT_EQ(organ.name, "liver");
    EXPECT_EQ(organ.scale, 1.0);
}

/// What a host has filled by hand is refused wherever an organ is used, not read beyond its end.
TEST(MakeOrgan, AnOrganWhoseArraysDoNotFitIsRefused) {
    const auto told = [](void (*spoil)(Organ&)) {
        Organ organ = test::plane(10.0, 4);
        organ.name = "by hand";
        spoil(organ);
        std::string text;
        const auto refused = [&](auto use) {
            try {
                use();
                ADD_FAILURE() << "not refused";
            } catch (const Error& error) {
                EXPECT_EQ(error.failure(), Failure::bad_input);
                text = error.what();
            }
        };
        refused([&] { AmountsModel model(organ); });
        refused([&] { prepare_organ(organ); });
        refused([&] { refine(organ); });
        return text;
    };
    EXPECT_EQ(told([](Organ& o) { o.indices[4] = 25; }), "by hand: indices/4: 25; there are 25 positions");
    EXPECT_EQ(told([](Organ& o) { o.indices.pop_back(); }), "by hand: indices: 95; each triangle has three");
    EXPECT_EQ(told([](Organ& o) { o.normals.clear(); }), "by hand: normals: 0; there are 25 positions");
    EXPECT_EQ(told([](Organ& o) { o.tangents.pop_back(); }), "by hand: tangents: 24; there are 25 positions");
    EXPECT_EQ(told([](Organ& o) { o.uvs.clear(); }), "by hand: uvs: 0; there are 25 positions");
    EXPECT_EQ(told([](Organ& o) { o.colors.clear(); }), "by hand: colors: 0; there are 25 positions");
    EXPECT_EQ(told([](Organ& o) { o.positions[7].y = std::numeric_limits<float>::quiet_NaN(); }),
              "by hand: positions/7: nan is not a number from -1e9 to 1e9");
    EXPECT_EQ(told([](Organ& o) { o.parts[0].index_count += 3; }),
              "by hand: parts/0: 99 from 0 on; there are 96 indices, three for each triangle");
    EXPECT_EQ(told([](Organ& o) { o.parts[0].first_index = 0xfffffffd; }),
              "by hand: parts/0: 96 from 4294967293 on; there are 96 indices, three for each triangle");
    EXPECT_EQ(told([](Organ& o) { o.parts[0].material = -1; }), "by hand: parts/0/material: -1; there are 1 materials");
    EXPECT_EQ(told([](Organ& o) { o.materials[0].normal_image = 2; }),
              "by hand: materials/0: 2; there are 0 images, and -1 is none");
    EXPECT_EQ(told([](Organ& o) {
                  o.images = {{.width = 2, .height = 2, .pixels = {1, 2}, .name = ""}};
              }),
              "by hand: images/0: 2x2 with 2 bytes; four for each pixel are needed");
}

TEST(MakeOrgan, BleedsAsTheSameOrganOfAFile) {
    const Organ plane = test::plane(60.0, 30);
    const ToolContact cut{.action = ToolAction::cut, .position = {0.0, 0.0, 0.0}, .to = {0.0, 0.0, 0.0}};
    const auto area_of = [&](const Organ& organ) {
        AmountsModel model(organ);
        model.set(Preset{}, {&cut, 1});
        return model.at(3.0).blood_area;
    };
    std::vector<glm::vec3> positions = plane.positions;
    positions.insert(positions.end(), 3, glm::vec3(1.0f, 0.5f, 2.0f));  // without a triangle, close to the wound
    const double area = area_of(plane);
    EXPECT_GT(area, 10.0);
    EXPECT_NEAR(area_of(make_organ({.positions = positions, .indices = plane.indices})), area, 1e-3 * area);
}

std::string refusal(const Mesh& mesh, const OrganOptions& options = {}) {
    try {
        make_organ(mesh, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return error.what();
    }
    return "it was accepted";
}

TEST(MakeOrgan, RefusesWhatDoesNotFitTogether) {
    const Square square;
    const auto with = [&](auto change) {
        Square other = square;
        change(other);
        return refusal(other.mesh());
    };
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(with([&](Square& s) { s.positions[3].y = nan; }),
              "organ: positions/3: nan is not a number from -1000000000.000000 to 1000000000.000000");
    EXPECT_THAT(with([&](Square& s) { s.positions[2].z = -inf; }),
                HasSubstr("organ: positions/2: -inf is not a number"));
    EXPECT_THAT(with([](Square& s) { s.indices[4] = 5; }), HasSubstr("organ: indices/4: 5; there are 5 positions"));
    EXPECT_EQ(with([](Square& s) { s.indices.pop_back(); }),
              "organ: indices: 8; three for each of 1 to 20000000 triangles are needed");
    EXPECT_THAT(with([](Square& s) { s.indices.clear(); }), HasSubstr("organ: indices: 0; three for each"));
    EXPECT_EQ(with([](Square& s) { s.indices = {0, 0, 1}; }), "organ: indices: no triangle has an area");

    const std::vector<glm::vec3> four(4, {0, 0, 1});
    Mesh mesh = square.mesh();
    mesh.normals = four;
    EXPECT_EQ(refusal(mesh), "organ: normals: 4; there are 5 positions");
    mesh = square.mesh();
    mesh.material.normal_image = 0;
    EXPECT_EQ(refusal(mesh), "organ: material/normal_image: 0; there are 0 images, and -1 is none");
    const Image image{.width = 2, .height = 2, .pixels = {1, 2, 3, 255}, .name = "too few"};
    mesh = square.mesh();
    mesh.images = {&image, 1};
    EXPECT_EQ(refusal(mesh), "organ: images/0: 2x2 with 4 bytes; four for each pixel are needed, up to 32768x32768");
    EXPECT_EQ(refusal(square.mesh(), {.scale = -1.0}), "organ: scale -1.000000 is not above 0");
    EXPECT_EQ(refusal(square.mesh(), {.rotation = {0.0, std::nan(""), 0.0}}),
              "organ: rotation nan is not a number of degrees");
}

}  // namespace
}  // namespace lapfx
