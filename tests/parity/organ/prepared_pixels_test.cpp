// Organs whose images have sizes and no pixels, on the GPU: their pixels are kept separately, freed, and decoded again.
#include <opencv2/imgcodecs.hpp>

#include "foundation.h"
#include "gl/objects.h"
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/effects.h"
#include "lapfx/prepared_organ.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"
#include "support/tissue.h"

namespace lapfx {
namespace {

class PreparedPixels : public test::SceneTest {
  protected:
    PreparedPixels() {
        cv::Mat color(64, 64, CV_8UC3), normals(32, 32, CV_8UC3);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                color.at<cv::Vec3b>(y, x) = x % 16 < 2 ? cv::Vec3b(30, 28, 168) : cv::Vec3b(130, 150, 217);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                normals.at<cv::Vec3b>(y, x) = cv::Vec3b(230, 128, static_cast<std::uint8_t>(x % 8 < 4 ? 60 : 190));
        cv::imwrite((folder / "color.png").string(), color);
        cv::imwrite((folder / "normals.png").string(), normals);
        folder.write("tissue.mtl", "newmtl tissue\nmap_Kd color.png\nnorm normals.png\n");
        write_textured("tissue.obj", test::plane(80.0, 60), 80.0f);
        scene.organ.file = "tissue.obj";
    }

    void write_textured(const std::string& name, const Organ& organ, float side) const {
        std::ofstream file(folder / name);
        file << "mtllib tissue.mtl\nusemtl tissue\n";
        for (const glm::vec3& p : organ.positions)
            file << "v " << p.x << ' ' << p.y << ' ' << p.z << "\nvt " << p.x / side + 0.5f << ' ' << p.z / side + 0.5f
                 << '\n';
        for (std::size_t i = 0; i < organ.indices.size(); ++i)
            file << (i % 3 == 0 ? "f " : " ") << organ.indices[i] + 1 << '/' << organ.indices[i] + 1
                 << (i % 3 == 2 ? "\n" : "");
    }

    static std::vector<std::uint32_t> themselves(const Organ& organ) {
        std::vector<std::uint32_t> origin(organ.positions.size());
        for (std::uint32_t v = 0; v < origin.size(); ++v) origin[v] = v;
        return origin;
    }

