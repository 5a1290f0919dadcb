// KHR_draco_mesh_compression: data of Draco's own encoder is read, and damaged data is refused with one line.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <sys/resource.h>
#include <cmath>

#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

using nlohmann::json;

constexpr int side = 12;  // squares

/// A sheet of 0.1 m that bulges, with texture coordinates and colours in bytes.
glm::vec3 place(int x, int y) {
    const float u = static_cast<float>(x) / side, v = static_cast<float>(y) / side;
    return {0.1f * u, 0.1f * v, 0.02f * u * (1.0f - v)};
}

struct Packed {
    std::string bytes;
    int position = -1, uv = -1, color = -1;  ///< unique ids
    std::uint32_t points = 0, triangles = 0;
};

Packed packed_sheet(int method) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2 * side * side);
    Packed made;
    made.position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    made.uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
    made.color = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
    std::uint32_t face = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (const auto& corners : {std::array<glm::ivec2, 3>{{{x, y}, {x + 1, y}, {x + 1, y + 1}}},
                                        std::array<glm::ivec2, 3>{{{x, y}, {x + 1, y + 1}, {x, y + 1}}}}) {
                std::array<glm::vec3, 3> p;
                std::array<glm::vec2, 3> uv;
                std::array<glm::u8vec4, 3> color;
                for (std::size_t c = 0; c < 3; ++c) {
                    p[c] = place(corners[c].x, corners[c].y);
                    uv[c] = glm::vec2(corners[c]) / static_cast<float>(side);
                    color[c] = {corners[c].x * 20, corners[c].y * 20, 7, 255};
                }
                const draco::FaceIndex f(face++);
                builder.SetAttributeValuesForFace(made.position, f, &p[0], &p[1], &p[2]);
                builder.SetAttributeValuesForFace(made.uv, f, &uv[0], &uv[1], &uv[2]);
                builder.SetAttributeValuesForFace(made.color, f, &color[0], &color[1], &color[2]);
            }
    const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
    encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, 12);
    draco::EncoderBuffer buffer;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    made.bytes.assign(buffer.data(), buffer.size());
    made.position = static_cast<int>(mesh->attribute(made.position)->unique_id());
    made.uv = static_cast<int>(mesh->attribute(made.uv)->unique_id());
    made.color = static_cast<int>(mesh->attribute(made.color)->unique_id());
    made.points = mesh->num_points();
    made.triangles = mesh->num_faces();
    return made;
}

/// As exporters write it: accessors without views, and one view with the compressed data.
Triangle gltf_of(const Packed& packed) {
    Triangle file;
    file.binary.clear();
    file.json["bufferViews"] = json::array();
    file.json["extensionsUsed"] = file.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const int view = file.add_view(packed.bytes);
    file.json["accessors"] = {
        {{"componentType", 5126}, {"count", packed.points}, {"type", "VEC3"}},
        {{"componentType", 5126}, {"count", packed.points}, {"type", "VEC2"}},
        {{"componentType", 5121}, {"count", packed.points}, {"type", "VEC4"}, {"normalized", true}},
        {{"componentType", 5125}, {"count", 3 * packed.triangles}, {"type", "SCALAR"}}};
    file.primitive() = {
        {"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}, {"COLOR_0", 2}}},
        {"indices", 3},
        {"extensions",
         {{"KHR_draco_mesh_compression",
           {{"bufferView", view},
            {"attributes", {{"POSITION", packed.position}, {"TEXCOORD_0", packed.uv}, {"COLOR_0", packed.color}}}}}}}};
    return file;
}

class DracoGltf : public testing::Test {
  protected:
    Organ load(const Triangle& file) { return load_organ(folder.write("t.glb", file.file())); }
    std::string fault(const Triangle& file) { return fault_of(folder.write("t.glb", file.file())); }
    static json& extension(Triangle& file) { return file.primitive()["extensions"]["KHR_draco_mesh_compression"]; }
    TemporaryFolder folder;
    const std::string at = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression: ";
};

TEST_F(DracoGltf, WhatTheEncoderPacksIsReadByEitherMethod) {
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
        const Packed packed = packed_sheet(method);
        const Organ organ = load(gltf_of(packed));
        ASSERT_EQ(organ.triangle_count(), 2U * side * side) << method;
        EXPECT_TRUE(organ.has_colors && organ.has_uvs);
        double area = 0;
        for (std::size_t i = 0; i < organ.indices.size(); i += 3) {
            const glm::vec3 a = organ.positions[organ.indices[i]];
            area += glm::length(glm::cross(organ.positions[organ.indices[i + 1]] - a,
                                           organ.positions[organ.indices[i + 2]] - a)) /
                    2;
        }
        EXPECT_NEAR(area, 10'150, 60) << "of a sheet of 100 mm that bulges";
        for (std::size_t v = 0; v < organ.positions.size(); ++v) {
            // Texture coordinates identify the points of the sheet; other attributes belong to them.
            const glm::ivec2 at_point(glm::round(organ.uvs[v] * static_cast<float>(side)));
            EXPECT_LT(glm::distance(organ.positions[v], 1000.0f * place(at_point.x, at_point.y)), 0.02f) << v;
            EXPECT_NEAR(organ.colors[v].r, static_cast<float>(20 * at_point.x) / 255, 1e-6f) << v;
            EXPECT_NEAR(organ.colors[v].g, static_cast<float>(20 * at_point.y) / 255, 1e-6f) << v;
        }
    }
}

TEST_F(DracoGltf, AMeshThatIsShownTwiceIsDecodedOnceAndWhatIsNotPackedIsTaken) {
    Triangle file = gltf_of(packed_sheet(draco::MESH_EDGEBREAKER_ENCODING));
    file.json["nodes"] = json::parse(R"([{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 1]}])");
    file.json["scenes"][0]["nodes"] = {0, 1};
    EXPECT_EQ(load(file).triangle_count(), 4U * side * side);
    // The extension is optional and the accessors have bytes, so these count.
    Triangle plain;
    plain.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                                     {"attributes", {{"POSITION", 0}}}};
    plain.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    EXPECT_EQ(load(plain).positions[1], glm::vec3(100, 0, 0));
}

