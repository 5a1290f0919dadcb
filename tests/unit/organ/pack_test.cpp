// The result of pack_organ(): the organ loads from it as from its own folder.
#include "lapfx/authoring/pack.h"

#include <gmock/gmock.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <map>
#include <opencv2/imgcodecs.hpp>

#include "unit/organ/gltf_fixtures.h"

namespace lapfx::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* corners = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nvt 0 0\nvt 1 0\nvt 0 1\n";

class Pack : public testing::Test {
  protected:
    void picture(const std::string& name) const {
        cv::imwrite((from.path() / name).string(), cv::Mat(2, 3, CV_8UC3, cv::Scalar(10, 20, 30)));
    }
    /// The mesh, where the pack lies.
    fs::path unpacked(const fs::path& mesh) {
        const std::vector<PackedFile> files = pack_organ(mesh);
        names.clear();
        for (const PackedFile& file : files) {
            to.write(file.name, std::string(file.bytes.begin(), file.bytes.end()));
            names.push_back(file.name);
        }
        return to.path() / files.front().name;
    }
    std::string text_of(const std::string& name) const {
        std::ifstream file(to.path() / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    TemporaryFolder from, to;
    std::vector<std::string> names;  ///< of the pack
};

std::vector<std::string> material_names(const Organ& organ) {
    std::vector<std::string> names;
    for (const Part& part : organ.parts) names.push_back(organ.materials[static_cast<std::size_t>(part.material)].name);
    return names;
}

TEST_F(Pack, ANumberSignIsPartOfANameAndAStartOfAComment) {
    picture("b#2.png");
    from.write("a#1.mtl",
               "# who made it\nnewmtl  Hard Shiny \nKd 1 0 0 # of whom\nnewmtl Material #25\nKd 0 1 0#of whom\n"
               "newmtl Material #26\nmap_Kd -o 0 0 0 b#2.png # of whom\nnewmtl plain # said here\nKd 0 0 1\n");
    const fs::path mesh = from.write("m.obj", std::string("mtllib a#1.mtl\n") + corners +
                                                  "usemtl Hard Shiny\t\nf 1/1 2/2 3/3# a face\nusemtl Material #25\n"
                                                  "f 1/1 2/2 4/3\nusemtl Material #26\nf 2/1 3/2 4/3\nusemtl plain\n"
                                                  "f 1/1 3/2 4/3\n");
    const Organ organ = load_organ(mesh), copy = load_organ(unpacked(mesh));
    EXPECT_THAT(names, ElementsAre("m.obj", "b_2.png", "a_1.mtl"));
    EXPECT_EQ(text_of("a_1.mtl"),
              "newmtl  Hard Shiny\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\nnewmtl Material #26\n"
              "map_Kd -o 0 0 0 b_2.png\nnewmtl plain # said here\nKd 0 0 1\n");
    EXPECT_THAT(copy.warnings, testing::IsEmpty());
    EXPECT_THAT(material_names(copy), ElementsAre("Hard Shiny", "Material #25", "Material #26", "plain # said here"));
    EXPECT_EQ(material_names(copy), material_names(organ));
    ASSERT_EQ(copy.images.size(), 1U);
    EXPECT_EQ(copy.materials[static_cast<std::size_t>(copy.parts[2].material)].base_color_image, 0);
}

TEST_F(Pack, ALibraryIsWhatTheReaderTakesForOne) {
    from.write("a.mtl", "newmtl a\nKd 1 0 0\n");
    from.write("#b.mtl", "newmtl b\nKd 0 1 0\n");
    from.write("c d.mtl", "newmtl c\nKd 0 0 1\n");
    const fs::path mesh =
        from.write("m.obj", std::string("mtllib\va.mtl\n\fmtllib\f#b.mtl\nmtllib c\\\nd.mtl\nmtllibs a.mtl\n") +
                                corners + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\nusemtl c\nf 2 3 4\n");
    ASSERT_THAT(material_names(load_organ(mesh)), ElementsAre("a", "b", "c"));
    EXPECT_THAT(material_names(load_organ(unpacked(mesh))), ElementsAre("a", "b", "c"));
    EXPECT_THAT(text_of("m.obj"), testing::StartsWith("mtllib a.mtl\nmtllib _b.mtl\nmtllib c_d.mtl\nmtllibs a.mtl\nv"));
}

TEST_F(Pack, WhatIsFoundByPathsOfWindowsAndBehindByteOrderMarksIsPacked) {
    picture("skin.png");
    from.write("a.mtl", "\xef\xbb\xbfnewmtl a\nmap_Kd -clamp on C:\\old\\skin.png\n");
    from.write("b.mtl", "newmtl b\nKd 0 1 0\n");
    const fs::path mesh = from.write("m.obj", std::string("\xef\xbb\xbfmtllib .\\a.mtl b.mtl\n") + corners +
                                                  "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 4/3\n");
    const Organ copy = load_organ(unpacked(mesh));
    EXPECT_THAT(names, testing::UnorderedElementsAre("m.obj", "a.mtl", "b.mtl", "skin.png"));
    EXPECT_THAT(material_names(copy), ElementsAre("a", "b"));
    EXPECT_THAT(copy.warnings, testing::IsEmpty());
    ASSERT_EQ(copy.images.size(), 1U);
    EXPECT_EQ(copy.images[0].wrap_u, Wrap::clamp);
}

TEST_F(Pack, TexturesThatCommentsOfAPlyName) {
    picture("my skin.png");
    const fs::path mesh = from.write(
        "m.ply",
        "ply\nformat ascii 1.0\ncomment TextureFile gone.png\ncomment TextureFile my skin.png\nelement vertex 3\n"
        "property float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
        "property list uchar int vertex_index\nproperty int texnumber\nend_header\n0 0 0 0 0\n9 0 0 1 0\n0 9 0 0 1\n"
        "3 0 1 2 1\n");
    const Organ copy = load_organ(unpacked(mesh));
    EXPECT_THAT(names, ElementsAre("m.ply", "my_skin.png"));
    EXPECT_THAT(text_of("m.ply"), HasSubstr("comment TextureFile gone.missing\ncomment TextureFile my_skin.png\n"));
    ASSERT_EQ(copy.images.size(), 1U);
    EXPECT_EQ(copy.materials[static_cast<std::size_t>(copy.parts[0].material)].base_color_image, 0);
}

TEST_F(Pack, LinesThatEndInCrAloneStayLines) {
    from.write("a#1.mtl", "newmtl a\rKd 1 0 0\rnewmtl b\rKd 0 1 0\r");
    const fs::path mesh = from.write("m.obj",
                                     "mtllib a#1.mtl\rv 0 0 0\rv 9 0 0\rv 0 9 0\rv 0 0 9\rusemtl a\rf 1 2 3\r"
                                     "usemtl b\rf 1 2 4\r");
    ASSERT_THAT(material_names(load_organ(mesh)), ElementsAre("a", "b"));
    const Organ copy = load_organ(unpacked(mesh));
    EXPECT_THAT(material_names(copy), ElementsAre("a", "b"));
    EXPECT_EQ(copy.materials[1].base_color, glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(copy.triangle_count(), 2U);
    EXPECT_THAT(text_of("m.obj"), testing::StartsWith("mtllib a_1.mtl\rv 0 0 0\r"));
}

/// How often files of a folder are opened.
class Opened {
  public:
    explicit Opened(const fs::path& folder) : queue_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        // Closing in between makes two reads distinct.
        EXPECT_GE(::inotify_add_watch(queue_, folder.c_str(), IN_OPEN | IN_CLOSE), 0);
    }
    ~Opened() { ::close(queue_); }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    std::map<std::string, int> take() const {
        std::map<std::string, int> times;
        alignas(inotify_event) char buffer[65536];
        for (ssize_t got = 0; (got = ::read(queue_, buffer, sizeof buffer)) > 0;)
            for (ssize_t at = 0; at < got;) {
                const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
                if ((event->mask & IN_OPEN) != 0 && event->len > 0) ++times[event->name];
                at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
            }
        return times;
    }

  private:
    int queue_;
};

TEST_F(Pack, EachFileIsReadOnceHoweverOftenItIsNamed) {
    picture("skin.png");
    from.write("broken.png", "no picture");
    from.write("words.mtl", "no material");
    std::string libraries, maps;
    for (int i = 0; i < 20; ++i) {
        libraries += "mtllib a.mtl\nmtllib ./a.mtl\nmtllib words.mtl\nmtllib gone.mtl\n";
        maps += "map_Kd skin.png\nmap_Kd ./skin.png\nmap_Ks broken.png\n";
    }
    from.write("a.mtl", "newmtl m\n" + maps);
    const fs::path mesh = from.write("m.obj", libraries + corners + "usemtl m\nf 1/1 2/2 3/3\n");
    const Opened opened(from.path());
    pack_organ(mesh);
    EXPECT_EQ(opened.take(), (std::map<std::string, int>{
                                 {"m.obj", 1}, {"a.mtl", 1}, {"words.mtl", 1}, {"skin.png", 1}, {"broken.png", 1}}));
    EXPECT_EQ(load_organ(unpacked(mesh)).images.size(), 1U);
    EXPECT_THAT(names, ElementsAre("m.obj", "skin.png", "a.mtl"));
}

TEST_F(Pack, ALengthMayBeWrittenAsAFloat) {
    Triangle triangle;
    triangle.json["buffers"][0] = {{"byteLength", 36.0}, {"uri", "t.bin"}};
    from.write("t.bin", triangle.binary + "what does not belong to it");
    const fs::path mesh = from.write("t.gltf", triangle.json.dump());
    ASSERT_THAT(triangle.json.dump(), HasSubstr("\"byteLength\":36.0"));
    EXPECT_EQ(load_organ(unpacked(mesh)).positions, load_organ(mesh).positions);
    EXPECT_EQ(text_of("t.bin"), triangle.binary);
    triangle.json["buffers"][0]["byteLength"] = 999.0;
    EXPECT_THROW(pack_organ(from.write("t.gltf", triangle.json.dump())), Error);
}

/// One that is shorter comes first, or last.
TEST_F(Pack, BuffersOfOneFileMayTakeDifferentLengths) {
    for (const bool first : {true, false}) {
        Triangle triangle;
        const int longer = first ? 1 : 0;
        const json lengths = first ? json{36, 72} : json{72, 36};
        triangle.json["buffers"] = {{{"uri", "t.bin"}, {"byteLength", lengths[0]}},
                                    {{"uri", "./t.bin"}, {"byteLength", lengths[1]}}};
        triangle.json["bufferViews"][0] = {{"buffer", longer}, {"byteOffset", 36}, {"byteLength", 36}};
        from.write("t.bin", std::string(36, '\0') + triangle.binary + "more");
        const fs::path mesh = from.write("t.gltf", triangle.json.dump());
        const Organ copy = load_organ(unpacked(mesh));
        EXPECT_EQ(copy.positions, load_organ(mesh).positions);
        EXPECT_EQ(copy.positions[1], glm::vec3(100, 0, 0));
        EXPECT_THAT(names, ElementsAre("t.gltf", "t.bin"));
        EXPECT_EQ(text_of("t.bin").size(), 72U);
    }
}

TEST_F(Pack, AFileThatIsAPictureAndABufferIsBoth) {
    picture("own.png");
    Triangle triangle;
    triangle.json["buffers"] = {{{"uri", "t.bin"}, {"byteLength", 36}}, {{"uri", "own.png"}, {"byteLength", 4}}};
    triangle.json["images"] = json::parse(R"([{"uri": "own.png"}])");
    triangle.json["textures"] = json::parse(R"([{"source": 0}])");
    triangle.json["materials"] = json::parse(R"([{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])");
    triangle.primitive()["material"] = 0;
    from.write("t.bin", triangle.binary);
    const Organ copy = load_organ(unpacked(from.write("t.gltf", triangle.json.dump())));
    ASSERT_EQ(copy.images.size(), 1U);
    EXPECT_EQ(copy.images[0].width, 3);
    EXPECT_THAT(names, ElementsAre("t.gltf", "t.bin", "own.bin", "own.png"));
    EXPECT_EQ(text_of("own.bin").size(), 4U);
}

/// The text of the OBJ must not count as one of its libraries, because names in that would not be replaced.
TEST_F(Pack, AMeshThatIsItsOwnLibraryIsPackedAsBoth) {
    picture("my skin.png");
    const fs::path mesh = from.write(
        "m.obj", std::string("mtllib m.obj\nnewmtl m\nmap_Kd my skin.png\n") + corners + "usemtl m\nf 1/1 2/2 3/3\n");
    ASSERT_EQ(load_organ(mesh).images.size(), 1U);
    EXPECT_EQ(load_organ(unpacked(mesh)).images.size(), 1U);
    EXPECT_THAT(names, ElementsAre("m.obj", "my_skin.png", "m.mtl"));
    EXPECT_THAT(text_of("m.mtl"), Not(HasSubstr("my skin")));
}

}  // namespace
}  // namespace lapfx::test
