// Samplers: what a texture shows beyond its edges.
#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "organ/load.h"
#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

using nlohmann::json;

class GltfSampler : public testing::Test {
  protected:
    void SetUp() override {
        cv::imwrite((folder.path() / "skin.png").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
        triangle.json["images"] = {{{"uri", "skin.png"}}};
        triangle.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}}, {{"wrapS", 10497}}, {{"wrapT", 7}}};
        triangle.json["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 0}}, {{"source", 0}, {"sampler", 1}}};
        const auto material = [](int texture) {
            return json{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}};
        };
        triangle.json["materials"] = {material(0), material(1), material(2)};
        triangle.primitive()["attributes"]["TEXCOORD_0"] =
            triangle.add_accessor(bytes_of<float>({-1, 0, 2, 0, 0, 2}), 5126, 3, "VEC2");
        triangle.primitive()["material"] = 0;
    }
    Organ load() { return load_organ(folder.write("t.glb", triangle.file())); }
    static const Image& image_of(const Organ& organ, std::size_t material) {
        return organ.images.at(static_cast<std::size_t>(organ.materials.at(material).base_color_image));
    }
    Triangle triangle;
    TemporaryFolder folder;
};

TEST_F(GltfSampler, AnImageIsThereForEachWayToContinueIt) {
    const Organ organ = load();
    ASSERT_EQ(organ.images.size(), 2u);
    EXPECT_EQ(image_of(organ, 0).wrap_u, Wrap::clamp);
    EXPECT_EQ(image_of(organ, 0).wrap_v, Wrap::mirror);
    EXPECT_EQ(image_of(organ, 1).wrap_u, Wrap::repeat);
    EXPECT_EQ(&image_of(organ, 1), &image_of(organ, 2)) << "to repeat is the default";
    EXPECT_EQ(image_of(organ, 0).pixels, image_of(organ, 1).pixels);
    EXPECT_EQ(organ.files.size(), 2u);
}

TEST_F(GltfSampler, AnUnknownModeRepeatsAndIsToldOf) {
    triangle.json["textures"][0]["sampler"] = 2;
    const Organ organ = load();
    EXPECT_EQ(image_of(organ, 0).wrap_v, Wrap::repeat);
    EXPECT_TRUE(has_warning(organ.warnings, "/samplers/2/wrapT is 7, expected 33071, 33648 or 10497; repeated"));
    triangle.json["textures"][0]["sampler"] = 8;
    EXPECT_EQ(fault_of(folder.write("t.glb", triangle.file())), "/textures/0/sampler: sampler 8 is not in the file");
    triangle.json["textures"][0]["sampler"] = "x";
    EXPECT_EQ(fault_of(folder.write("t.glb", triangle.file())),
              "/textures/0/sampler: is \"x\", expected a whole number");
}

TEST_F(GltfSampler, MadeCoordinatesRepeatWhateverItSays) {
    triangle.primitive()["attributes"].erase("TEXCOORD_0");
    const Organ organ = load();
    EXPECT_EQ(image_of(organ, 0).wrap_u, Wrap::repeat);
    EXPECT_EQ(image_of(organ, 0).wrap_v, Wrap::repeat);
}

TEST_F(GltfSampler, APartWithItsOwnCoordinatesKeepsTheWrapOfATextureThatAnotherRepeats) {
    json& primitives = triangle.json["meshes"][0]["primitives"];
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", 0}});
    primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", 0}});
    for (std::size_t p = 1; p < 3; ++p)  // elsewhere, so that they are not the same triangle
        primitives[p]["attributes"]["POSITION"] = triangle.add_accessor(
            bytes_of<float>({0, 0, 0.1f * static_cast<float>(p), 0.1f, 0, 0, 0, 0.1f, 0}), 5126, 3, "VEC3");
    std::vector<organ::Encoded> encoded;
    const Organ organ = organ::load(folder.write("t.glb", triangle.file()), {}, {}, &encoded);
    ASSERT_EQ(organ.parts.size(), 3u);
    const auto image_of_part = [&](std::size_t part) -> const Image& {
        return image_of(organ, static_cast<std::size_t>(organ.parts[part].material));
    };
    EXPECT_EQ(image_of_part(0).wrap_u, Wrap::clamp);
    EXPECT_EQ(image_of_part(0).wrap_v, Wrap::mirror);
    EXPECT_EQ(image_of_part(1).wrap_u, Wrap::repeat);
    EXPECT_EQ(image_of_part(1).wrap_v, Wrap::repeat);
    EXPECT_EQ(image_of_part(1).pixels, image_of_part(0).pixels);
    EXPECT_EQ(organ.parts[1].material, organ.parts[2].material) << "one copy, however many parts need it";
    EXPECT_EQ(organ.materials.size(), 4u);
    ASSERT_EQ(organ.images.size(), 3u);
    ASSERT_EQ(encoded.size(), 3u);
    EXPECT_EQ(encoded[2], encoded[0]);
    EXPECT_NE(encoded[2], nullptr);
}

TEST_F(GltfSampler, OfManyWaysToContinueAnImageFourAreKept) {
    triangle.json["samplers"] = json::array();
    triangle.json["textures"] = json::array();
    triangle.json["materials"] = json::array();
    for (const int u : {33071, 33648, 10497})
        for (const int v : {33071, 33648, 10497}) {
            const std::size_t number = triangle.json["samplers"].size();
            triangle.json["samplers"].push_back({{"wrapS", u}, {"wrapT", v}});
            triangle.json["textures"].push_back({{"source", 0}, {"sampler", number}});
            triangle.json["materials"].push_back(
                {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", number}}}}}});
        }
    const Organ organ = load();
    EXPECT_EQ(organ.images.size(), 4u);
    EXPECT_EQ(image_of(organ, 3).wrap_u, Wrap::mirror);
    EXPECT_EQ(image_of(organ, 3).wrap_v, Wrap::clamp);
    for (std::size_t material = 4; material < 9; ++material)
        EXPECT_EQ(&image_of(organ, material), &image_of(organ, 2)) << material;
    EXPECT_EQ(std::ranges::count_if(organ.warnings,
                                    [](const std::string& warning) {
                                        return warning ==
                                               "texture skin.png: is continued beyond its edges in more than 4 ways; "
                                               "the further ones are drawn like one of these";
                                    }),
              1);
}

TEST_F(GltfSampler, APictureInPlaceOfATextureContinuesAsItDid) {
    cv::imwrite((folder.path() / "other.png").string(), cv::Mat(4, 4, CV_8UC3, cv::Scalar(7, 8, 9)));
    triangle.json["materials"].erase(2);
    triangle.json["materials"].erase(1);
    const Organ organ = load_organ(folder.write("t.glb", triangle.file()), {.texture = folder.path() / "other.png"});
    EXPECT_EQ(image_of(organ, 0).name, "other.png");
    EXPECT_EQ(image_of(organ, 0).wrap_u, Wrap::clamp);
    EXPECT_EQ(image_of(organ, 0).wrap_v, Wrap::mirror);
}

}  // namespace
}  // namespace lapfx::test