TEST_F(DracoGltf, WhatDoesNotMatchIsRefused) {
    const Packed packed = packed_sheet(draco::MESH_EDGEBREAKER_ENCODING);
    const auto refused = [&](const std::string& reason, auto change) {
        Triangle file = gltf_of(packed);
        change(file);
        EXPECT_EQ(fault(file), reason);
    };
    const std::string here = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
    refused(here + "/attributes/POSITION: the compressed data has no attribute 77",
            [&](Triangle& f) { extension(f)["attributes"]["POSITION"] = 77; });
    refused(here + ": POSITION is missing or not a whole number from 0",
            [&](Triangle& f) { extension(f)["attributes"]["POSITION"] = -1; });
    refused(here + "/attributes/POSITION: the compressed data has 2 components, which the accessor has not",
            [&](Triangle& f) { extension(f)["attributes"]["POSITION"] = packed.uv; });
    refused(here + ": POSITION has 7 elements, the compressed data " + std::to_string(packed.points),
            [&](Triangle& f) { f.json["accessors"][0]["count"] = 7; });
    refused(here + ": indices has 3 elements, the compressed data " + std::to_string(3 * packed.triangles),
            [&](Triangle& f) { f.json["accessors"][3]["count"] = 3; });
    refused(here + "/attributes/COLOR_0: the compressed values are not of the accessor's componentType",
            [&](Triangle& f) { f.json["accessors"][2]["componentType"] = 5120; });
    refused(here + ": bufferView is missing or not a whole number from 0",
            [&](Triangle& f) { extension(f).erase("bufferView"); });
    refused(here + ": buffer view 9 is not in the file", [&](Triangle& f) { extension(f)["bufferView"] = 9; });
    refused(here + ": attributes is missing or not an object", [&](Triangle& f) { extension(f).erase("attributes"); });
    refused(here + ": attributes has no POSITION", [&](Triangle& f) { extension(f)["attributes"].erase("POSITION"); });
}

/// The most memory that this process has had, bytes.
std::size_t peak_memory() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<std::size_t>(use.ru_maxrss) * 1024;
}

/// What is made of a damaged sheet may be any sheet of no more triangles, with all of its corners in place.
void expect_sound(const Organ& organ, std::size_t byte) {
    EXPECT_LE(organ.triangle_count(), 2U * side * side) << byte;
    for (const std::uint32_t i : organ.indices) ASSERT_LT(i, organ.positions.size()) << byte;
    for (const glm::vec3& p : organ.positions)
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << byte;
}

TEST_F(DracoGltf, DamagedDataIsRefusedOrReadAsSomethingSoundWithinItsMemory) {
    const std::size_t before = peak_memory();
    for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
        const Packed packed = packed_sheet(method);
        for (std::size_t length = 0; length < packed.bytes.size(); length += 1 + length / 16) {
            Packed cut = packed;
            cut.bytes.resize(std::max<std::size_t>(length, 1));
            EXPECT_EQ(fault(gltf_of(cut)), at + "its compressed data is damaged") << length;
        }
        std::size_t read = 0;
        for (std::size_t i = 0; i < packed.bytes.size(); ++i) {
            Packed wrong = packed;
            wrong.bytes[i] = static_cast<char>(wrong.bytes[i] ^ (i % 2 == 0 ? 0xff : 0x11));
            const fs::path file = folder.write("t.glb", gltf_of(wrong).file());
            const std::string told = fault_of(file);
            if (i < 8) {
                EXPECT_TRUE(told.starts_with(at)) << i << ", of the header: " << told;
            }
            if (told.empty()) {
                ++read;
                expect_sound(load_organ(file), i);
            }
        }
        EXPECT_GT(read, packed.bytes.size() / 4) << "most bytes are values";
    }
    EXPECT_LT(peak_memory() - before, std::size_t{64} << 20) << "of two kilobytes";
}

