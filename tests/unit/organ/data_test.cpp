// Every mesh of the folder of real and deliberately broken files: those listed here are refused with the given fault,
// and all others load. The folder is not a part of the project; set LAPFX_TEST_DATA to its path.
#include <algorithm>
#include <set>

#include "lapfx/authoring/organ_report.h"
#include "organ/surface.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

struct Refused {
    const char* file;    ///< the end of its path; "*" takes the rest of a folder with it
    const char* reason;  ///< part of the fault
};

constexpr Refused refused[] = {
    {"InfinyToolkit/examples/mesh/Cautery-Hook_collision.obj", "no triangles: the file contains 33 points only"},
    {"InfinyToolkit/examples/mesh/drill_collision.obj", "no triangles: the file contains 11 points only"},
    {"InfinyToolkit/examples/mesh/drill_collision_2p.obj", "no triangles: the file contains 2 points only"},
    {"sphere_two_materials_point_cloud.gltf", "no triangles"},
    {"ACMEBox.gltf", "needs the extension ACME_gizmo"},
    {"BoundsChecking/integer-out-of-bounds.gltf", "is 1e+300, expected a whole number"},
    {"BoundsChecking/invalid-buffer-index.gltf", "/attributes: has no POSITION"},
    {"BoundsChecking/invalid-buffer-view-index.gltf", "accessor[0] invalid bufferView"},
    {"BoundsChecking/invalid-primitive-indices.gltf", "primitive indices accessor out of bounds"},
    {"tinygltf/tests/issue-416.gltf", "/asset/version"},
    {"tinygltf/tests/issue-492.glb", "no triangles"},
    {"pointCloudBadEncoding.ply", "no triangles: the file contains 10 points only"},
    {"pointCloudGoodEncoding.ply", "no triangles: the file contains 10 points only"},
    {"degenerate_mesh.obj", "no triangles that can be drawn: 1 triangle without area"},
    {"float_inf_point_cloud.ply", "no triangles: the file contains 16 points only"},
    {"float_two_att_point_cloud.ply", "no triangles: the file contains 3 points only"},
    {"inf_nan.obj", "1 triangle whose coordinates are missing, not finite or beyond 1e9 mm"},
    {"int_point_cloud.ply", "no triangles: the file contains 16 points only"},
    {"point_cloud_test_pos.ply", "no triangles: the file contains 4 points only"},
    {"point_cloud_test_pos_norm.ply", "no triangles: the file contains 4 points only"},
    {"test_lines.obj", "no triangles: the file contains 484 points only"},
    {"AssimpImporter/Test/points.obj", "no triangles: the file contains 3 points only"},
    {"StlImporter/Test/binary.stl", "2 triangles without area"},  // its corners lie on a line
    {"StanfordImporter/Test/extra-token-format.ply", "line 2: the format has to be"},
    {"StanfordImporter/Test/format-too-late.ply", "line 2: the format has to come first"},
    {"StanfordImporter/Test/format-unsupported.ply", "line 2: format \"binary_mixed_endian\" is not known"},
    {"StanfordImporter/Test/invalid-face-type.ply", "line 4: type \"float16\" is not known"},
    {"StanfordImporter/Test/invalid-signature.ply", "line 1: a PLY starts with the line ply"},
    {"StanfordImporter/Test/unknown-line.ply", "line 6: \"heh\" is not known"},
    {"StanfordImporter/Test/unsupported-face-size.ply", "truncated"},
    {"CgltfImporter/Test/required-extensions-unsupported.gltf", "needs the extension EXT_lights_image_based"},
    {"GltfImporter/Test/version-legacy.gltf", "/asset/version: is \"1.0\", only 2.0 is read"},
    {"GltfImporter/Test/scene-invalid-node-oob.gltf", "/nodes: node 7 is not in the file"},
    {"GltfImporter/Test/buffer-invalid-short-size.gltf", "/buffers/0: truncated: has 12 of 24 bytes"},
    {"GltfImporter/Test/external-data.gltf", "/buffers/0: data.bin: no such file"},
    {"GltfImporter/Test/mesh-invalid-buffer-notfound.gltf", "/buffers/0/uri"},
    // The rest of these two folders test importers with parts of files; almost none has a whole surface.
    {"magnum-plugins/src/MagnumPlugins/*GltfImporter", ""},
    {"magnum-plugins/src/MagnumPlugins/*StanfordImporter", ""}};

