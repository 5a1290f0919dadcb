#include "lapfx/authoring/organ_report.h"
#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

using nlohmann::json;

class Gltf : public testing::Test {
  protected:
    Organ load(const Triangle& triangle, const OrganOptions& options = {}) {
        return load_organ(folder.write("t.glb", triangle.file()), options);
    }
    std::string fault(const Triangle& triangle) { return fault_of(folder.write("t.glb", triangle.file())); }
    TemporaryFolder folder;
};

TEST_F(Gltf, MetresBecomeMillimetres) {
    const Organ organ = load({});
    ASSERT_EQ(organ.positions.size(), 3u);
    EXPECT_EQ(organ.positions[1], glm::vec3(100, 0, 0));
    EXPECT_EQ(organ.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(organ.scale, 1000.0);
    EXPECT_EQ(organ.name, "t");
    EXPECT_EQ(organ.parts[0].name, "t");
}

TEST_F(Gltf, ScaleAndRotationOfTheOptions) {
    const Organ organ = load({}, {.scale = 10.0, .rotation = {90, 0, 0}});
    EXPECT_NEAR(organ.positions[2].y, 0.0f, 1e-6f);
    EXPECT_NEAR(organ.positions[2].z, 1.0f, 1e-6f);  // y turns to z about x
}

TEST_F(Gltf, MissingAttributesAreMade) {
    const Organ organ = load({});
    EXPECT_FALSE(organ.has_uvs);
    EXPECT_FALSE(organ.has_colors);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(organ.normals[i], glm::vec3(0, 0, 1));
        EXPECT_NEAR(glm::dot(glm::vec3(organ.tangents[i]), organ.normals[i]), 0.0f, 1e-6f);
        EXPECT_EQ(organ.colors[i], glm::vec4(1));
    }
    EXPECT_EQ(organ.materials.size(), 1u);
}

TEST_F(Gltf, MirroredNodeStaysOutward) {
    Triangle triangle;
    triangle.json["nodes"][0]["scale"] = {-1, 1, 1};
    const Organ organ = load(triangle);
    EXPECT_EQ(organ.positions[organ.indices[1]].y, 100.0f);
    EXPECT_EQ(organ.positions[organ.indices[2]].x, -100.0f);
    EXPECT_EQ(organ.normals[0], glm::vec3(0, 0, 1));
}

TEST_F(Gltf, NodesMoveTheirChildren) {
    Triangle triangle;
    triangle.json["nodes"] = json::parse(
        R"([{"children": [1], "translation": [1, 0, 0]}, {"mesh": 0, "rotation": [0, 0, 0.70710678, 0.70710678]}])");
    const Organ organ = load(triangle);
    EXPECT_NEAR(organ.positions[1].x, 1000.0f, 1e-3f);  // x turns to y about z, then moves by 1 m
    EXPECT_NEAR(organ.positions[1].y, 100.0f, 1e-3f);
}

TEST_F(Gltf, WithoutSceneAllRootNodes) {
    Triangle triangle;
    triangle.json.erase("scene");
    triangle.json.erase("scenes");
    EXPECT_EQ(load(triangle).triangle_count(), 1u);
}

TEST_F(Gltf, OnlyTheDefaultScene) {
    Triangle triangle;
    triangle.json["scene"] = 1;
    triangle.json["scenes"] = json::parse(R"([{"nodes": [0]}, {"nodes": []}])");
    EXPECT_EQ(fault(triangle), "no triangles: the file contains 1 mesh, none in the scene");
}

TEST_F(Gltf, IndicesOfEverySize) {
    const std::vector<std::uint8_t> small{2, 0, 1};
    const std::vector<std::uint16_t> medium{2, 0, 1};
    const std::vector<std::uint32_t> large{2, 0, 1};
    const std::pair<std::string, int> kinds[] = {
        {bytes_of(small), 5121}, {bytes_of(medium), 5123}, {bytes_of(large), 5125}};
    for (const auto& [bytes, type] : kinds) {
        Triangle triangle;
        triangle.primitive()["indices"] = triangle.add_accessor(bytes, type, 3, "SCALAR");
        EXPECT_EQ(load(triangle).indices, (std::vector<std::uint32_t>{2, 0, 1})) << type;
    }
}

