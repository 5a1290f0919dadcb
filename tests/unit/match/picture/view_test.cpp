#include "match/picture/view.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

cv::Mat disc_picture(int radius) {
    cv::Mat picture = test::code_picture(test::tissue()), disc = cv::Mat::zeros(picture.size(), CV_8U);
    cv::circle(disc, {test::width / 2, test::height / 2}, radius, 255, cv::FILLED);
    picture.setTo(0, ~disc);
    return picture;
}

TEST(MeasuredView, IsTheDiscWithoutItsSurround) {
    const int radius = 110;
    const cv::Mat view = view_of(disc_picture(radius));
    const double disc = 3.14159 * radius * radius / (test::width * test::height);
    EXPECT_NEAR(test::share(view), disc, 0.05 * disc);
    EXPECT_EQ(view.at<std::uint8_t>(5, 5), 0);
    EXPECT_EQ(view.at<std::uint8_t>(test::height / 2, test::width / 2), 255);
}

TEST(MeasuredView, LeavesOutTextInTheSurroundAndKeepsDarkHollows) {
    cv::Mat picture = disc_picture(110);
    cv::putText(picture, "23-11", {4, 14}, cv::FONT_HERSHEY_PLAIN, 0.8, {255, 255, 255});
    cv::circle(picture, {150, 120}, 20, cv::Scalar(4, 2, 6), cv::FILLED);
    const cv::Mat view = view_of(picture);
    EXPECT_EQ(cv::countNonZero(view(cv::Rect(0, 0, 50, 18))), 0);
    EXPECT_EQ(view.at<std::uint8_t>(120, 150), 255);
}

TEST(MeasuredView, IsAWholePictureWithoutSurroundAndNothingOfABlackOne) {
    EXPECT_GT(test::share(view_of(test::code_picture(test::tissue()))), 0.95);
    EXPECT_EQ(cv::countNonZero(view_of(cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(3)))), 0);
}

TEST(MeasuredView, RegionAndPartsAreFractionsOfThePicture) {
    const cv::Mat wanted = wanted_part({100, 80}, {0.1, 0.25, 0.5, 0.5},
                                       std::vector<MaskPolygon>{{{0.1, 0.25}, {0.3, 0.25}, {0.3, 0.5}, {0.1, 0.5}}});
    EXPECT_EQ(wanted.at<std::uint8_t>(10, 50), 0);  // above the region
    EXPECT_EQ(wanted.at<std::uint8_t>(50, 50), 255);
    EXPECT_EQ(wanted.at<std::uint8_t>(30, 20), 0);  // in the part
    EXPECT_NEAR(cv::countNonZero(wanted), 50 * 40 - 20 * 20, 60);
}

}  // namespace
}  // namespace lapfx::match