/// Files of those two folders that do have one.
const std::set<std::string> whole = {"mesh-colors.gltf",
                                     "mesh-primitives-types.gltf",
                                     "mesh-skin-attributes.gltf",
                                     "ascii.ply",
                                     "crlf.ply",
                                     "custom-components-be.ply",
                                     "custom-components-duplicate.ply",
                                     "custom-components.ply",
                                     "per-face-colors-be.ply",
                                     "per-face-normals-objectid.ply",
                                     "positions-char-colors4-ushort-texcoords-uchar-indices-short-be.ply",
                                     "positions-colors-normals-texcoords-float-objectid-uint-indices-int-be.ply",
                                     "positions-colors-normals-texcoords-float-objectid-uint-indices-int.ply",
                                     "positions-colors4-float-indices-int.ply",
                                     "positions-colors4-normals-texcoords-float-indices-int-be-unaligned.ply",
                                     "positions-float-indices-uint.ply",
                                     "positions-short-colors-uchar-texcoords-ushort-indices-char.ply",
                                     "positions-uchar-normals-char-objectid-short-indices-ushort.ply",
                                     "positions-ushort-normals-short-objectid-uchar-indices-uchar-be.ply",
                                     "triangle-fast-path-be.ply",
                                     "whitespace.ply"};

const Refused* find_refused(const std::string& path, const std::string& name) {
    for (const Refused& row : refused) {
        const std::string file = row.file;
        const std::size_t star = file.find('*');
        if (star == std::string::npos) {
            if (path.ends_with("/" + file)) return &row;
        } else if (path.find(file.substr(0, star)) != std::string::npos &&
                   path.find(file.substr(star + 1)) != std::string::npos && !whole.contains(name)) {
            return &row;
        }
    }
    return nullptr;
}

/// Checks what holds for every loaded organ.
void expect_sound(const Organ& organ) {
    const std::size_t vertices = organ.positions.size();
    ASSERT_GT(organ.indices.size(), 0u);
    ASSERT_TRUE(organ.normals.size() == vertices && organ.tangents.size() == vertices && organ.uvs.size() == vertices &&
                organ.colors.size() == vertices);
    std::size_t wrong = 0, covered = 0;
    for (const std::uint32_t index : organ.indices) wrong += index >= vertices;
    for (std::size_t v = 0; v < vertices; ++v) {
        const glm::vec3 t(organ.tangents[v]);
        wrong += !(std::abs(glm::length(organ.normals[v]) - 1) < 1e-3f) || !(std::abs(glm::length(t) - 1) < 1e-3f) ||
                 !(std::abs(glm::dot(organ.normals[v], t)) < 1e-2f) || std::abs(organ.tangents[v].w) != 1.0f ||
                 !std::isfinite(organ.uvs[v].x + organ.uvs[v].y) || !(glm::length(organ.positions[v]) < 1e10f);
    }
    for (const Part& part : organ.parts) {
        wrong += part.first_index != covered || part.material < 0 ||
                 static_cast<std::size_t>(part.material) >= organ.materials.size();
        covered += part.index_count;
    }
    for (const Material& material : organ.materials)
        wrong += material.base_color_image >= static_cast<int>(organ.images.size()) ||
                 material.normal_image >= static_cast<int>(organ.images.size());
    for (const Image& image : organ.images)
        wrong +=
            image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(covered, organ.indices.size());
    EXPECT_EQ(organ.counts.read, organ.counts.kept + organ.counts.dropped());
    EXPECT_EQ(organ.counts.kept, organ.triangle_count());
}