/*  3---2   a strip 0 1 3 2 and a fan 0 1 2 3 give the same square, facing +z
    | / |
    0---1   */
TEST_F(Gltf, StripsAndFans) {
    const std::string corners = bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    for (const int mode : {5, 6}) {
        Triangle square;
        square.primitive()["attributes"]["POSITION"] = square.add_accessor(corners, 5126, 4, "VEC3");
        const std::vector<std::uint8_t> order =
            mode == 5 ? std::vector<std::uint8_t>{0, 1, 3, 2} : std::vector<std::uint8_t>{0, 1, 2, 3};
        square.primitive()["indices"] = square.add_accessor(bytes_of(order), 5121, 4, "SCALAR");
        square.primitive()["mode"] = mode;
        const Organ organ = load(square);
        EXPECT_EQ(organ.triangle_count(), 2u);
        for (const glm::vec3& normal : organ.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << mode;
        EXPECT_EQ(report(organ).boundary_edges, 4u);
    }
}

TEST_F(Gltf, SparseAccessorReplacesValues) {
    Triangle triangle;
    const int indices = triangle.add_view(bytes_of<std::uint16_t>({1}));
    const int values = triangle.add_view(bytes_of<float>({0.2f, 0, 0}));
    triangle.json["accessors"][0]["sparse"] = {{"count", 1},
                                               {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                               {"values", {{"bufferView", values}}}};
    EXPECT_EQ(load(triangle).positions[1], glm::vec3(200, 0, 0));
    triangle.json["accessors"][0]["sparse"]["indices"]["byteOffset"] = 1;
    EXPECT_EQ(fault(triangle), "/accessors/0/sparse/indices: needs 2 bytes at 1, buffer view 1 has 2");
}

TEST_F(Gltf, QuantisedPositionsAndNormals) {
    Triangle triangle;
    triangle.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const std::string corners = bytes_of<std::int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0});
    const int position = triangle.add_accessor(corners, 5122, 3, "VEC3", true);
    triangle.json["bufferViews"].back()["byteStride"] = 8;
    triangle.primitive()["attributes"]["POSITION"] = position;
    const std::string up = bytes_of<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0});
    triangle.primitive()["attributes"]["NORMAL"] = triangle.add_accessor(up, 5120, 3, "VEC3", true);
    triangle.json["bufferViews"].back()["byteStride"] = 4;
    const Organ organ = load(triangle);
    EXPECT_EQ(organ.positions[1], glm::vec3(1000, 0, 0));
    EXPECT_EQ(organ.normals[2], glm::vec3(0, 0, 1));
}

TEST_F(Gltf, VertexColoursOfEveryKind) {
    const std::string floats = bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 0.5f});
    const std::string bytes = bytes_of<std::uint8_t>({255, 0, 0, 51, 0, 255, 0, 255, 0, 0, 255, 255});
    const std::string shorts = bytes_of<std::uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 65535});
    Triangle triangle;
    triangle.primitive()["attributes"]["COLOR_0"] = triangle.add_accessor(floats, 5126, 3, "VEC3");
    Organ organ = load(triangle);
    EXPECT_TRUE(organ.has_colors);
    EXPECT_EQ(organ.colors[2], glm::vec4(0, 0, 0.5f, 1));
    triangle.primitive()["attributes"]["COLOR_0"] = triangle.add_accessor(bytes, 5121, 3, "VEC4", true);
    organ = load(triangle);
    EXPECT_EQ(organ.colors[0], glm::vec4(1, 0, 0, 0.2f));
    triangle.primitive()["attributes"]["COLOR_0"] = triangle.add_accessor(shorts, 5123, 3, "VEC3", true);
    triangle.json["bufferViews"].back()["byteStride"] = nullptr;
    EXPECT_EQ(load(triangle).colors[1], glm::vec4(0, 1, 0, 1));
}

