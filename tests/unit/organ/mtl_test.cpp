// Libraries and textures that are named again and again.
#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

using Paths = std::vector<fs::path>;

class Mtl : public testing::Test {
  protected:
    Organ load(const std::string& libraries) {
        return load_organ(folder.write("m.obj", libraries + "v 0 0 0\nv 9 0 0\nv 0 9 0\nusemtl a\nf 1 2 3\n"));
    }
    void picture(const char* name, const cv::Scalar& color) {
        cv::imwrite((folder.path() / name).string(), cv::Mat(8, 8, CV_8UC3, color));
    }
    fs::path at(const char* name) const { return folder.path() / name; }
    static std::ptrdiff_t warnings(const Organ& organ, const std::string& about) {
        return std::count_if(organ.warnings.begin(), organ.warnings.end(),
                             [&](const std::string& w) { return w.find(about) != std::string::npos; });
    }
    TemporaryFolder folder;
};

TEST_F(Mtl, ALibraryIsReadOnceUnderAllItsNames) {
    folder.write("a.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\n");
    std::string text;
    for (int i = 0; i < 50; ++i) text += "mtllib a.mtl\nmtllib ./a.mtl\nmtllib x/../a.mtl\n";
    const Organ organ = load(text);
    EXPECT_EQ(organ.materials.size(), 2U);
    EXPECT_EQ(organ.files, (Paths{at("m.obj"), at("a.mtl")}));
    EXPECT_EQ(organ.materials[0].base_color, glm::vec4(1, 0, 0, 1));
}

