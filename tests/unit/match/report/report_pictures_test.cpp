// The pictures of a report: in the shape in which the reference is shown, and no more of them than are wanted.
#include "match/report/report_pictures.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "output/files.h"
#include "unit/preset/support.h"

namespace lapfx::match {
namespace {

Image grey(glm::ivec2 size, std::uint8_t value) {
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    image.pixels.assign(static_cast<std::size_t>(4 * size.x * size.y), value);
    return image;
}

cv::Mat opened(const std::string& jpeg) {
    return cv::imdecode(cv::Mat(1, static_cast<int>(jpeg.size()), CV_8U, const_cast<char*>(jpeg.data())),
                        cv::IMREAD_COLOR);
}

TEST(ReportPictures, HaveTheShapeInWhichTheReferenceIsShown) {
    EXPECT_EQ(report_picture_size({1920, 1080}), glm::ivec2(320, 180));
    EXPECT_EQ(report_picture_size({720, 576}, 16.0 / 9.0), glm::ivec2(320, 180)) << "widened";
    EXPECT_EQ(report_picture_size({720, 576}, 4.0 / 3.0), glm::ivec2(320, 240));
    EXPECT_EQ(report_picture_size({400, 800}), glm::ivec2(160, 320));
    EXPECT_EQ(report_picture_size({64, 32}), glm::ivec2(64, 32)) << "never larger than the frame";
    EXPECT_EQ(report_picture_size({0, 0}), glm::ivec2(1, 1));
}

class AddPictures : public testing::Test {
  protected:
    void SetUp() override {
        output::VideoFile file(video_, 10.0, {64, 48});
        for (int i = 0; i < 30; ++i) file.add(grey({64, 48}, static_cast<std::uint8_t>(8 * i)));
        file.finish();
        for (int i = 0; i < 20; ++i)
            report_.found.target.push_back({0.1 * i, Amount{.value = i == 12 ? 0.5 : 0.1}, Amount{.value = 0.01 * i}});
        report_.found.result.emplace();
        report_.found.fit.offset = 1.0;
        report_.found.result->tuned.scene.name = "after";
        report_.found.fit.start.scene.name = "before";
    }
    bool add(const DrawPicture& draw, const Progress& progress = {}) {
        VideoReader reader(video_);
        return add_pictures(report_, reader, 2.0, draw, progress);
    }

    test::Folder folder_;
    const std::filesystem::path video_ = folder_ / "video.mp4";
    FitReport report_;
};

TEST_F(AddPictures, OfTheReferenceAndOfBothScenesAtEachMoment) {
    std::vector<std::string> drawn;
    ASSERT_TRUE(add([&](const document::Content& tuned, double time, glm::ivec2 size) {
        drawn.push_back(tuned.scene.name);
        EXPECT_EQ(size, glm::ivec2(96, 48));
        return std::optional(grey(size, static_cast<std::uint8_t>(tuned.scene.name == "after" ? 100 * time : 20)));
    }));
    ASSERT_EQ(report_.moments.size(), 3U);
    EXPECT_EQ(drawn, (std::vector<std::string>{"before", "before", "before", "after", "after", "after"}));
    for (const ReportMoment& moment : report_.moments) {
        for (const std::string& jpeg : {moment.reference, moment.before, moment.after})
            EXPECT_EQ(opened(jpeg).size(), cv::Size(96, 48));
        EXPECT_NEAR(opened(moment.reference).at<cv::Vec3b>(24, 48)[1], 8 * (10 * moment.time + 10), 6) << moment.time;
        EXPECT_NEAR(opened(moment.before).at<cv::Vec3b>(24, 48)[1], 20, 2);
        EXPECT_NEAR(opened(moment.after).at<cv::Vec3b>(24, 48)[1], 100 * moment.time, 2);
    }
}

TEST_F(AddPictures, StopBeforeAnyOfThem) {
    const auto draw = [](const document::Content&, double, glm::ivec2 size) { return std::optional(grey(size, 0)); };
    for (int most = 0; most < 9; ++most) {
        int asked = 0;
        double last = -1.0;
        EXPECT_FALSE(add(draw, [&](double share) {
            EXPECT_GT(share, last);
            last = share;
            return asked++ < most;
        }));
        EXPECT_EQ(asked, most + 1);
    }
    int drawn = 0;
    EXPECT_FALSE(add([&](const document::Content&, double, glm::ivec2) {
        ++drawn;
        return std::optional<Image>();
    }));
    EXPECT_EQ(drawn, 1) << "no other is asked for";
}

TEST(SmallJpeg, IsNoLargerThanAnIndexNeeds) {
    const std::string jpeg = small_jpeg(grey({640, 320}, 90));
    EXPECT_EQ(opened(jpeg).size(), cv::Size(160, 80));
    EXPECT_EQ(opened(small_jpeg(small_jpeg(grey({100, 50}, 90)))).size(), cv::Size(100, 50));
    EXPECT_EQ(small_jpeg(std::string("no picture")), "");
}

}  // namespace
}  // namespace lapfx::match
