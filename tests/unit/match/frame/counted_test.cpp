#include "match/frame/counted.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

glm::ivec3 pixel(const Image& image, glm::ivec2 at) {
    const auto i =
        4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(at.x));
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

glm::ivec3 mixed(glm::ivec3 color, glm::vec3 with, float share) {
    return glm::ivec3(glm::round((1 - share) * glm::vec3(color) + share * with));
}

void expect_near(glm::ivec3 a, glm::ivec3 b, int most) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], most) << "channel " << c;
}

/// A disc of blood in the middle; the left quarter is left out.
class Counted : public ::testing::Test {
  protected:
    static constexpr glm::ivec2 in_blood{160, 130}, in_clear{280, 40}, left_out{20, 60};
    cv::Mat clear = test::tissue();
    Estimator estimator{
        test::image_of(clear),
        {.masks = {{{0, 0}, {0.25, 0}, {0.25, 1}, {0, 1}}}, .survey = std::make_shared<const Survey>()}};
    Image frame, drawn;
    FrameAmounts amounts;

    void measure(double veil) {
        cv::Mat bloody = clear.clone();
        test::bleed(bloody, {in_blood.x, in_blood.y}, 30);
        frame =
            test::image_of(test::veiled(bloody, cv::Mat(clear.size(), CV_32F, cv::Scalar(veil)), test::light_of({})));
        amounts = estimator.measure(frame, 0);
        drawn = frame;
    }
};

TEST_F(Counted, NothingIsDrawnOnAFrameThatTheFileCannotGive) {
    measure(0.3);
    draw_counted(drawn, estimator, {.flags = told::missing});
    EXPECT_EQ(drawn.pixels, frame.pixels);
}

TEST_F(Counted, BloodIsYellowAndTheRestStays) {
    measure(0.0);
    draw_counted(drawn, estimator, amounts);
    expect_near(pixel(drawn, in_blood), mixed(pixel(frame, in_blood), blood_color, blood_share), 4);
    expect_near(pixel(drawn, in_clear), pixel(frame, in_clear), 4);  // a trace of veil may be found
    EXPECT_EQ(drawn.pixels[3], 255);
}

TEST_F(Counted, VeilIsBlueByItsDensity) {
    measure(0.5);
    draw_counted(drawn, estimator, amounts);
    expect_near(pixel(drawn, in_clear), mixed(pixel(frame, in_clear), veil_color, 0.5F * veil_share), 12);
}

TEST_F(Counted, WhatIsLeftOutIsDarkAndHatched) {
    measure(0.0);
    draw_counted(drawn, estimator, amounts);
    expect_near(pixel(drawn, left_out + glm::ivec2(5, 0)),
                mixed(pixel(frame, left_out + glm::ivec2(5, 0)), {}, 1 - left_out_light), 1);
    const glm::vec3 between = left_out_light * glm::vec3(pixel(frame, left_out));
    expect_near(pixel(drawn, left_out), glm::ivec3(0.5F * between + 75.0F), 1);
}

TEST_F(Counted, EachLayerIsDrawnOnlyWhenAsked) {
    measure(0.3);
    draw_counted(drawn, estimator, amounts, {.blood = false, .veil = false, .left_out = false});
    EXPECT_EQ(drawn.pixels, frame.pixels);
    draw_counted(drawn, estimator, amounts, {.blood = true, .veil = false, .left_out = false});
    EXPECT_EQ(pixel(drawn, in_clear), pixel(frame, in_clear));
    measure(0.0);
    draw_counted(drawn, estimator, amounts, {.blood = true, .veil = false, .left_out = false});
    EXPECT_EQ(pixel(drawn, in_clear), pixel(frame, in_clear));
    EXPECT_NE(pixel(drawn, in_blood), pixel(frame, in_blood));
}

TEST_F(Counted, OfAFrameThatIsNotMeasurableOnlyWhatIsLeftOutIsDrawn) {
    measure(0.3);
    amounts.flags = told::not_measurable;
    draw_counted(drawn, estimator, amounts);
    EXPECT_EQ(pixel(drawn, in_blood), pixel(frame, in_blood));
    EXPECT_EQ(pixel(drawn, in_clear), pixel(frame, in_clear));
    EXPECT_NE(pixel(drawn, left_out), pixel(frame, left_out));
}

TEST_F(Counted, BehindADenseVeilNoBloodIsDrawn) {
    measure(0.0);
    amounts.flags = told::dense;
    draw_counted(drawn, estimator, amounts);
    expect_near(pixel(drawn, in_blood), pixel(frame, in_blood), 12);
}

TEST_F(Counted, FramesOfAnySizeAreDrawnOver) {
    cv::Mat large;
    cv::resize(clear, large, {}, 3, 3, cv::INTER_CUBIC);
    frame = test::image_of(cv::max(large, 0.0));
    amounts = estimator.measure(frame, 0);
    drawn = frame;
    draw_counted(drawn, estimator, amounts);
    expect_near(pixel(drawn, 3 * in_clear), pixel(frame, 3 * in_clear), 6);
    EXPECT_LT(pixel(drawn, 3 * left_out + glm::ivec2(5, 0)).r, pixel(frame, 3 * left_out + glm::ivec2(5, 0)).r);
}

}  // namespace
}  // namespace lapfx::match
