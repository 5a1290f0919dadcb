#include "lapfx/prepared_organ.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "foundation.h"
#include "lapfx/amounts.h"
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/authoring/tissue_report.h"
#include "support/meshes.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

/// A plane with a texture of stripes, so that there is a density to be filtered.
Organ striped() {
    Organ organ = test::plane(40.0, 40);
    Image image{.width = 64, .height = 64, .pixels = {}, .name = "stripes"};
    for (int i = 0; i < 64 * 64; ++i)
        for (const int value : {i / 4 % 2 == 0 ? 150 : 90, 40, 40, 255})
            image.pixels.push_back(static_cast<std::uint8_t>(value));
    organ.images = {image};
    organ.materials[0].base_color_image = 0;
    for (std::size_t v = 0; v < organ.uvs.size(); ++v)
        organ.uvs[v] = glm::vec2(organ.positions[v].x, organ.positions[v].z) / 40.0f + 0.5f;
    return organ;
}

VesselParameters fine_vessels() {
    VesselParameters vessels;
    vessels.vessel_low = 0.0;
    vessels.vessel_high = 0.02;
    vessels.smoothing = 0.1;
    return vessels;
}

TEST(PreparedOrgan, ProgressAscendsToTheEnd) {
    std::vector<double> shares;
    const auto made = prepare_organ(striped(), {}, [&](double share) {
        shares.push_back(share);
        return true;
    });
    ASSERT_NE(made, nullptr);
    ASSERT_GT(shares.size(), 8U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_GT(made->memory(), 64U * 64 * 4);
}

TEST(PreparedOrgan, CanBeStoppedWhereverItAsks) {
    int asked = 0;
    prepare_organ(striped(), {}, [&](double) { return ++asked > 0; });
    for (int stop = 1; stop <= asked; ++stop) {
        int count = 0;
        EXPECT_EQ(prepare_organ(striped(), {}, [&](double) { return ++count < stop; }), nullptr);
        EXPECT_EQ(count, stop) << "nothing is asked after that";
    }
}

TEST(PreparedOrgan, CopiesOfItsTissueAreSetOnTheirOwn) {
    const auto made = prepare_organ(striped());
    bleeding::TissueDensity first = PreparedOrganAccess::state(*made).foundation->tissue, copy = first;
    first.set({});
    const glm::dvec3 place(3.0, 0.0, 5.0);
    const double before = first.vessels(place);
    EXPECT_GT(before, 0.0);
    const VesselParameters other = fine_vessels();
    copy.set(other);
    EXPECT_NE(copy.vessels(place), before);
    EXPECT_EQ(first.vessels(place), before);
    copy.set({});
    EXPECT_EQ(copy.vessels(place), before);
}

TEST(PreparedOrgan, CopiesOfItsTissueThatAreSetToTheSameShareTheirMaps) {
    constexpr std::size_t texels = 64 * 64, map = 2 * texels;
    const auto made = prepare_organ(striped());
    const bleeding::TissueDensity& shared = PreparedOrganAccess::state(*made).foundation->tissue;
    const std::size_t per_vertex = made->organ().positions.size() * sizeof(glm::vec2);
    const std::size_t all = shared.shared_memory();
    bleeding::TissueDensity first = shared, second = shared;
    first.set({});
    second.set({});
    EXPECT_EQ(first.map(0)->values().data(), second.map(0)->values().data());
    EXPECT_EQ(first.own_memory(), per_vertex);
    EXPECT_EQ(shared.shared_memory(), all) << "what was made at first is theirs";
    first.set(fine_vessels());
    EXPECT_EQ(first.own_memory(), per_vertex) << "the newest is the one that is shared";
    EXPECT_EQ(second.own_memory(), per_vertex + map);
    second.set(fine_vessels());
    EXPECT_EQ(second.own_memory(), per_vertex);
    EXPECT_EQ(first.map(0)->values().data(), second.map(0)->values().data());
    EXPECT_EQ(shared.shared_memory(), all);
}

TEST(PreparedOrgan, EachByteIsCountedOnce) {
    constexpr std::size_t texels = 64 * 64;
    const auto made = prepare_organ(striped());
    const Organ& organ = made->organ();
    EXPECT_TRUE(organ.images[0].pixels.empty());
    const std::size_t vertices = organ.positions.size(), triangles = organ.triangle_count();
    ASSERT_EQ(vertices, 41U * 41);
    ASSERT_EQ(triangles, 2U * 40 * 40) << "it is not split";
    const std::size_t edges = vertices + triangles - 1;  // Euler
    // Positions, normals, tangents, texture coordinates, colours; corners.
    const std::size_t given = vertices * (12 + 12 + 16 + 8 + 16) + triangles * 12;
    // Each vertex is a point: where, of which vertex, which vertex, in which piece, where its vertices, triangles and
    // neighbours begin; corners, and the triangles and neighbours of each point.
    const std::size_t joined = vertices * (24 + 6 * 4) + 3 * 4 + triangles * (12 + 12) + edges * 2 * 4;
    // What has its colours from where; texture coordinates, area, redness, colour and what the overlay shows at a
    // vertex.
    const std::size_t mesh = triangles * (4 + 12) + vertices * (8 + 4 + 4 + 12 + 8);
    // Two bytes of densities and a bit for whether it is on the surface.
    const std::size_t densities = 2 * texels + texels / 8;
    EXPECT_EQ(made->memory(), given + joined + mesh + densities + 4 * texels);
    EXPECT_EQ(PreparedOrganAccess::state(*made).foundation->pixel_memory(), 4 * texels);
}

TEST(PreparedOrgan, ItsInstrumentsTexturesCountAsPixels) {
    const test::Folder folder;
    cv::imwrite((folder / "steel.png").string(), cv::Mat(16, 32, CV_8UC3, cv::Scalar(90, 80, 70)));
    folder.write("m.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n");
    folder.write("t.obj", "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n");
    folder.write("t.mtl", "newmtl a\nmap_Kd steel.png\n");
    Scene scene;
    scene.folder = folder.path();
    scene.organ.file = "m.obj";
    const std::size_t without = prepare_organ(scene)->memory();
    scene.tool.file = "t.obj";
    const auto made = prepare_organ(scene);
    ASSERT_EQ(PreparedOrganAccess::state(*made).tool->images.size(), 1U);
    EXPECT_TRUE(PreparedOrganAccess::state(*made).tool->images[0].pixels.empty());
    EXPECT_EQ(PreparedOrganAccess::state(*made).tool->images[0].width, 32);
    const std::size_t pixels = 32U * 16 * 4 + std::filesystem::file_size(folder / "steel.png");
    EXPECT_EQ(PreparedOrganAccess::state(*made).tool_pixel_memory(), pixels);
    EXPECT_EQ(made->memory(), without + pixels + 3 * (64 + 4)) << "and three corners";
}

TEST(PreparedOrgan, TellsTheFilesThatItIsMadeOf) {
    const test::Folder folder;
    folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 10 0 0\nv 0 10 0\nusemtl a\nf 1 2 3\n");
    folder.write("m.mtl", "newmtl a\nmap_Kd gone.png\n");
    Scene scene;
    scene.folder = folder.path();
    scene.organ.file = "m.obj";
    EXPECT_THAT(files_of(*prepare_organ(scene)),
                testing::ElementsAre(folder / "m.obj", folder / "m.mtl", folder / "gone.png"))
        << "also what is missing: it may come";
    scene.organ.file = "none.obj";
    EXPECT_EQ(test::faults_of([&] { prepare_organ(scene); }, Failure::bad_input).size(), 1U);
}

TEST(PreparedOrgan, AmountsAndHistogramOfItAreThoseOfTheOrgan) {
    const Organ organ = striped();
    VesselParameters before;
    before.vessel_width = 3.0;
    const auto made = prepare_organ(striped(), before);
    VesselParameters narrow;
    narrow.vessel_width = 1.0;
    const TissueHistogram wanted = tissue_histogram(organ, narrow), found = tissue_histogram(*made, narrow);
    EXPECT_EQ(found.contrast, wanted.contrast);
    EXPECT_EQ(found.hue, wanted.hue);
    EXPECT_NE(found.contrast, tissue_histogram(*made, before).contrast) << "what is asked for, not what was set";

    Preset preset;
    preset.vessels = narrow;
    const ToolContact cut{.action = ToolAction::cut, .time = 0.5, .duration = 0.5, .position = {1.0, 0.0, 2.0}};
    AmountsModel direct(organ), shared(made);
    for (AmountsModel* model : {&direct, &shared}) model->set(preset, {&cut, 1});
    EXPECT_GT(direct.at(3.0).blood_area, 1.0);
    EXPECT_EQ(shared.at(3.0).blood_area, direct.at(3.0).blood_area);
    EXPECT_EQ(shared.at(3.0).haze, direct.at(3.0).haze);
}

TEST(PreparedOrgan, IsMadeForScenesWithTheSameOrganAndTool) {
    const test::Folder folder;
    folder.write("m.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n");
    Scene scene;
    scene.folder = folder.path();
    scene.organ.file = "m.obj";
    const auto made = prepare_organ(scene);
    Scene other = scene;
    other.gravity = {1.0, 0.0, 0.0};
    other.seed = 7;
    EXPECT_TRUE(made_for(*made, other));
    other.organ.scale = 2.0;
    EXPECT_FALSE(made_for(*made, other));
    other = scene;
    other.tool.file = "hook.glb";
    EXPECT_FALSE(made_for(*made, other));
    other = scene;
    other.folder /= "elsewhere";
    EXPECT_FALSE(made_for(*made, other));
}

}  // namespace
}  // namespace lapfx
