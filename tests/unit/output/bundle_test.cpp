// Bundles: everything is inside, nothing is half written, and other files are not touched.
#include "output/bundle.h"

#include <gmock/gmock.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "lapfx/authoring/clip.h"
#include "output/files.h"
#include "support/folders.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

const fs::path samples = test::source_folder() / "samples";

Image picture() {
    Image image{.width = 8, .height = 4, .pixels = {}, .name = ""};
    image.pixels.assign(8 * 4 * 4, 200);
    return image;
}

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

Preset preset_with(const fs::path& folder, const std::vector<std::string>& clips) {
    Preset preset;
    preset.name = "Ooze";
    preset.bleeding.speed = 7.5;
    preset.folder = folder;
    for (const std::string& clip : clips) preset.smoke.clips.push_back({.file = clip});
    return preset;
}

class BundleTest : public testing::Test {
  protected:
    void SetUp() override {
        fs::create_directories(from_ / "a");
        fs::create_directories(from_ / "b");
        fs::copy_file(samples / "clips/wisps_thin.mp4", from_ / "a/smoke.mp4");
        fs::copy_file(samples / "clips/plume_thick.mp4", from_ / "b/smoke.mp4");
    }
    Bundle bundle(const Preset& preset) {
        return {.preset = preset, .folder = to_ / "ooze", .clip_folders = {samples / "clips"}, .thumbnail = picture()};
    }
    test::Folder from_, to_;
};

TEST_F(BundleTest, ClipsLieInsideOnceUnderNamesOfTheirOwn) {
    const Preset preset = preset_with(from_.path(), {"a/smoke.mp4", "b/smoke.mp4", "a/smoke.mp4", "haze_rolling.mp4"});
    const BundleContent made = write_bundle(bundle(preset));
    EXPECT_THAT(files_in(to_ / "ooze"), ElementsAre("clips/haze_rolling.mp4", "clips/smoke-2.mp4", "clips/smoke.mp4",
                                                    "ooze.json", "thumbnail.png"));
    EXPECT_EQ(made.files, 5U);
    EXPECT_EQ(made.clips, 4U);
    const Preset read = load_preset(to_ / "ooze/ooze.json");
    EXPECT_EQ(read.bleeding.speed, 7.5);
    ASSERT_EQ(read.smoke.clips.size(), 4U);
    EXPECT_EQ(read.smoke.clips[0].file, "clips/smoke.mp4");
    EXPECT_EQ(read.smoke.clips[1].file, "clips/smoke-2.mp4");
    EXPECT_EQ(read.smoke.clips[2].file, "clips/smoke.mp4");
    EXPECT_EQ(test::read_text(to_ / "ooze/clips/smoke-2.mp4"), test::read_text(from_ / "b/smoke.mp4"));
    EXPECT_THAT(files_in(to_.path()), testing::SizeIs(5)) << "nothing is left beside it";
}

TEST_F(BundleTest, ASequenceComesWithAllItsImages) {
    for (int i = 3; i < 6; ++i)
        fs::copy_file(samples / "pictures" / fs::directory_iterator(samples / "pictures")->path().filename(),
                      from_ / ("frame_0" + std::to_string(i) + ".png"));
    write_bundle(bundle(preset_with(from_.path(), {"frame_%02d.png"})));
    EXPECT_EQ(load_preset(to_ / "ooze/ooze.json").smoke.clips[0].file, "clips/frame_frames/%06d.png");
    EXPECT_THAT(files_in(to_ / "ooze"), ElementsAre("clips/frame_frames/000000.png", "clips/frame_frames/000001.png",
                                                    "clips/frame_frames/000002.png", "ooze.json", "thumbnail.png"));
    EXPECT_EQ(report_clip(to_ / "ooze/clips/frame_frames/%06d.png").frames, 3);
}

