#include "match/picture/instruments.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "match/picture/view.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

/// A shaft from the left edge, 18 px wide, and its sides, as wide, in `side`.
cv::Mat shaft(const cv::Scalar& side) {
    cv::Mat picture = test::code_picture(test::tissue());
    cv::rectangle(picture, {0, 82}, {140, 117}, side, cv::FILLED);
    cv::rectangle(picture, {0, 91}, {140, 108}, {150, 152, 160}, cv::FILLED);
    return picture;
}

TEST(Instruments, FindsAGreyInstrumentAndNoTissue) {
    cv::Mat picture = test::code_picture(test::tissue());
    const cv::Mat view = view_of(picture);
    EXPECT_LT(test::share(instruments_of(picture, view)), 0.005);
    cv::line(picture, {0, 40}, {160, 120}, {150, 152, 149}, 18);
    const cv::Mat found = instruments_of(picture, view);
    EXPECT_EQ(found.at<std::uint8_t>(80, 80), 255);
    EXPECT_EQ(found.at<std::uint8_t>(200, 200), 0);
}

TEST(Instruments, FindsAnInstrumentBeforePaleTissueToo) {
    // Saturation 0.25, as of peritoneum near the lamp.
    const cv::Mat red = test::code_picture(test::tissue());
    cv::Mat grey, pale;
    cv::cvtColor(red, grey, cv::COLOR_BGR2GRAY);
    cv::merge(std::vector<cv::Mat>{0.78 * grey, 0.75 * grey, grey}, pale);
    const cv::Mat view = view_of(pale);
    EXPECT_LT(test::share(instruments_of(pale, view)), 0.01);
    cv::line(pale, {0, 40}, {160, 120}, {150, 152, 149}, 18);
    EXPECT_EQ(instruments_of(pale, view).at<std::uint8_t>(80, 80), 255);
}

TEST(Instruments, FindsABlackShaftThatShinesRed) {
    cv::Mat picture = test::code_picture(test::tissue());
    const cv::Mat view = view_of(picture);
    cv::line(picture, {0, 40}, {160, 120}, {54, 54, 67}, 18);
    EXPECT_EQ(instruments_of(picture, view).at<std::uint8_t>(80, 80), 255);
}

TEST(Instruments, TheSidesOfAShaftMirrorTissue) {
    cv::Mat picture = shaft({75, 82, 109});  // saturation .31, of tissue .51
    const cv::Mat view = view_of(picture), found = instruments_of(picture, view);
    for (const int y : {84, 100, 115}) EXPECT_EQ(found.at<std::uint8_t>(y, 70), 255) << y;
    EXPECT_EQ(found.at<std::uint8_t>(60, 70), 0);
    EXPECT_EQ(found.at<std::uint8_t>(140, 70), 0);
}

TEST(Instruments, OfWhatIsInTheMiddleOfTheViewNothingGrows) {
    cv::Mat picture = shaft({75, 82, 109});
    const cv::Mat tissue = test::code_picture(test::tissue());
    const cv::Rect left(0, 0, 40, picture.rows);
    tissue(left).copyTo(picture(left));
    const cv::Mat found = instruments_of(picture, view_of(picture));
    EXPECT_EQ(found.at<std::uint8_t>(100, 80), 255);
    EXPECT_EQ(found.at<std::uint8_t>(84, 80), 0) << "grey fat beside a highlight";
}

TEST(Instruments, ALargeGreyishAreaBesideAShaftIsTissue) {
    cv::Mat picture = shaft({75, 82, 109});
    cv::rectangle(picture, {0, 60}, {200, 140}, {75, 82, 109}, cv::FILLED);
    cv::rectangle(picture, {0, 91}, {140, 108}, {150, 152, 160}, cv::FILLED);
    const cv::Mat found = instruments_of(picture, view_of(picture));
    EXPECT_EQ(found.at<std::uint8_t>(100, 70), 255);
    EXPECT_EQ(found.at<std::uint8_t>(84, 70), 0);
}

TEST(Instruments, BluePlasticIsOne) {
    cv::Mat picture = test::code_picture(test::tissue());
    const cv::Mat view = view_of(picture);
    cv::circle(picture, {80, 80}, 12, {255, 160, 140}, cv::FILLED);  // saturation .45
    const cv::Mat found = instruments_of(picture, view);
    EXPECT_EQ(found.at<std::uint8_t>(80, 80), 255);
    EXPECT_NEAR(test::share(found) * static_cast<double>(found.total()), 3.14159 * 14 * 14, 60);
}

}  // namespace
}  // namespace lapfx::match