TEST_F(Gltf, MaterialValues) {
    Triangle triangle;
    triangle.json["materials"] = json::parse(R"([{"name": "wet", "doubleSided": true,
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1], "roughnessFactor": 0.3}}])");
    triangle.primitive()["material"] = 0;
    const Material material = load(triangle).materials[0];
    EXPECT_EQ(material.name, "wet");
    EXPECT_EQ(material.base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1));
    EXPECT_FLOAT_EQ(material.roughness, 0.3f);
    EXPECT_TRUE(material.double_sided);
    EXPECT_EQ(material.base_color_image, -1);
    triangle.primitive()["material"] = 1;
    EXPECT_EQ(fault(triangle), "/meshes/0/primitives/0/material: material 1 is not in the file");
}

TEST_F(Gltf, TextureTransformMovesTheCoordinates) {
    Triangle triangle;
    triangle.primitive()["attributes"]["TEXCOORD_0"] =
        triangle.add_accessor(bytes_of<float>({0, 0, 1, 0, 0, 1}), 5126, 3, "VEC2");
    triangle.primitive()["material"] = 0;
    triangle.json["textures"] = json::parse(R"([{"source": 0}])");
    triangle.json["images"] = json::parse(R"([{"uri": "missing.png"}])");
    triangle.json["materials"] = json::parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0,
        "extensions": {"KHR_texture_transform": {"offset": [0.25, 0.5], "scale": [2, 3]}}}}}])");
    const Organ organ = load(triangle);
    EXPECT_EQ(organ.uvs[1], glm::vec2(2.25f, 0.5f));
    EXPECT_EQ(organ.uvs[2], glm::vec2(0.25f, 3.5f));
    EXPECT_TRUE(has_warning(organ.warnings, "texture missing.png: no such file; it is left out"));
}

TEST_F(Gltf, UnknownRequiredExtensionIsNamed) {
    Triangle triangle;
    triangle.json["extensionsRequired"] = {"KHR_geometry_of_tomorrow"};
    EXPECT_EQ(fault(triangle), "/extensionsRequired: needs the extension KHR_geometry_of_tomorrow, which is not read");
}

TEST_F(Gltf, FilesStayInTheFolder) {
    Triangle triangle;
    const std::pair<const char*, const char*> wrong[] = {{"http://example.org/a.bin", "is a URL; only plain files"},
                                                         {"file:///etc/passwd", "is a URL; only plain files"},
                                                         {"/etc/passwd", "is an absolute path; only plain files"},
                                                         {"../a.bin", "leads out of the folder; only plain files"},
                                                         {"b/%2e%2e/../a.bin", "leads out of the folder; only plain"}};
    for (const auto& [uri, reason] : wrong) {
        triangle.json["buffers"][0]["uri"] = uri;
        const std::string text = fault_of(folder.write("t.gltf", triangle.json.dump()));
        EXPECT_TRUE(text.starts_with("/buffers/0/uri: ") && text.find(reason) != std::string::npos) << text;
    }
    triangle.json["buffers"][0]["uri"] = "a%20b.bin";
    EXPECT_EQ(fault_of(folder.write("t.gltf", triangle.json.dump())), "/buffers/0: a%20b.bin: no such file");
    folder.write("a b.bin", triangle.binary);
    EXPECT_EQ(load_organ(folder.write("t.gltf", triangle.json.dump())).triangle_count(), 1u);
}

TEST_F(Gltf, DataUris) {
    Triangle triangle;
    triangle.json["buffers"][0]["uri"] =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    EXPECT_EQ(load_organ(folder.write("t.gltf", triangle.json.dump())).positions[1], glm::vec3(1000, 0, 0));
    triangle.json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA!";
    EXPECT_EQ(fault_of(folder.write("t.gltf", triangle.json.dump())),
              "/buffers/0/uri: is a data URI that is not valid base64");
}