/// Of x10 to x20, "x1%d" stands for ten; of s0 to s2, the first one is a clip, too.
TEST_F(BundleTest, ClipsThatStartWithTheSameImageAreDifferent) {
    const fs::path picture = samples / "pictures/lagb.png";
    for (int i = 0; i < 3; ++i) fs::copy_file(picture, from_ / ("s" + std::to_string(i) + ".png"));
    for (int i = 10; i <= 20; ++i) fs::copy_file(picture, from_ / ("x" + std::to_string(i) + ".png"));
    write_bundle(bundle(preset_with(from_.path(), {"s0.png", "s%d.png", "x%d.png", "x1%d.png", "s%d.png", "s0.png"})));
    std::vector<std::string> clips;
    std::vector<int> frames;
    for (const SmokeClip& clip : load_preset(to_ / "ooze/ooze.json").smoke.clips) {
        clips.push_back(clip.file);
        frames.push_back(report_clip(to_ / "ooze" / clip.file).frames);
    }
    EXPECT_THAT(clips, ElementsAre("clips/s0.png", "clips/sframes/%06d.png", "clips/xframes/%06d.png",
                                   "clips/x1frames/%06d.png", "clips/sframes/%06d.png", "clips/s0.png"));
    EXPECT_THAT(frames, ElementsAre(1, 3, 11, 10, 3, 1));
}

TEST_F(BundleTest, AnImageOfASequenceThatIsNoneStaysBehindWithTheBundle) {
    const fs::path picture = samples / "pictures/lagb.png";
    for (int i = 0; i < 3; ++i) fs::copy_file(picture, from_ / ("frame_" + std::to_string(i) + ".png"));
    from_.write("frame_1.png", "-----BEGIN OPENSSH PRIVATE KEY-----\n" + std::string(600, 'x'));
    EXPECT_THAT(test::faults_of([&] { write_bundle(bundle(preset_with(from_.path(), {"frame_%d.png"}))); }),
                ElementsAre(HasSubstr("frame_1.png: is not a video that can be decoded")));
    EXPECT_TRUE(fs::is_empty(to_.path()));
}

TEST_F(BundleTest, TheOrgansTextureComesAlong) {
    Bundle whole = bundle(preset_with(from_.path(), {}));
    whole.scene = load_scene(samples / "lagb.scene.json");
    const fs::path picture = samples / "pictures/lagb.png";
    whole.scene->organ.texture = picture.string();
    write_bundle(whole);
    const Scene scene = load_scene(to_ / "ooze/ooze.scene.json");
    EXPECT_EQ(scene.organ.texture, "texture/" + picture.filename().string());
    EXPECT_EQ(test::read_text(to_ / "ooze" / scene.organ.texture), test::read_text(picture));
}

TEST_F(BundleTest, SceneAndOrganComeAlong) {
    Bundle whole = bundle(preset_with(from_.path(), {}));
    whole.scene = load_scene(samples / "lagb.scene.json");
    whole.scene->reference.file = "/somewhere/patient.mp4";
    write_bundle(whole);
    const Scene scene = load_scene(to_ / "ooze/ooze.scene.json");
    EXPECT_EQ(scene.preset, "ooze.json");
    EXPECT_EQ(scene.organ.file, "organ/lagb.glb");
    EXPECT_EQ(scene.tool.file, "tool/hook_cautery.glb");
    EXPECT_EQ(scene.reference.file, "");
    EXPECT_EQ(scene.events.size(), 3U);
    EXPECT_EQ(test::read_text(to_ / "ooze/organ/lagb.glb"), test::read_text(samples / "lagb.glb"));
}

TEST_F(BundleTest, AMissingClipIsNamedAndNothingIsLeft) {
    EXPECT_THAT(test::faults_of([&] {
                    write_bundle(bundle(preset_with(from_.path(), {"a/smoke.mp4", "gone.mp4"})));
                }),
                ElementsAre(AllOf(HasSubstr("/smoke/clips/1/file"), HasSubstr("gone.mp4"))));
    EXPECT_TRUE(fs::is_empty(to_.path()));
}

TEST_F(BundleTest, ABrokenClipIsFoundBeforeTheBundleAppears) {
    from_.write("bad.mp4", std::string(4096, '\1'));
    EXPECT_THAT(test::faults_of([&] { write_bundle(bundle(preset_with(from_.path(), {"bad.mp4"}))); }),
                ElementsAre(HasSubstr("/smoke/clips/0/file")));
    EXPECT_TRUE(fs::is_empty(to_.path()));
}

