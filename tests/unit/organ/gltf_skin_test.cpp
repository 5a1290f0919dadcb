// A skinned mesh lies where its joints are, not where its node is.
#include "organ/gltf_skin.h"

#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

using nlohmann::json;

/// Column by column.
std::vector<float> scaled(float by, glm::vec3 moved = glm::vec3(0.0f)) {
    return {by, 0, 0, 0, 0, by, 0, 0, 0, 0, by, 0, moved.x, moved.y, moved.z, 1};
}

/// The triangle with a skin of two joints below an armature: nodes 0 armature, 1 mesh, 2 and 3 joints.
class GltfSkin : public testing::Test {
  protected:
    void SetUp() override {
        triangle.json["nodes"] = {
            {{"children", {1, 2, 3}}}, {{"mesh", 0}, {"skin", 0}}, json::object(), json::object()};
        const std::vector<std::uint8_t> joints{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
        const std::vector<float> weights{1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0};
        json& attributes = triangle.primitive()["attributes"];
        attributes["JOINTS_0"] = triangle.add_accessor(bytes_of(joints), 5121, 3, "VEC4");
        attributes["WEIGHTS_0"] = triangle.add_accessor(bytes_of(weights), 5126, 3, "VEC4");
        triangle.json["skins"] = {{{"joints", {2, 3}}}};
        bind({scaled(1), scaled(1)});
    }
    void bind(const std::vector<std::vector<float>>& matrices) {
        std::string bytes;
        for (const auto& matrix : matrices) bytes += bytes_of(matrix);
        triangle.json["skins"][0]["inverseBindMatrices"] =
            triangle.add_accessor(bytes, 5126, static_cast<int>(matrices.size()), "MAT4");
    }
    Organ load() { return load_organ(folder.write("t.glb", triangle.file())); }
    std::string fault() { return fault_of(folder.write("t.glb", triangle.file())); }
    static void expect_near(glm::vec3 found, glm::vec3 wanted) {
        EXPECT_LT(glm::distance(found, wanted), 1e-3F) << found.x << ' ' << found.y << ' ' << found.z;
    }

    Triangle triangle;
    TemporaryFolder folder;
    static constexpr const char* as_modelled = "the file has a skeleton: the surface is shown as it was modelled";
    static constexpr const char* posed =
        "the file has a skeleton: the surface is shown in the pose that its joints have in the file";
};

TEST_F(GltfSkin, TheNodeOfTheMeshMovesNothing) {
    triangle.json["nodes"][1]["scale"] = {100, 100, 100};
    triangle.json["nodes"][1]["translation"] = {0.05, 0.03, 0};
    const Organ organ = load();
    expect_near(organ.positions[1], {100, 0, 0});
    expect_near(organ.positions[2], {0, 100, 0});
    EXPECT_EQ(organ.normals[0], glm::vec3(0, 0, 1));
    EXPECT_TRUE(has_warning(organ.warnings, as_modelled));
}

TEST_F(GltfSkin, TheArmatureMovesTheJoints) {
    triangle.json["nodes"][0]["scale"] = {0.01, 0.01, 0.01};
    expect_near(load().positions[1], {1, 0, 0});
    EXPECT_TRUE(has_warning(load().warnings, posed));
    EXPECT_FALSE(has_warning(load().warnings, as_modelled));
    bind({scaled(100), scaled(100)});  // as it was bound
    expect_near(load().positions[1], {100, 0, 0});
    EXPECT_TRUE(has_warning(load().warnings, as_modelled));
}

TEST_F(GltfSkin, AVertexIsBetweenItsJoints) {
    triangle.json["nodes"][3]["translation"] = {0, 0.2, 0};
    expect_near(load().positions[2], {0, 200, 0});
    expect_near(load().positions[1], {100, 0, 0});
    bind({scaled(1), scaled(1, {0, -0.1f, 0})});
    expect_near(load().positions[2], {0, 150, 0});
}

TEST_F(GltfSkin, WithoutInverseBindMatricesTheJointsWereBoundAtTheOrigin) {
    triangle.json["skins"][0].erase("inverseBindMatrices");
    triangle.json["nodes"][2]["translation"] = {0, 0, 0.5};
    expect_near(load().positions[1], {100, 0, 500});
    triangle.json["skins"][0]["inverseBindMatrices"] = nullptr;
    expect_near(load().positions[1], {100, 0, 500});
}

TEST_F(GltfSkin, AMirroredPoseStillFacesOutwards) {
    triangle.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Organ organ = load();
    expect_near(organ.positions[organ.indices[0]], {0, 0, 0});
    const glm::vec3 a = organ.positions[organ.indices[0]], b = organ.positions[organ.indices[1]],
                    c = organ.positions[organ.indices[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0F);
    EXPECT_EQ(organ.normals[0], glm::vec3(0, 0, 1));
}

TEST_F(GltfSkin, WithoutJointsAndWeightsTheNodeCounts) {
    triangle.primitive()["attributes"].erase("WEIGHTS_0");
    triangle.json["nodes"][1]["scale"] = {2, 2, 2};
    expect_near(load().positions[1], {200, 0, 0});
    EXPECT_FALSE(has_warning(load().warnings, "skeleton"));
}

TEST_F(GltfSkin, WhatIsNotInTheFileIsNamed) {
    const auto with = [&](const char* pointer, const json& value) {
        const json before = triangle.json;
        triangle.json[json::json_pointer(pointer)] = value;
        const std::string text = fault();
        triangle.json = before;
        return text;
    };
    EXPECT_EQ(with("/nodes/1/skin", 4), "/meshes/0/primitives/0: skin 4 is not in the file");
    EXPECT_EQ(with("/skins/0/joints/1", 9), "/skins/0/joints/1: node 9 is not in the file");
    EXPECT_EQ(with("/skins/0/joints/1", "x"), "/skins/0/joints/1: is \"x\", expected a whole number");
    EXPECT_EQ(with("/skins/0/joints", {2}),
              "/meshes/0/primitives/0/attributes/JOINTS_0: names a joint that is not in its skin of 1 joint");
    EXPECT_EQ(with("/skins/0/inverseBindMatrices", 0),
              "/skins/0/inverseBindMatrices: has elements of 3 components, expected 16");
    EXPECT_EQ(with("/meshes/0/primitives/0/attributes/JOINTS_0", 0),
              "/meshes/0/primitives/0/attributes/JOINTS_0: has elements of 3 components, expected 4");
    EXPECT_EQ(with("/nodes/2/children", {2}), "/nodes/2: is its own ancestor");
}

TEST_F(GltfSkin, AJointThatIsNotInTheSkinIsNamedByItsSet) {
    const std::vector<std::uint8_t> joints{0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0};
    const std::vector<float> weights{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
    json& attributes = triangle.primitive()["attributes"];
    attributes["JOINTS_1"] = triangle.add_accessor(bytes_of(joints), 5121, 3, "VEC4");
    attributes["WEIGHTS_1"] = triangle.add_accessor(bytes_of(weights), 5126, 3, "VEC4");
    EXPECT_EQ(fault(), "/meshes/0/primitives/0/attributes/JOINTS_1: names a joint that is not in its skin of 2 joints");
}

TEST_F(GltfSkin, MatricesThatNoJointNeedsAreNotRead) {
    bind({scaled(1), scaled(1), scaled(1)});
    expect_near(load().positions[1], {100, 0, 0});
    json& accessor = triangle.json["accessors"].back();
    accessor["count"] = 1;
    EXPECT_EQ(fault(), "/skins/0/inverseBindMatrices: has 1 element, expected 2 to 65536");
    accessor.erase("bufferView");
    accessor["count"] = 65537;
    EXPECT_EQ(fault(), "/skins/0/inverseBindMatrices: has 65537 elements, expected 2 to 65536");
}

TEST_F(GltfSkin, OfReportsAllAreAsLargeAndWhereThePlainOneIs) {
    const fs::path reports = data_folder() / "reports" / "skin";
    if (!fs::exists(reports)) GTEST_SKIP() << "the data is not here";
    const Organ plain = load_organ(reports / "plain.glb");
    for (const char* name : {"mesh_node_scale_100.glb", "mesh_node_moved.glb", "armature_scale_001.glb"}) {
        const Organ organ = load_organ(reports / name);
        ASSERT_EQ(organ.positions.size(), plain.positions.size()) << name;
        for (std::size_t i = 0; i < plain.positions.size(); ++i)
            ASSERT_LT(glm::distance(organ.positions[i], plain.positions[i]), 1e-2F) << name;
    }
}

}  // namespace
}  // namespace lapfx::test
