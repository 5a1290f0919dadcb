// Writing frames to files: all of them or none.
#include "output/frame_files.h"

#include "output/kinds.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "output/render_job.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Image picture(int shade) {
    Image image{.width = 32, .height = 16, .pixels = {}, .name = ""};
    for (int i = 0; i < 32 * 16; ++i)
        for (const int value : {shade, i % 256, 40, 255}) image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

std::vector<std::string> files_in(const test::Folder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(FormOf, ByTheName) {
    EXPECT_EQ(kind_named("a/out.png"), OutputKind::picture);
    EXPECT_EQ(kind_named("50%/out.png"), OutputKind::picture);
    EXPECT_EQ(kind_named("out_%04d.png"), OutputKind::sequence);
    EXPECT_EQ(kind_named("50%/out_%d.png"), OutputKind::sequence);
    EXPECT_EQ(kind_named("out.mkv"), OutputKind::video);
    EXPECT_EQ(kind_named("OUT.PNG"), OutputKind::picture);
    EXPECT_EQ(kind_named("Out_%04d.Png"), OutputKind::sequence);
    EXPECT_EQ(kind_named("OUT.MP4"), OutputKind::video);
    EXPECT_EQ(kind_named("%012d.b.png"), OutputKind::sequence);
    for (const char* name :
         {"out.jpg", "out", "", "out_%s.png", "%d_%d.png", "out_%04D.png", "out_%123d.png", "out_%", "%dpng"})
        EXPECT_EQ(kind_named(name), std::nullopt) << name;
    EXPECT_EQ(kind_named(std::string(1'000'000, 'a') + "%04d.png"), std::nullopt) << "no file is called so";
}

TEST(SequenceName, PadsItsNumber) {
    EXPECT_EQ(sequence_name("a/out_%04d.png", 37), "a/out_0037.png");
    EXPECT_EQ(sequence_name("50%/o%d.png", 12345), "50%/o12345.png");
    EXPECT_EQ(sequence_name("o%3d.png", 7), "o  7.png");
    EXPECT_EQ(sequence_name("%0d_%.png", 7), "7_%.png");
}

TEST(FrameFilesTest, ASequenceAppearsAtItsEnd) {
    const test::Folder folder;
    folder.write("out_01.png", "old");
    const auto files = make_frame_files(folder / "out_%02d.png", {.fps = 25, .size = {32, 16}, .count = 3});
    for (int i = 0; i < 3; ++i) files->add(picture(i * 50));
    EXPECT_EQ(test::read_text(folder / "out_01.png"), "old");
    int checked = 0;
    while (files->check()) ++checked;
    EXPECT_EQ(checked, 3);
    files->publish();
    EXPECT_THAT(files_in(folder), ElementsAre("out_00.png", "out_01.png", "out_02.png"));
    EXPECT_EQ(cv::imread((folder / "out_01.png").string()).at<cv::Vec3b>(0, 3), cv::Vec3b(40, 3, 50));
}

TEST(FrameFilesTest, DroppedNothingIsLeft) {
    const test::Folder folder;
    for (const char* name : {"out_%02d.png", "out.png", "out.mp4"}) {
        const auto files = make_frame_files(folder / name, {.fps = 25, .size = {32, 16}, .count = 2});
        files->add(picture(1));
    }
    EXPECT_THAT(files_in(folder), IsEmpty());
}

TEST(FrameFilesTest, WhatIsBrokenWhileItWaitsIsFound) {
    const test::Folder folder;
    const auto files = make_frame_files(folder / "out.png", {.fps = 25, .size = {32, 16}, .count = 1});
    files->add(picture(1));
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        if (entry.is_regular_file()) fs::resize_file(entry.path(), 60);
    EXPECT_THAT(test::faults_of([&] { files->check(); }, Failure::runtime),
                ElementsAre(AllOf(HasSubstr("out.png"), HasSubstr("is not the same when read back"))));
}

TEST(FrameFilesTest, WhatIsNoFileIsNotReplaced) {
    const test::Folder folder;
    fs::create_directory(folder / "out_02.png");
    fs::create_symlink("elsewhere.png", folder / "link.png");
    for (const char* name : {"out_%02d.png", "link.png"}) {
        const auto make = [&] {
            static_cast<void>(make_frame_files(folder / name, {.fps = 25, .size = {32, 16}, .count = 3}));
        };
        EXPECT_THAT(test::faults_of(make, Failure::runtime), ElementsAre(HasSubstr("not a plain file"))) << name;
    }
    EXPECT_THAT(files_in(folder), ElementsAre("link.png", "out_02.png"));
}

/// Places and reasons of what is wrong.
std::vector<std::string> faults(const RenderOptions& options) {
    std::vector<std::string> lines;
    for (const Fault& fault : check(options, 12)) lines.push_back(fault.text());
    return lines;
}

TEST(RenderOptionsTest, EachFaultNamesItsOption) {
    EXPECT_THAT(faults({.output = "a.mp4"}), IsEmpty());
    EXPECT_THAT(faults({.at = 3, .output = "a.png"}), IsEmpty());
    EXPECT_THAT(faults({.size = {16384, 4098}, .output = "a.mp4"}),
                ElementsAre("--size: 16384x4098 has more pixels than a frame can have: at most as many as 8192x8192"));
    EXPECT_THAT(faults({.size = {16384, 4096}, .output = "a.mp4"}), IsEmpty());
    EXPECT_THAT(faults({.size = {0, 5}, .output = "a.mp4"}), ElementsAre("--size: 0x5 is outside 1x1 to 16384x16384"));
    EXPECT_THAT(faults({.size = {641, 480}, .output = "a.mp4"}),
                ElementsAre("--size: 641x480: the sides of a video must be even"));
    EXPECT_THAT(faults({.size = {641, 480}, .at = 0, .output = "a.png"}), IsEmpty());
    EXPECT_THAT(faults({.fps = 0, .output = "a.mp4"}), ElementsAre(HasSubstr("--fps: 0 is outside 0.1 to 1000")));
    EXPECT_THAT(faults({.fps = NAN, .output = "a.mp4"}), ElementsAre(HasSubstr("--fps")));
    EXPECT_THAT(faults({.from = 5, .to = 5, .output = "a.mp4"}),
                ElementsAre("--to: 5 s is not after the first frame at 5 s"));
    EXPECT_THAT(faults({.from = 12, .output = "a.mp4"}), ElementsAre(HasSubstr("--to: 12 s")));
    EXPECT_THAT(faults({.fps = 1000, .to = 86400, .output = "a.mp4"}), ElementsAre("--to: more than a million frames"));
    EXPECT_THAT(faults({.at = -1, .output = "a.png"}), ElementsAre(HasSubstr("--at: -1 is outside")));
    EXPECT_THAT(faults({.output = "a.png"}), ElementsAre(HasSubstr("is one picture")));
    EXPECT_THAT(faults({.at = 1, .output = "a.mp4"}), ElementsAre(HasSubstr("is not a single picture")));
    EXPECT_THAT(faults({.output = "a.mp4", .codec = Codec::ffv1}),
                ElementsAre("--codec: \"ffv1\" does not go into .mp4; name the file .mkv or .avi"));
    EXPECT_THAT(faults({.output = "a.mkv", .codec = Codec::ffv1}), IsEmpty());
    EXPECT_THAT(faults({.at = 1, .output = "a.png", .codec = Codec::ffv1}), IsEmpty()) << "a picture has none";
    EXPECT_THAT(faults({.output = "a.txt"}), ElementsAre(HasSubstr("-o: \"a.txt\" is not one of")));
    EXPECT_THAT(faults({.output = "a.mp4", .amounts = "a.mp4"}), ElementsAre(HasSubstr("--amounts")));
}

TEST(FrameTimes, HoldTheFirstAndNotTheLast) {
    EXPECT_THAT(frame_times({.fps = 10, .from = 1, .to = 1.3}, 12), ElementsAre(1, 1.1, 1.2));
    EXPECT_EQ(frame_times({.fps = 25}, 12).size(), 300U);
    EXPECT_THAT(frame_times({.at = 4}, 12), ElementsAre(4));
}

}  // namespace
}  // namespace lapfx::output