TEST_F(Mtl, LinesMayEndInCrAlone) {
    folder.write("a.mtl", "newmtl a\rKd 1 0 0\rnewmtl b\rKd 0 1 0\r");
    const Organ organ = load("mtllib a.mtl\n");
    ASSERT_EQ(organ.materials.size(), 2U);
    EXPECT_EQ(organ.materials[0].base_color, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(organ.materials[1].base_color, glm::vec4(0, 1, 0, 1));
}

TEST_F(Mtl, AByteOrderMarkBelongsToNoLine) {
    const std::string text = "newmtl a\nKd 1 0 0\n";
    std::string wide = "\xff\xfe";
    for (const char c : text) wide += std::string{c, '\0'};
    for (const std::string& bytes : {"\xef\xbb\xbf" + text, wide}) {
        folder.write("a.mtl", bytes);
        const Organ organ = load("mtllib a.mtl\n");
        ASSERT_EQ(organ.materials.size(), 1U);
        EXPECT_EQ(organ.materials[0].base_color, glm::vec4(1, 0, 0, 1));
        EXPECT_TRUE(organ.warnings.empty());
    }
}

TEST_F(Mtl, OneStatementMayNameSeveralLibraries) {
    folder.write("my red.MTL", "newmtl a\nKd 1 0 0\n");
    folder.write("b.mtl", "newmtl b\nKd 0 1 0\n");
    const Organ organ = load("mtllib gone.mtl my red.MTL  b.mtl \n");
    EXPECT_EQ(organ.files, (Paths{at("m.obj"), at("my red.MTL"), at("b.mtl")}));
    EXPECT_EQ(organ.materials.size(), 2U);
    EXPECT_EQ(warnings(organ, "gone.mtl"), 1);
}

TEST_F(Mtl, PathsOfWindowsLeadToTheFilesBeside) {
    fs::create_directory(at("textures"));
    picture("textures/skin.png", {10, 20, 30});
    picture("flat.png", {40, 50, 60});
    for (const char* library : {".\\a.mtl", "C:\\work\\a.mtl", "..\\..\\a.mtl", "old/a.mtl"})
        for (const char* name :
             {"textures\\skin.png", ".\\textures\\skin.png", "D:\\old\\textures\\skin.png", "/x/textures/skin.png"}) {
            folder.write("a.mtl", std::string("newmtl a\nmap_Kd ") + name + "\nmap_Bump C:\\far\\flat.png\n");
            const Organ organ = load(std::string("mtllib ") + library + '\n');
            ASSERT_FALSE(organ.images.empty()) << library << ' ' << name;
            EXPECT_EQ(organ.images[0].pixels[0], 30);
            EXPECT_EQ(organ.files[1], at("textures/skin.png"));
        }
    folder.write("a.mtl", "newmtl a\nmap_Kd C:\\old\\gone.png\n");
    EXPECT_EQ(warnings(load("mtllib a.mtl\n"), "\"C:/old/gone.png\" is an absolute path;"), 1);
}

TEST_F(Mtl, ClampIsOfEachMap) {
    picture("skin.png", {10, 20, 30});
    folder.write("a.mtl",
                 "newmtl a\nmap_Kd -clamp on skin.png\nnewmtl b\nmap_Kd -s 1 1 1 -clamp off skin.png\n"
                 "newmtl c\nmap_Kd -clamp ON -bm 1 ./skin.png\n");
    const Organ organ = load_organ(folder.write(
        "m.obj", "mtllib a.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nvt 0 0\nvt 2 0\nvt 0 2\nusemtl a\nf 1/1 2/2 3/3\n"));
    ASSERT_EQ(organ.images.size(), 2U);
    const auto image_of = [&](std::size_t material) {
        return organ.images[static_cast<std::size_t>(organ.materials[material].base_color_image)];
    };
    EXPECT_EQ(image_of(0).wrap_u, Wrap::clamp);
    EXPECT_EQ(image_of(0).wrap_v, Wrap::clamp);
    EXPECT_EQ(image_of(1).wrap_u, Wrap::repeat);
    EXPECT_EQ(image_of(2).wrap_u, Wrap::clamp);
    EXPECT_EQ(organ.materials[0].base_color_image, organ.materials[2].base_color_image);
    EXPECT_EQ(image_of(1).pixels, image_of(0).pixels);
    EXPECT_EQ(organ.files, (Paths{at("m.obj"), at("skin.png"), at("a.mtl")}));
}

TEST_F(Mtl, ATextureThatIsTooLargeIsShrunkAndToldOf) {
    cv::Mat large(4, 8200, CV_8UC3, cv::Scalar(10, 20, 30));
    large.colRange(4100, 8200) = cv::Scalar(200, 100, 50);
    cv::imwrite(at("large.png").string(), large);
    folder.write("a.mtl", "newmtl a\nmap_Kd large.png\n");
    const Organ organ = load("mtllib a.mtl\n");
    ASSERT_EQ(organ.images.size(), 1U);
    EXPECT_EQ(organ.images[0].width, 4100);
    EXPECT_EQ(organ.images[0].height, 2);
    EXPECT_EQ(organ.images[0].pixels[0], 30);
    EXPECT_EQ(organ.images[0].pixels[4 * 4099], 50);
    EXPECT_EQ(warnings(organ, "texture large.png: its 8200x4 pixels were shrunk to 4100x2"), 1);
}

TEST_F(Mtl, ALibraryThatCannotBeReadIsToldOfOnce) {
    folder.write("empty.mtl", "# nothing\n");
    std::string text;
    for (int i = 0; i < 50; ++i)
        text += "mtllib gone.mtl\nmtllib ./gone.mtl\nmtllib ../out.mtl\nmtllib empty.mtl\nmtllib ./empty.mtl\n";
    const Organ organ = load(text);
    EXPECT_EQ(organ.unread_files, (Paths{at("gone.mtl"), at("empty.mtl")}));
    for (const char* name : {"gone.mtl", "out.mtl", "empty.mtl"})
        EXPECT_EQ(warnings(organ, std::string("material library ") + name) +
                      warnings(organ, std::string("material library ../") + name),
                  1)
            << name;
}

TEST_F(Mtl, APictureTakesThePlaceOfAllTextures) {
    picture("own.png", {200, 0, 0});
    picture("other.jpg", {0, 0, 200});
    folder.write("a.mtl", "newmtl a\nmap_Kd own.png\nnewmtl b\nmap_Kd gone.png\n");
    load("mtllib a.mtl\n");
    const Organ organ = load_organ(at("m.obj"), {.texture = at("other.jpg")});
    ASSERT_EQ(organ.images.size(), 2U);
    EXPECT_EQ(organ.images[1].name, "other.jpg");
    EXPECT_NEAR(organ.images[1].pixels[0], 200, 6);
    for (const Material& material : organ.materials) EXPECT_EQ(material.base_color_image, 1);
    EXPECT_EQ(organ.files.back(), at("other.jpg"));
    folder.write("no.png", "text");
    EXPECT_THROW(load_organ(at("m.obj"), {.texture = at("no.png")}), Error);
    EXPECT_THROW(load_organ(at("m.obj"), {.texture = at("missing.png")}), Error);
}

TEST_F(Mtl, ATextureIsReadOnceUnderAllItsNames) {
    picture("skin.png", {10, 20, 30});
    folder.write("bad.png", "no picture");
    std::string text;
    for (int i = 0; i < 50; ++i)
        text += "newmtl m" + std::to_string(i) +
                "\nmap_Kd skin.png\nmap_Kd ./skin.png\nmap_Kd C:\\old\\skin.png\nnorm bad.png\nnorm x/../bad.png\n";
    folder.write("a.mtl", text + "newmtl a\nmap_Kd ./skin.png\n");
    const Organ organ = load("mtllib a.mtl\n");
    EXPECT_EQ(organ.images.size(), 1U);
    EXPECT_EQ(organ.files, (Paths{at("m.obj"), at("skin.png"), at("a.mtl")}));
    EXPECT_EQ(organ.unread_files, (Paths{at("bad.png")}));
    EXPECT_EQ(warnings(organ, "bad.png"), 1);
    ASSERT_EQ(organ.materials.size(), 51U);
    for (const Material& material : organ.materials) {
        EXPECT_EQ(material.base_color_image, 0);
        EXPECT_EQ(material.normal_image, -1);
    }
}

TEST_F(Mtl, WhetherAMapIsOneOfNormalsIsFoundOutOnce) {
    picture("height.png", {90, 90, 90});
    picture("normal.png", {255, 128, 128});
    std::string text;
    for (int i = 0; i < 50; ++i) text += "newmtl m\nbump height.png\nbump ./height.png\nbump -bm 0.5 normal.png\n";
    folder.write("a.mtl", text + "newmtl a\n");
    const Organ organ = load("mtllib a.mtl\n");
    EXPECT_EQ(warnings(organ, "is a height map"), 1);
    ASSERT_EQ(organ.materials.size(), 51U);
    for (std::size_t m = 0; m < 50; ++m) {
        EXPECT_EQ(organ.materials[m].normal_image, 1);
        EXPECT_EQ(organ.materials[m].normal_scale, 0.5F);
    }
}

}  // namespace
}  // namespace lapfx::test