    /// What `draw` draws before the scene's camera, linear.
    template <class Draw>
    std::vector<float> picture(const Draw& draw) const {
        const gl::Texture color({.size = size, .format = GL_RGBA16F});
        const gl::Texture depth({.size = size, .format = GL_DEPTH_COMPONENT32F});
        const gl::Framebuffer framebuffer(color, &depth);
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &far);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, size.x, size.y);
        draw(render::view_of(scene.camera, scene.light, size));
        std::vector<float> pixels(4 * static_cast<std::size_t>(size.x * size.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(float)),
                          pixels.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return pixels;
    }
    std::vector<float> picture_of(Effects& effects) const {
        return picture([&](const View& view) { effects.draw_organ(view); });
    }
};

TEST_F(PreparedPixels, ACutOrganHasThoseOfTheFormerOne) {
    const Preset plain;
    const auto prepared = prepare_organ(scene, plain.vessels);
    const Organ loaded = load_organ(folder / "tissue.obj");
    ASSERT_EQ(loaded.positions.size(), prepared->organ().positions.size()) << "it is not split";
    ASSERT_EQ(prepared->organ().images.size(), 2U);
    Effects effects(prepared, plain), direct(loaded, plain);
    effects.set_topology(prepared->organ(), themselves(loaded));
    direct.set_topology(loaded, themselves(loaded));
    for (Effects* one : {&effects, &direct}) {
        one->set_contacts(scene.events);
        one->seek(2.0);
    }
    const glm::dvec3 place(0.0, 0.0, 5.0);
    EXPECT_GT(direct.tissue(place).vessels, 0.0);
    EXPECT_EQ(effects.tissue(place).vessels, direct.tissue(place).vessels);
    EXPECT_TRUE(picture_of(effects) == picture_of(direct)) << "colours and normals";
    for (Effects* one : {&effects, &direct}) one->set_overlay(Overlay::vessels);
    EXPECT_TRUE(picture_of(effects) == picture_of(direct)) << "densities";

    // Again with other vessel parameters: it still has the pixels.
    Preset other;
    other.vessels.vessel_width = 2.0 * other.vessels.vessel_width;
    for (Effects* one : {&effects, &direct}) one->set_preset(other);
    effects.set_topology(prepared->organ(), themselves(loaded));
    direct.set_topology(loaded, themselves(loaded));
    for (Effects* one : {&effects, &direct}) one->seek(2.0);
    EXPECT_TRUE(picture_of(effects) == picture_of(direct));
    EXPECT_EQ(effects.memory_use().pixels,
              std::filesystem::file_size(folder / "color.png") + std::filesystem::file_size(folder / "normals.png"))
        << "and lets them go";
}

TEST_F(PreparedPixels, WhereThereAreNoneTissueIsWhiteAndFlat) {
    const auto prepared = prepare_organ(scene, preset.vessels);
    const render::OrganGpu without(prepared->organ(), nullptr),
        with(prepared->organ(), nullptr, PreparedOrganAccess::state(*prepared).foundation->pixels);
    EXPECT_EQ(without.texture_memory(), 0U);
    EXPECT_GT(with.texture_memory(), 64U * 64 * 4);
    Organ bare = prepared->organ();
    bare.images.clear();
    for (Material& material : bare.materials) material.base_color_image = material.normal_image = -1;
    const render::OrganGpu plain(bare, nullptr);
    render::ViewBlock block;
    const auto of = [&](const render::OrganGpu& organ) {
        return picture([&](const View& view) {
            block.bind(view);
            organ.draw(glm::mat4(1.0f));
        });
    };
    EXPECT_TRUE(of(without) == of(plain));
    EXPECT_FALSE(of(without) == of(with));
    // An Effects also accepts it, although it cannot show missing pixels.
    Effects effects(prepared->organ(), Preset{});
    effects.seek(1.0);
    EXPECT_FALSE(picture_of(effects).empty());
}

TEST_F(PreparedPixels, AnImageThatIsColourAndNormalMapIsSentAsBoth) {
    Organ organ = load_organ(folder / "tissue.obj");
    organ.materials[0].normal_image = organ.materials[0].base_color_image;
    const render::OrganGpu one(organ, nullptr);
    const auto texels = static_cast<std::size_t>(64 * 64 * 4 / 3);  // with their smaller levels
    EXPECT_EQ(one.texture_memory(), 2 * 4 * texels);
}

TEST_F(PreparedPixels, AnInstrumentsAreLetGoAndDecodedAgain) {
    write_textured("hook.obj", test::plane(4.0, 4), 4.0f);
    scene.organ.file = "sheet.obj";
    scene.tool.file = "hook.obj";
    const PreviewOptions options{.clip_folders = {}, .wait_for_clips = true};
    const auto prepared = prepare_organ(scene, preset.vessels);
    const std::size_t files =
        std::filesystem::file_size(folder / "color.png") + std::filesystem::file_size(folder / "normals.png");
    EXPECT_EQ(PreparedOrganAccess::state(*prepared).tool_pixel_memory(), files + 4 * (64 * 64 + 32 * 32));
    Preview first(scene, preset, prepared, options);
    EXPECT_EQ(first.memory_use().pixels, files);
    const Image expected = first.image(1.0, size);
    Preview second(scene, preset, prepared, options);
    EXPECT_EQ(second.memory_use().pixels, files);
    EXPECT_EQ(second.memory_use().textures, first.memory_use().textures);
    EXPECT_TRUE(second.image(1.0, size).pixels == expected.pixels);
}

}  // namespace
}  // namespace lapfx
