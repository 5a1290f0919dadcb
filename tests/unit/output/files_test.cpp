#include "output/files.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

namespace fs = std::filesystem;

Image picture() {
    Image image{.width = 32, .height = 16, .pixels = {}, .name = ""};
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            for (const int value : {x * 8, y * 16, 40, 255}) image.pixels.push_back(static_cast<std::uint8_t>(value));
    return image;
}

std::vector<std::string> files_in(const test::Folder& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename().string());
    return names;
}

TEST(WritePng, KeepsEveryPixel) {
    const test::Folder folder;
    write_png(folder / "p.png", picture());
    const cv::Mat read = cv::imread((folder / "p.png").string(), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(read.size(), cv::Size(32, 16));
    ASSERT_EQ(read.type(), CV_8UC3);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            EXPECT_EQ(read.at<cv::Vec3b>(y, x),
                      cv::Vec3b(40, static_cast<std::uint8_t>(y * 16), static_cast<std::uint8_t>(x * 8)));
    EXPECT_THAT(files_in(folder), testing::ElementsAre("p.png"));
}

TEST(WritePng, AFolderThatIsNotThereIsAFailure) {
    const test::Folder folder;
    EXPECT_THAT(test::faults_of([&] { write_png(folder / "no/p.png", picture()); }, Failure::runtime),
                testing::SizeIs(1));
}

TEST(IsVideoName, ByItsExtension) {
    for (const char* name : {"a.mp4", "b/c.mov", "a.mkv", "a.b.avi"}) EXPECT_TRUE(is_video_name(name)) << name;
    for (const char* name : {"a.png", "mp4", "a.mp4.png", "out_%04d.png", ""})
        EXPECT_FALSE(is_video_name(name)) << name;
}

TEST(VideoFileTest, AppearsWhenItIsFinishedAndNotBefore) {
    const test::Folder folder;
    VideoFile video(folder / "v.mp4", 25.0, {32, 16});
    for (int i = 0; i < 5; ++i) video.add(picture());
    EXPECT_FALSE(fs::exists(folder / "v.mp4"));
    video.finish();
    EXPECT_THAT(files_in(folder), testing::ElementsAre("v.mp4"));
    cv::VideoCapture capture((folder / "v.mp4").string());
    int frames = 0;
    while (capture.grab()) ++frames;
    EXPECT_EQ(frames, 5);
    EXPECT_NEAR(capture.get(cv::CAP_PROP_FPS), 25.0, 0.01);
}

TEST(VideoFileTest, DroppedUnfinishedLeavesNothing) {
    const test::Folder folder;
    {
        VideoFile video(folder / "v.mp4", 25.0, {32, 16});
        video.add(picture());
    }
    EXPECT_THAT(files_in(folder), testing::IsEmpty());
}

TEST(VideoFileTest, WhereNoneCanBeWrittenItSaysSo) {
    const test::Folder folder;
    EXPECT_THAT(test::faults_of(
                    [&] {
                        VideoFile(folder / "no/v.mp4", 25.0, {32, 16});
                    },
                    Failure::runtime),
                testing::ElementsAre(testing::HasSubstr("its folder is missing")));
    EXPECT_THAT(test::faults_of(
                    [&] {
                        VideoFile(folder.path(), 25.0, {32, 16});
                    },
                    Failure::runtime),
                testing::ElementsAre(testing::HasSubstr("is not a plain file")));
}

TEST(VideoFileTest, OfWhatCannotBeEncodedItSaysWhichFigureIsAtFault) {
    const test::Folder folder;
    EXPECT_EQ(test::faults_of(
                  [&] {
                      VideoFile(folder / "v.mp4", 1e-4, {32, 16});
                  },
                  Failure::runtime),
              std::vector{(folder / "v.mp4").string() +
                          ": a video of 32x16 pixels and 0.0001 frames a second cannot be encoded here"});
    EXPECT_EQ(test::faults_of(
                  [&] {
                      VideoFile(folder / "v.mp4", 25.0, {33, 16});
                  },
                  Failure::runtime),
              std::vector{(folder / "v.mp4").string() +
                          ": a video of 33x16 pixels cannot be encoded here (the sides must be even)"});
}

}  // namespace
}  // namespace lapfx::output