TEST_F(DracoGltf, WhatClaimsMoreThanItCanHoldIsRefused) {
    Packed packed = packed_sheet(draco::MESH_SEQUENTIAL_ENCODING);
    // Behind the header: triangles and points, as numbers of seven bits a byte.
    const std::string huge = "\xff\xff\xff\x7f";
    packed.bytes = packed.bytes.substr(0, 11) + huge + huge + packed.bytes.substr(15);
    EXPECT_EQ(fault(gltf_of(packed)), at + "claims 268435455 triangles and 268435455 points in " +
                                          std::to_string(packed.bytes.size()) + " bytes");
    Packed old = packed_sheet(draco::MESH_EDGEBREAKER_ENCODING);
    old.bytes[6] = 1;
    EXPECT_EQ(fault(gltf_of(old)), at + "is of Draco's format 2.1, only 2.2 is read");
    old.bytes[6] = 2;
    old.bytes[7] = 0;
    EXPECT_EQ(fault(gltf_of(old)), at + "contains points only");
}

TEST_F(DracoGltf, WhatNobodyReadsIsNotUnpacked) {
    Triangle file = gltf_of(packed_sheet(draco::MESH_EDGEBREAKER_ENCODING));
    for (const char* name : {"_HEAT", "COLOR_1", "TEXCOORD_1", "JOINTS_0"}) {
        file.primitive()["attributes"][name] = 0;
        extension(file)["attributes"][name] = 77;  // there is none: whoever unpacks it refuses the file
    }
    EXPECT_EQ(load(file).triangle_count(), 2U * side * side);
    // That of the material is read.
    file.json["materials"] =
        json::parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}])");
    file.json["textures"] = json::parse(R"([{}])");
    file.primitive()["material"] = 0;
    EXPECT_EQ(fault(file),
              at.substr(0, at.size() - 2) + "/attributes/TEXCOORD_1: the compressed data has no attribute 77");
}

// A few kilobytes can stand for as many equal points as the format can count.
TEST_F(DracoGltf, NoMoreIsUnpackedThanTheLargestFileHas) {
    Packed packed = packed_sheet(draco::MESH_SEQUENTIAL_ENCODING);
    const std::string one = "\x01", sixty_million = std::string("\x80\x8e\xce\x1c", 4);
    packed.bytes = packed.bytes.substr(0, 11) + one + sixty_million + packed.bytes.substr(15) + std::string(10'000, 0);
    packed.triangles = 1;
    packed.points = 60'000'000;
    Triangle file = gltf_of(packed);
    for (const char* name : {"NORMAL", "TANGENT"}) {
        file.primitive()["attributes"][name] = name == std::string("NORMAL") ? 0 : 4;
        extension(file)["attributes"][name] = packed.position;
    }
    file.json["accessors"].push_back({{"componentType", 5126}, {"count", packed.points}, {"type", "VEC4"}});
    EXPECT_EQ(fault(file), at + "unpacks to 3120000012 bytes with what was unpacked before, more than the limit of " +
                               std::to_string(std::uintmax_t{2} << 30));
}

/// Draco unpacks all attributes of its data, also those that no primitive names.
TEST_F(DracoGltf, AttributesThatNobodyReadsCountToo) {
    // As many points as Draco takes for its triangles, whose corners are all point 0; 30 attributes of 255 numbers.
    constexpr int triangles = 30'000, points = 3 * triangles, unread = 30, numbers = 255;
    const auto byte = [](int value) { return std::string(1, static_cast<char>(value)); };
    const auto varint = [&](int value) {
        return byte((value & 127) | 128) + byte(((value >> 7) & 127) | 128) + byte(value >> 14);
    };
    const std::string raw_indices = byte(1) + std::string(points, 0);
    std::string attributes = byte(1) + byte(1 + unread), decoders;  // one decoder of attributes, then their number
    for (int i = 0; i <= unread; ++i) {
        const int type = i == 0 ? draco::GeometryAttribute::POSITION : draco::GeometryAttribute::GENERIC;
        attributes += byte(type) + byte(draco::DT_FLOAT32) + byte(i == 0 ? 3 : numbers) + byte(0) + byte(i);
        decoders += byte(0);
    }
    Packed packed = packed_sheet(draco::MESH_SEQUENTIAL_ENCODING);
    packed.bytes =
        packed.bytes.substr(0, 11) + varint(triangles) + varint(points) + raw_indices + attributes + decoders;
    packed.triangles = triangles, packed.points = points, packed.position = 0;
    Triangle file = gltf_of(packed);
    file.primitive()["attributes"] = {{"POSITION", 0}};
    extension(file)["attributes"] = {{"POSITION", 0}};
    const std::uintmax_t bytes = std::uintmax_t{points} * (12 + 4 * numbers * unread);
    EXPECT_EQ(fault(file), at + "unpacks to " + std::to_string(bytes) +
                               " bytes with what was unpacked before, more than the limit of " +
                               std::to_string(std::uintmax_t{2} << 30));
}

}  // namespace
}  // namespace lapfx::test
