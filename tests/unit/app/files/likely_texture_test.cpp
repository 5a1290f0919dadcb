#include "app/files/likely_texture.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/files/organ_picture.h"
#include "unit/organ/fixtures.h"

namespace lapfx::app {
namespace {

namespace fs = std::filesystem;

TEST(LikelyTexture, IsTheOneOfThatNameOrOfThatOrganOrTheOnlyOne) {
    const test::TemporaryFolder folder;
    const fs::path missing = folder.path() / "diffuse.png", mesh = "organs/liver_light.obj";
    EXPECT_EQ(likely_texture(missing, mesh), std::nullopt);
    const auto add = [&](const fs::path& name) {
        fs::create_directories((folder.path() / name).parent_path());
        std::ofstream(folder.path() / name) << 'x';
        return folder.path() / name;
    };
    add("liver_normal.png");
    add("notes.txt");
    EXPECT_EQ(likely_texture(missing, mesh), std::nullopt) << "a normal map is none";
    const fs::path only = add("textures/skin.jpg");
    EXPECT_EQ(likely_texture(missing, mesh), only);
    add("textures/wood.jpg");
    EXPECT_EQ(likely_texture(missing, mesh), std::nullopt) << "either may be it";
    const fs::path organ = add("textures/Liver_texture.jpg");
    EXPECT_EQ(likely_texture(missing, mesh), organ);
    const fs::path name = add("Diffuse.jpg");
    EXPECT_EQ(likely_texture(missing, mesh), name);
    EXPECT_EQ(missing_textures({"a.mtl", "b.png", "c.bin"}), (std::vector<fs::path>{"b.png"}));
}

TEST(MissingTexture, IsToldAsWhatItIsAndOfferedWithTheFolderThatTellsItApart) {
    const test::TemporaryFolder folder;
    const fs::path mesh = folder.path() / "liver.obj";
    Organ organ;
    organ.unread_files = {folder.path() / "b.png"};
    const auto words = [&] { return words_of(*missing_texture(organ, mesh)); };
    const auto offer = [&] { return offer_of(*missing_texture(organ, mesh)); };
    EXPECT_EQ(words(), "Its texture b.png is missing");
    EXPECT_EQ(missing_texture(organ, mesh)->likely, std::nullopt);
    fs::create_directory(folder.path() / "other");
    std::ofstream(folder.path() / "other/skin.png") << 'x';
    EXPECT_EQ(offer(), "Use skin.png");
    std::ofstream(folder.path() / "other/b.png") << 'x';
    EXPECT_EQ(offer(), "Use other/b.png") << "else it seems to be the one that is missing";
    std::ofstream(folder.path() / "b.png") << "no picture";
    EXPECT_EQ(words(), "Its texture b.png cannot be read");
}

TEST(OrganPicture, ShowsTheOrganFromTheFrontInItsColours) {
    const test::TemporaryFolder folder;
    const fs::path file = folder.write("two.obj",
                                       "mtllib two.mtl\nv 0 0 0\nv 40 0 0\nv 40 20 0\nv 0 20 0\nv 0 0 5\nv 20 0 5\n"
                                       "v 20 20 5\nv 0 20 5\nusemtl red\nf 1 2 3 4\nusemtl blue\nf 5 6 7 8\n");
    folder.write("two.mtl", "newmtl red\nKd 0.8 0 0.1\nnewmtl blue\nKd 0 0.1 0.8\n");
    const OrganPicture seen = organ_picture(load_organ(file), glm::dmat3(1.0), {100, 100});
    EXPECT_NEAR(seen.units_per_pixel, 40.0 / 90, 1e-9);
    const auto at = [&](int x, int y) { return seen.image.pixels.data() + 4 * (100 * y + x); };
    EXPECT_EQ(at(50, 10)[3], 0) << "above it";
    EXPECT_GT(at(30, 50)[2], 2 * at(30, 50)[0]) << "blue lies before red";
    EXPECT_GT(at(70, 50)[0], 2 * at(70, 50)[2]);
    const OrganPicture back = organ_picture(load_organ(file), glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, -1), {100, 100});
    const std::uint8_t* const p = back.image.pixels.data() + 4 * (100 * 50 + 70);
    EXPECT_GT(p[0], 2 * p[2]) << "red from behind";
}

}  // namespace
}  // namespace lapfx::app