TEST_F(Gltf, DataUrisMayBePercentEncoded) {
    Triangle triangle;
    std::string data;
    for (const char byte : triangle.binary) {
        char text[8];
        std::snprintf(text, sizeof text, "%%%02X", static_cast<unsigned char>(byte));
        data += text;
    }
    triangle.json["buffers"][0]["uri"] = "data:application/octet-stream," + data;
    EXPECT_EQ(load_organ(folder.write("t.gltf", triangle.json.dump())).positions[1], glm::vec3(100, 0, 0));
    triangle.json["buffers"][0]["uri"] =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA%3D";
    EXPECT_EQ(load_organ(folder.write("t.gltf", triangle.json.dump())).positions[1], glm::vec3(1000, 0, 0));
    triangle.json["buffers"][0]["uri"] = "data:nothing";
    EXPECT_EQ(fault_of(folder.write("t.gltf", triangle.json.dump())),
              "/buffers/0/uri: is a data URI without a comma before its data");
}

TEST_F(Gltf, IndicesMayBeZerosWithSparseValues) {
    Triangle triangle;
    const int where = triangle.add_view(bytes_of<std::uint16_t>({1, 2})),
              values = triangle.add_view(bytes_of<std::uint16_t>({2, 1}));
    triangle.json["accessors"].push_back({{"componentType", 5123},
                                          {"count", 3},
                                          {"type", "SCALAR"},
                                          {"sparse",
                                           {{"count", 2},
                                            {"indices", {{"bufferView", where}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}}}});
    triangle.primitive()["indices"] = 1;
    EXPECT_EQ(load(triangle).indices, (std::vector<std::uint32_t>{0, 2, 1}));
    triangle.json["accessors"][1]["bufferView"] = triangle.add_view(bytes_of<std::uint16_t>({0, 0, 0}));
    EXPECT_EQ(load(triangle).indices, (std::vector<std::uint32_t>{0, 2, 1})) << "with a view too";
    triangle.json["accessors"][1].erase("sparse");
    triangle.json["accessors"][1].erase("bufferView");
    EXPECT_EQ(fault(triangle), "/accessors/1: indices need a buffer view or sparse values");
}

TEST_F(Gltf, HiddenNodesAreLeftOutAndToldOf) {
    Triangle triangle;
    triangle.json["nodes"] = {{{"mesh", 0}},
                              {{"children", {2}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}},
                              {{"mesh", 0}, {"translation", {1, 0, 0}}}};
    triangle.json["scenes"][0]["nodes"] = {0, 1};
    triangle.json["extensionsRequired"] = {"KHR_node_visibility"};
    const Organ organ = load(triangle);
    EXPECT_EQ(organ.triangle_count(), 1u);
    EXPECT_TRUE(
        has_warning(organ.warnings, "1 node is hidden in the file (KHR_node_visibility); left out with its mesh"));
    triangle.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = true;
    EXPECT_EQ(load(triangle).triangle_count(), 2u);
    triangle.json["scenes"][0]["nodes"] = {1};
    triangle.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = false;
    EXPECT_EQ(fault(triangle), "no triangles: the file contains 1 mesh in hidden nodes only");
}

TEST_F(Gltf, AlphaModesAreToldOf) {
    Triangle triangle;
    triangle.json["materials"] = {{{"name", "bag"}, {"alphaMode", "BLEND"}},
                                  {{"alphaMode", "BLEND"}},
                                  {{"name", "leaf"}, {"alphaMode", "MASK"}},
                                  {{"name", "skin"}, {"alphaMode", "OPAQUE"}}};
    const Organ organ = load(triangle);
    EXPECT_TRUE(has_warning(organ.warnings, "2 materials have the alpha mode BLEND (bag, (unnamed)); drawn opaque"));
    EXPECT_TRUE(has_warning(organ.warnings, "1 material has the alpha mode MASK (leaf); drawn opaque"));
    EXPECT_FALSE(has_warning(organ.warnings, "skin"));
}

TEST_F(Gltf, EveryRangeIsChecked) {
    const std::pair<const char*, const char*> wrong[] = {
        {R"({"accessors": [{"bufferView": 7}]})", "/accessors/0: buffer view 7 is not in the file"},
        {R"({"accessors": [{"count": 4}]})", "/accessors/0: needs 48 bytes at 0, buffer view 0 has 36"},
        {R"({"accessors": [{"count": 4294967296}]})",
         "/accessors/0: has 4294967296 elements, at most 60000000 are allowed"},
        {R"({"accessors": [{"byteOffset": 18446744073709551615}]})",
         "/accessors/0: needs 36 bytes at 18446744073709551615, buffer view 0 has 36"},
        {R"({"bufferViews": [{"buffer": 3}]})", "/bufferViews/0: buffer 3 is not in the file"},
        {R"({"bufferViews": [{"byteLength": 37}]})", "/bufferViews/0: bytes 0 to 37 are not in buffer 0 of 36 bytes"},
        {R"({"bufferViews": [{"byteStride": 8}]})", "/accessors/0: byteStride 8 is less than an element's 12 bytes"},
        {R"({"buffers": [{"byteLength": 40}]})", "/buffers/0: truncated: has 36 of 40 bytes"},
        {R"({"nodes": [{"mesh": 2}]})", "/nodes/0/mesh: mesh 2 is not in the file"},
        {R"({"nodes": [{"children": [0]}]})", "/nodes/0: is its own ancestor"},
        {R"({"nodes": [{"matrix": [1, 2]}]})", "/nodes/0/matrix: has 2 numbers, expected 16"},
        {R"({"scene": 5})", "/scene: scene 5 is not in the file"},
        {R"({"asset": {"version": "1.0"}})", "/asset/version: is \"1.0\", only 2.0 is read"},
        {R"({"meshes": 3})", "/meshes: is not an array"}};
    for (const auto& [patch, reason] : wrong) {
        Triangle triangle;
        const json changes = json::parse(patch);
        for (const auto& [key, value] : changes.items()) {
            if (value.is_array())
                triangle.json[key][0].update(value[0]);
            else
                triangle.json[key] = value;
        }
        EXPECT_EQ(fault(triangle), reason) << patch;
    }
}

TEST_F(Gltf, AnAccessorOfAnotherShapeIsRefused) {
    const auto with = [&](const char* name, const json& accessor) {
        Triangle triangle;
        triangle.json["accessors"].push_back(accessor);
        triangle.primitive()["attributes"][name] = 1;
        return fault(triangle);
    };
    const json matrices{{"componentType", 5126}, {"count", 4'000'000}, {"type", "MAT4"}};
    EXPECT_EQ(with("POSITION", matrices),
              "/meshes/0/primitives/0/attributes/POSITION: has elements of 16 components, expected 3");
    EXPECT_EQ(with("COLOR_0", matrices),
              "/meshes/0/primitives/0/attributes/COLOR_0: has elements of 16 components, expected 3 or 4");
    EXPECT_EQ(with("NORMAL", {{"componentType", 5126}, {"count", 4'000'000}, {"type", "VEC3"}}),
              "/meshes/0/primitives/0/attributes/NORMAL: has 4000000 elements, expected 3");
    EXPECT_EQ(with("POSITION", {{"componentType", 5126}, {"count", 60'000'000}, {"type", "VEC3"}}),
              "/accessors/1: has 60000000 elements without a buffer view, at most 4000000 are allowed");
}

TEST_F(Gltf, IndexOutOfRangeIsLeftOutWithAWarning) {
    Triangle triangle;
    triangle.primitive()["indices"] =
        triangle.add_accessor(bytes_of<std::uint8_t>({0, 1, 2, 0, 1, 9}), 5121, 6, "SCALAR");
    const Organ organ = load(triangle);
    EXPECT_EQ(organ.triangle_count(), 1u);
    EXPECT_TRUE(has_warning(organ.warnings, "1 triangle refers to vertices that are not in the file; left out"));
}

TEST_F(Gltf, TruncatedAtEveryLengthIsAFault) {
    const std::string whole = Triangle().file();
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_NE(fault_of(folder.write("t.glb", whole.substr(0, length))), "") << length;
}

TEST_F(Gltf, DamagedBytesNeverCrash) {
    const std::string whole = Triangle().file();
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const char value : {'\0', '\xff', '9'}) {
            std::string damaged = whole;
            damaged[at] = value;
            fault_of(folder.write("t.glb", damaged));  // a fault or an organ, both are right
        }
}

