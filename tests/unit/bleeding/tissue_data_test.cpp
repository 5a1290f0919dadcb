// Vessel and fat density on real organs. The folder is not a part of the project; set LAPFX_TEST_DATA to its path.
#include "bleeding/tissue_density.h"
#include "lapfx/authoring/tissue_report.h"
#include "support/folders.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

class TissueData : public testing::Test {
  protected:
    void SetUp() override {
        folder = data_folder();
        if (folder.empty()) GTEST_SKIP() << "no folder of test meshes; LAPFX_TEST_DATA names it";
    }
    /// These name their textures in "../textures", which an organ may not read, so the test puts the picture next to
    /// the mesh.
    fs::path with_texture(const std::string& name) {
        const fs::path from = folder / "organs/Warp-Surgical";
        for (const char* extension : {".obj", ".mtl"})
            fs::copy_file(from / "derived" / (name + extension), beside.path() / (name + extension));
        const std::string picture = name == "fat" ? "diffuse-base.png" : "diffuse-damage.png";
        fs::copy_file(from / "textures" / name / picture, beside.path() / picture);
        return beside.path() / (name + ".obj");
    }
    fs::path folder;
    TemporaryFolder beside;
};

/// In this file an artery is a separate mesh, pure red, on a dark red heart; veins are blue.
TEST_F(TissueData, CoronaryArteriesStandOutOfTheHeart) {
    const Organ organ = load_organ(folder / "organs/whynpc9-anatomy/coronary-circulation.glb");
    const Surface surface(organ);
    const bleeding::TissueDensity tissue(organ, surface);
    double sums[3] = {};
    int counts[3] = {};
    for (const Part& part : organ.parts) {
        const std::string& name = organ.materials[static_cast<std::size_t>(part.material)].name;
        const int kind = name == "Arteries_Mat" ? 0 : name == "Vein_mat" ? 1 : 2;
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            sums[kind] += static_cast<double>(tissue.vertex_values()[organ.indices[i]].x);
            ++counts[kind];
        }
    }
    ASSERT_TRUE(counts[0] > 0 && counts[1] > 0 && counts[2] > 0);
    EXPECT_GT(sums[0] / counts[0], 0.5) << "arteries";
    EXPECT_LT(sums[1] / counts[1], 0.1) << "veins are blue here";
    EXPECT_LT(sums[2] / counts[2], 0.03) << "heart";
}

TEST_F(TissueData, SharesOfRealOrgans) {
    struct Row {
        const char* file;
        double scale, known, vessels_least, vessels_most, fat_least, fat_most;
    };
    // The Warp organs (without a folder here) are half a unit large. Their gallbladder shows no vessels, and their fat
    // a few strong ones.
    constexpr Row rows[] = {{"fat", 200, 1, 0.0003, 0.01, 0.9, 1},
                            {"gallbladder", 150, 1, 0, 0.001, 0, 0.01},
                            {"whynpc9-anatomy/liver.glb", 220, 1, 0.03, 0.15, 0, 0.05},
                            {"HuBMAP-CCF/VH_F_Heart.glb", 0, 0, 0, 0, 0, 0}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.file);
        const TissueReport report = report_tissue(
            load_organ(fs::path(row.file).has_extension() ? folder / "organs" / row.file : with_texture(row.file),
                       {.scale = row.scale}));
        EXPECT_NEAR(report.known, row.known, 1e-9);
        EXPECT_GE(report.vessels, row.vessels_least);
        EXPECT_LE(report.vessels, row.vessels_most);
        EXPECT_GE(report.fat, row.fat_least);
        EXPECT_LE(report.fat, row.fat_most);
    }
}

TEST_F(TissueData, FaintVesselsOfRealFatAreFoundWithALowerBand) {
    const Organ organ = load_organ(with_texture("fat"), {.scale = 200});
    VesselParameters faint;
    faint.vessel_low = 0.06;
    faint.vessel_high = 0.15;
    faint.smoothing = 0.15;
    const double found = report_tissue(organ, faint).vessels;
    EXPECT_GT(found, 0.01);
    EXPECT_LT(found, 0.08);
}

/// The sample organ is part of the project.
TEST(TissueOfTheSample, VesselsAndFatAreWhereTheyWerePainted) {
    const Organ organ = load_organ(source_folder() / "samples/lagb.glb");
    const Surface surface(organ);
    const bleeding::TissueDensity tissue(organ, surface);
    const TissueReport report = tissue.report();
    EXPECT_NEAR(report.vessels, 0.0102, 0.002);
    EXPECT_NEAR(report.fat, 0.228, 0.02);
    const auto density = [&](const char* material, glm::vec2 uv) {
        for (const Material& m : organ.materials)
            if (m.name == material) return tissue.map(m.base_color_image)->sample(uv);
        ADD_FAILURE() << material;
        return glm::vec2(0.0f);
    };
    // The two great stems of the stomach, between them muscle, fat beside them; the membrane and its fat; the liver.
    EXPECT_GT(density("stomach", {0.217f, 0.30f}).x + density("stomach", {0.225f, 0.30f}).x, 0.9f);
    EXPECT_LT(density("stomach", {0.45f, 0.50f}).x, 0.05f);
    EXPECT_LT(density("stomach", {0.45f, 0.50f}).y, 0.05f);
    float fat = 0.0f;
    for (int i = 0; i < 8; ++i) fat += density("stomach", {0.06f + 0.012f * static_cast<float>(i), 0.32f}).y / 8.0f;
    EXPECT_GT(fat, 0.5f);
    EXPECT_GT(density("lesser omentum", {0.9f, 0.75f}).y, 0.8f);
    EXPECT_LT(density("lesser omentum", {0.35f, 0.05f}).y, 0.1f);
    EXPECT_LT(density("liver", {0.5f, 0.5f}).y, 0.01f);
}

}  // namespace
}  // namespace lapfx::test