TEST_F(BundleTest, GivenUpNothingIsLeftAndTheOldOneStays) {
    write_bundle(bundle(preset_with(from_.path(), {"a/smoke.mp4"})));
    const auto before = files_in(to_.path());
    double last = -1;
    EXPECT_THAT(test::faults_of(
                    [&] {
                        write_bundle(bundle(preset_with(from_.path(), {"b/smoke.mp4"})), [&](double share) {
                            EXPECT_GE(share, last);
                            last = share;
                            return share < 0.1;
                        });
                    },
                    Failure::runtime),
                ElementsAre(HasSubstr("cancelled")));
    EXPECT_EQ(files_in(to_.path()), before);
    EXPECT_EQ(test::read_text(to_ / "ooze/clips/smoke.mp4"), test::read_text(from_ / "a/smoke.mp4"));
}

TEST_F(BundleTest, ABundleIsReplacedAndAnythingElseIsNot) {
    write_bundle(bundle(preset_with(from_.path(), {"a/smoke.mp4"})));
    write_bundle(bundle(preset_with(from_.path(), {})));
    EXPECT_THAT(files_in(to_ / "ooze"), ElementsAre("ooze.json", "thumbnail.png"));
    to_.write("ooze/notes.txt", "mine");
    EXPECT_THAT(test::faults_of([&] { write_bundle(bundle(preset_with(from_.path(), {}))); }, Failure::runtime),
                ElementsAre(HasSubstr("notes.txt")));
    EXPECT_EQ(test::read_text(to_ / "ooze/notes.txt"), "mine");
    EXPECT_EQ(check_bundle_folder(to_ / "new"), "");
    to_.write("file", "x");
    EXPECT_THAT(check_bundle_folder(to_ / "file"), HasSubstr("not a folder"));
}

/// A file system of 256 KiB, if this user may make one; otherwise a limit on the size of files, which also makes writes
/// fail.
TEST_F(BundleTest, AFullDiskIsToldAndNothingIsLeft) {
    const fs::path small = to_ / "small";
    fs::create_directory(small);
    Bundle whole = bundle(preset_with(from_.path(), {"b/smoke.mp4"}));
    whole.folder = small / "ooze";
    const bool mounted = ::mount("none", small.c_str(), "tmpfs", 0, "size=64k") == 0;
    rlimit before{};
    if (!mounted) {
        ::signal(SIGXFSZ, SIG_IGN);
        ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
        const rlimit tight{.rlim_cur = 65536, .rlim_max = before.rlim_max};
        ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    }
    const auto faults = test::faults_of([&] { write_bundle(whole); }, Failure::runtime);
    const bool empty = fs::is_empty(small);
    if (mounted)
        ::umount(small.c_str());
    else
        ::setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(faults, ElementsAre(AllOf(HasSubstr("smoke.mp4"), HasSubstr("cannot be written"))));
    EXPECT_TRUE(empty);
}

TEST_F(BundleTest, APresetAloneKeepsItsClipsWhereItCan) {
    const Preset preset = preset_with(from_.path(), {"a/smoke.mp4", "haze_rolling.mp4"});
    const std::vector<fs::path> shipped{samples / "clips"};
    export_preset(preset, from_ / "tuned.json", shipped);
    EXPECT_EQ(write_preset(load_preset(from_ / "tuned.json")), write_preset(preset));
    export_preset(preset, from_ / "a/tuned.json", shipped);
    EXPECT_EQ(load_preset(from_ / "a/tuned.json").smoke.clips[0].file, "smoke.mp4");
    EXPECT_THAT(test::faults_of([&] { export_preset(preset, to_ / "tuned.json", shipped); }),
                ElementsAre(AllOf(HasSubstr("/smoke/clips/0/file"), HasSubstr("is outside"))));
    EXPECT_FALSE(fs::exists(to_ / "tuned.json"));
    to_.write("haze_rolling.mp4", "another");
    EXPECT_THAT(test::faults_of([&] {
                    export_preset(preset_with(from_.path(), {"haze_rolling.mp4"}), to_ / "tuned.json", shipped);
                }),
                ElementsAre(HasSubstr("would be used instead of the shipped clip")));
}