/* The specification allows 840.0 where an integer is meant.  */
TEST_F(Gltf, IntegersWrittenAsFloats) {
    Triangle triangle;
    triangle.primitive()["indices"] = triangle.add_accessor(bytes_of<std::uint16_t>({0, 2, 1}), 5123, 3, "SCALAR");
    std::string text = triangle.json.dump();
    const auto as_floats = [](const std::string& source) {  // every integer outside of strings
        std::string out;
        bool quoted = false;
        for (std::size_t i = 0; i < source.size(); ++i) {
            quoted ^= source[i] == '"';
            out += source[i];
            const bool last = std::isdigit(static_cast<unsigned char>(source[i])) && i + 1 < source.size() &&
                              (source[i + 1] == ',' || source[i + 1] == '}' || source[i + 1] == ']');
            if (!quoted && last) out += ".0";
        }
        return out;
    };
    text = as_floats(text);
    ASSERT_NE(text.find("\"count\":3.0"), std::string::npos) << text;
    ASSERT_NE(text.find("\"POSITION\":0.0"), std::string::npos);
    while (text.size() % 4 != 0) text += ' ';
    std::string binary = triangle.binary;
    while (binary.size() % 4 != 0) binary += '\0';
    const std::string body = word(static_cast<std::uint32_t>(text.size())) + "JSON" + text +
                             word(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
    const Organ organ =
        load_organ(folder.write("t.glb", "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + body.size())) + body));
    EXPECT_EQ(organ.indices, (std::vector<std::uint32_t>{0, 2, 1}));
}

TEST_F(Gltf, NumbersThatAreNotWholeAreNamed) {
    const auto with = [&](const char* pointer, const json& value) {
        Triangle triangle;
        triangle.json[json::json_pointer(pointer)] = value;
        try {
            load(triangle);
        } catch (const Error& error) {
            return error.faults().front().place + " " + error.faults().front().reason;
        }
        return std::string("no fault");
    };
    EXPECT_EQ(with("/accessors/0/count", 3.5), "/accessors/0/count is 3.5, expected a whole number");
    EXPECT_EQ(with("/accessors/0/componentType", "FLOAT"),
              "/accessors/0/componentType is \"FLOAT\", expected a whole number");
    EXPECT_EQ(with("/bufferViews/0/byteOffset", 0.25), "/bufferViews/0/byteOffset is 0.25, expected a whole number");
    EXPECT_EQ(with("/meshes/0/primitives/0/attributes/POSITION", 0.5),
              "/meshes/0/primitives/0/attributes/POSITION is 0.5, expected a whole number");
    EXPECT_EQ(with("/meshes/0/primitives/0/indices", true),
              "/meshes/0/primitives/0/indices is true, expected a whole number");
    EXPECT_EQ(with("/scenes/0/nodes/0", 0.5), "/scenes/0/nodes/0 is 0.5, expected a whole number");
    EXPECT_EQ(with("/meshes/0/primitives", json::object()), "/meshes/0/primitives is not an array");
    EXPECT_EQ(with("/nodes/0", 7), "/nodes/0 is 7, expected an object");
    EXPECT_EQ(with("/accessors/0/count", 3.0), "no fault");
    EXPECT_EQ(with("/meshes/0/primitives/0", json::object()), "/meshes/0/primitives/0/attributes is missing");
    EXPECT_EQ(with("/accessors/0", {{"count", 3}}), "/accessors/0/componentType is missing");
    EXPECT_EQ(with("/bufferViews/0", json::object()), "/bufferViews/0/buffer is missing");
}

TEST_F(Gltf, MaterialsThatCannotBeAreToldOf) {
    const auto warned = [&](const char* material, const std::string& warning) {
        Triangle triangle;
        triangle.json["materials"] = json::array({json::parse(material)});
        triangle.primitive()["material"] = 0;
        const Organ organ = load(triangle);
        EXPECT_EQ(organ.triangle_count(), 1u);
        EXPECT_TRUE(has_warning(organ.warnings, warning)) << testing::PrintToString(organ.warnings);
    };
    warned(R"({"pbrMetallicRoughness": ["no object"]})",
           "/materials/0/pbrMetallicRoughness is [\"no object\"], expected an object; left out");
    warned(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": -1}}})",
           "/materials/0/pbrMetallicRoughness/baseColorTexture/index is -1, expected a whole number from 0; left out");
    warned(R"({"normalTexture": {"scale": 1}})", "/materials/0/normalTexture has no index; left out");
    warned("7", "/materials/0 is 7, expected an object; left out");
}

/* A note on the file is no reason that it is refused for.  */
TEST_F(Gltf, TheReasonIsThatOfTheTriangles) {
    Triangle triangle;
    triangle.json.erase("nodes");
    triangle.json.erase("scenes");
    triangle.json.erase("scene");
    EXPECT_TRUE(has_warning(load(triangle).warnings,
                            "the file has no nodes: all its meshes are used, each at its own coordinates"));
    triangle.binary = bytes_of<float>({0, 0, 0, 1, 1, 1, 2, 2, 2});
    EXPECT_EQ(fault(triangle), "no triangles that can be drawn: 1 triangle without area");
    triangle.primitive()["mode"] = 0;
    EXPECT_EQ(fault(triangle), "no triangles: the file contains 1 primitive of points or lines only");
    triangle.json.erase("meshes");
    EXPECT_EQ(fault(triangle), "no triangles: the file contains no mesh");
    Triangle hidden;
    hidden.json["nodes"] = json::array({json::object()});
    EXPECT_EQ(fault(hidden), "no triangles: the file contains 1 mesh, none in the scene");
}

TEST_F(Gltf, DeepJsonIsRefused) {
    const std::string deep = R"({"asset": {"version": "2.0"}, "a": )" + std::string(100000, '[');
    EXPECT_EQ(fault_of(folder.write("t.gltf", deep)), "its JSON is nested deeper than 64 levels");
}

TEST_F(Gltf, DamagedMeshoptIsRefused) {
    Triangle triangle;
    triangle.json["extensionsRequired"] = {"EXT_meshopt_compression"};
    auto& view = triangle.json["bufferViews"][0];
    const json good = {{"buffer", 0}, {"byteLength", 36}, {"byteStride", 12}, {"count", 3}, {"mode", "ATTRIBUTES"}};
    const std::string at = "/bufferViews/0/extensions/EXT_meshopt_compression: ";
    const std::pair<json, std::string> wrong[] = {
        {{}, "its compressed data is damaged"},
        {{{"byteStride", 10}}, "byteStride 10 does not fit mode ATTRIBUTES"},
        {{{"count", -1}}, "count is missing or not a whole number from 0"},
        {{{"count", 2000000000}}, "count 2000000000 is too large"},
        {{{"mode", "X"}}, "mode is \"X\", allowed are ATTRIBUTES, TRIANGLES, INDICES"},
        {{{"filter", "OCTAHEDRAL"}}, "filter \"OCTAHEDRAL\" does not fit byteStride 12"},
        {{{"byteLength", 99}}, "bytes 0 to 99 are not in buffer 0 of 36 bytes"}};
    for (const auto& [patch, reason] : wrong) {
        json extension = good;
        if (patch.is_object()) extension.update(patch);
        view["extensions"]["EXT_meshopt_compression"] = extension;
        EXPECT_EQ(fault(triangle), at + reason);
    }
}

}  // namespace
}  // namespace lapfx::test