std::vector<fs::path> meshes(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        for (const char* known : {".glb", ".gltf", ".obj", ".ply", ".stl", ".off"})
            if (entry.is_regular_file() && extension == known) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

class Data : public testing::Test {
  protected:
    void SetUp() override {
        folder = data_folder();
        if (folder.empty()) GTEST_SKIP() << "no folder of test meshes; LAPFX_TEST_DATA names it";
    }
    void walk(const char* name) {
        std::size_t loaded = 0, faults = 0;
        for (const fs::path& file : meshes(folder / name)) {
            SCOPED_TRACE(file.string());
            if (const Refused* row = find_refused(file.string(), file.filename().string())) {
                const std::string fault = fault_of(file);
                EXPECT_NE(fault, "");
                EXPECT_NE(fault.find(row->reason), std::string::npos) << fault;
                ++faults;
                continue;
            }
            ++loaded;
            try {
                expect_sound(load_organ(file));
            } catch (const Error& error) {
                ADD_FAILURE() << error.what();
            }
        }
        std::cout << name << ": " << loaded << " loaded, " << faults << " refused\n";
        EXPECT_GT(loaded, 0u);
    }
    fs::path folder;
};

TEST_F(Data, Organs) {
    walk("organs");
}
TEST_F(Data, Gltf) {
    walk("gltf");
}
TEST_F(Data, Meshes) {
    walk("meshes");
}

TEST_F(Data, CountsAndTextures) {
    struct Row {
        const char* file;
        std::size_t vertices, triangles, images;
        int side;
    };
    constexpr Row rows[] = {{"HuBMAP-CCF/VH_F_Liver.glb", 48116, 93303, 0, 0},
                            {"HuBMAP-CCF/VH_F_Ovary_L.glb", 214, 424, 0, 0},
                            {"HuBMAP-CCF/VH_M_Prostate.glb", 112596, 224676, 0, 0},
                            {"whynpc9-anatomy/stomach.glb", 5430, 1810, 0, 0},
                            {"whynpc9-anatomy/liver.glb", 214401, 345525, 1, 2048},
                            {"Warp-Surgical/derived/fat.obj", 2688, 5372, 0, 0},  // its texture lies in ../textures
                            {"Warp-Surgical/derived/gallbladder.obj", 938, 1872, 0, 0},
                            {"InfinyToolkit/examples/mesh/liver_light_visu.obj", 2716, 5004, 0, 0},
                            {"sofa/share/mesh/liver-smooth.obj", 2194, 4384, 0, 0},
                            {"sofa/share/mesh/aneurysm3D_1.off", 7095, 14186, 0, 0}};
    for (const Row& row : rows) {
        const Organ organ = load_organ(folder / "organs" / row.file);
        EXPECT_EQ(organ.positions.size(), row.vertices) << row.file;
        EXPECT_EQ(organ.triangle_count(), row.triangles) << row.file;
        ASSERT_EQ(organ.images.size(), row.images) << row.file;
        if (row.images > 0) {
            EXPECT_EQ(organ.images[0].width, row.side) << row.file;
        }
    }
    EXPECT_EQ(report(load_organ(folder / "organs/Warp-Surgical/derived/abdomen_114k.obj")).non_manifold_edges, 13280u);
    EXPECT_EQ(report(load_organ(folder / "organs/Warp-Surgical/derived/tetliver.obj")).non_manifold_edges, 281u);
}

/// "../textures/fat/diffuse-base.png" is reported, and found when it is next to the organ.
TEST_F(Data, ATextureInAnotherFolderIsToldAndFoundBesideTheOrgan) {
    const fs::path from = folder / "organs/Warp-Surgical";
    EXPECT_TRUE(
        has_warning(load_organ(from / "derived/fat.obj").warnings,
                    "texture ../textures/fat/diffuse-base.png: \"../textures/fat/diffuse-base.png\" leads out of "
                    "the folder"));
    const TemporaryFolder beside;
    for (const char* file : {"derived/fat.obj", "derived/fat.mtl", "textures/fat/diffuse-base.png"})
        fs::copy_file(from / file, beside.path() / fs::path(file).filename());
    const Organ organ = load_organ(beside.path() / "fat.obj");
    ASSERT_EQ(organ.images.size(), 1u);
    EXPECT_EQ(organ.images[0].width, 2048);
}

/// The order of vertices differs, so every vertex of one is looked up on the surface of the other.
TEST_F(Data, CompressedTwinIsTheSameSurface) {
    const Organ plain = load_organ(folder / "organs/HuBMAP-CCF/VH_F_Liver.glb");
    const Organ twin = load_organ(folder / "organs/whynpc9-anatomy/liver-hubmap.glb");
    ASSERT_EQ(twin.positions.size(), plain.positions.size());
    EXPECT_EQ(twin.triangle_count(), plain.triangle_count());
    // Its meshes were quantized separately, which tears the seams between them; sewn, they are connected almost as in
    // the other.
    EXPECT_EQ(report(plain).components, 9u);
    EXPECT_LE(report(twin).components, 11u);
    const Surface surface(plain);
    double worst = 0.0;
    for (const glm::vec3& p : twin.positions) worst = std::max(worst, surface.closest_point(glm::dvec3(p)).distance);
    EXPECT_LT(worst, 0.02);  // 14 bits over 250 mm
}

}  // namespace
}  // namespace lapfx::test