TEST_F(BundleTest, AnOrganComesWithTheFilesThatItNamesAndNoOthers) {
    fs::create_directory(from_ / "maps");
    write_png(from_ / "maps/my skin.png", picture());
    write_png(from_ / "bump.png", picture());
    from_.write("secret.png", "x");
    from_.write("a.mtl", "newmtl m\nmap_Kd maps/my skin.png\nmap_bump bump.png\nnewmtl n\nmap_Kd maps/my skin.png\n");
    from_.write("a.obj",
                "mtllib a.mtl\nmtllib gone.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\n"
                "f 1/1 2/2 3/3\nusemtl n\nf 1/1 3/3 2/2\n");
    Bundle whole = bundle(preset_with(from_.path(), {}));
    whole.scene.emplace();
    whole.scene->folder = from_.path();
    whole.scene->organ.file = "a.obj";
    write_bundle(whole);
    EXPECT_THAT(files_in(to_ / "ooze"),
                UnorderedElementsAre("ooze.json", "ooze.scene.json", "thumbnail.png", "organ/a.obj", "organ/a.mtl",
                                     "organ/my_skin.png", "organ/bump.png"));
    EXPECT_EQ(test::read_text(to_ / "ooze/organ/a.mtl"),
              "newmtl m\nmap_Kd my_skin.png\nmap_bump bump.png\nnewmtl n\nmap_Kd my_skin.png\n");
    EXPECT_EQ(load_organ(to_ / "ooze/organ/a.obj").images.size(), load_organ(from_ / "a.obj").images.size());
}

/// Its materials are changed in the copy, just before that is loaded back.
TEST_F(BundleTest, AnOrganThatComesBackWithOtherMaterialsIsNoCopy) {
    const std::string text = "newmtl Material #25\nKd 1 0 0\nnewmtl Material #26\nKd 0 1 0\n";
    from_.write("a#1.mtl", text);
    from_.write("a.obj",
                "mtllib a#1.mtl\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nusemtl Material #25\nf 1 2 3\n"
                "usemtl Material #26\nf 1 2 4\n");
    Bundle whole = bundle(preset_with(from_.path(), {}));
    whole.scene.emplace();
    whole.scene->folder = from_.path();
    whole.scene->organ.file = "a.obj";
    write_bundle(whole);
    EXPECT_EQ(test::read_text(to_ / "ooze/organ/a_1.mtl"), text);
    for (const char* other : {"newmtl Material #25\nKd 1 0 0\nnewmtl Material #26\nKd 0 0 1\n",
                              "newmtl Material #26\nKd 1 0 0\nnewmtl Material #25\nKd 0 1 0\n"}) {
        const auto spoil = [&](double share) {
            if (share < 0.9) return true;
            for (const auto& entry : fs::recursive_directory_iterator(to_.path()))
                if (entry.path().filename() == "a_1.mtl" && entry.path() != to_ / "ooze/organ/a_1.mtl")
                    std::ofstream(entry.path()) << other;
            return true;
        };
        EXPECT_THAT(test::faults_of([&] { write_bundle(whole, spoil); }, Failure::runtime),
                    ElementsAre(HasSubstr("organ/a.obj: the copy is not the same organ")));
    }
    EXPECT_EQ(test::read_text(to_ / "ooze/organ/a_1.mtl"), text) << "the old one stays";
}

TEST_F(BundleTest, ASlashAtTheEndIsNoPartOfTheName) {
    Bundle whole = bundle(preset_with(from_.path(), {}));
    whole.folder = to_ / "ooze/";
    write_bundle(whole);
    EXPECT_THAT(files_in(to_ / "ooze"), ElementsAre("ooze.json", "thumbnail.png"));
    EXPECT_EQ(check_bundle_folder(to_ / "ooze/"), "");
    EXPECT_THAT(check_bundle_folder("/"), HasSubstr("no name"));
    EXPECT_THAT(check_bundle_folder(""), HasSubstr("no name"));
}

}  // namespace
}  // namespace lapfx::output
