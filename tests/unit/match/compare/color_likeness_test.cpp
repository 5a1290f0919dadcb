#include "match/compare/color_likeness.h"

#include <gtest/gtest.h>

#include "match/picture/color_difference.h"
#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

const cv::Vec3f painted_blood(0.01F, 0.008F, 0.22F);  // blue, green, red

Estimator measured(const cv::Mat& clear, const cv::Mat& picture, const HazeLight& light = {}) {
    auto survey = std::make_shared<Survey>();
    survey->light = light;
    Estimator estimator(test::image_of(clear), {.survey = std::move(survey)});
    estimator.measure(test::image_of(picture), 0);
    return estimator;
}

/// An even disc of blood.
cv::Mat with_blood(const cv::Mat& clear, int radius) {
    cv::Mat picture = clear.clone();
    cv::circle(picture, {150, 130}, radius, cv::Scalar(painted_blood), cv::FILLED);
    return picture;
}

void expect_near(const glm::dvec3& found, const glm::dvec3& wanted, double within) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], wanted[k], within) << "channel " << k;
}

TEST(ColorLikeness, BloodIsThatOfItsMaskWithoutTheVeil) {
    const cv::Mat clear = test::tissue(), bloody = with_blood(clear, 40);
    for (const double veil : {0.0, 0.2}) {
        const cv::Mat picture = test::smoky(bloody, veil);
        const MeasuredColors found = colors_of(test::image_of(picture), measured(clear, picture));
        ASSERT_TRUE(found.blood) << veil;
        expect_near(*found.blood, {painted_blood[2], painted_blood[1], painted_blood[0]}, 0.02);
    }
}

/// Nor what is taken away from a shadow beyond the light that it has.
TEST(ColorLikeness, AFifthThatIsNoBloodDoesNotCount) {
    const cv::Size size(60, 40);
    cv::Mat light(size, CV_32FC3, cv::Scalar(painted_blood));
    light.rowRange(0, 8).setTo(cv::Scalar(0.004, 0.004, 0.02));
    const cv::Mat veil(size, CV_32F, cv::Scalar(0.1)), smoke(size, CV_32FC3, cv::Scalar::all(0.3));
    const ColorLayers layers{.blood = cv::Mat(size, CV_8U, cv::Scalar(255)),
                             .veil = veil,
                             .valid = cv::Mat(size, CV_8U, cv::Scalar(255)),
                             .light = smoke,
                             .baseline = cv::Mat(size, CV_8UC3, cv::Scalar(40, 50, 110))};
    const cv::Mat shown = 0.9 * light + cv::Scalar::all(0.1 * 0.3), shadow = 0.9 * light;
    cv::Mat picture = shown.clone();
    shadow.rowRange(0, 8).copyTo(picture.rowRange(0, 8));
    const MeasuredColors found = colors_of(test::image_of(picture), layers);
    ASSERT_TRUE(found.blood);
    expect_near(*found.blood, {painted_blood[2], painted_blood[1], painted_blood[0]}, 0.01);
}

TEST(ColorLikeness, TissueIsTheMeanOfTheBaseline) {
    const cv::Mat clear = test::tissue(), bloody = with_blood(clear, 40);
    const MeasuredColors found = colors_of(test::image_of(bloody), measured(clear, bloody));
    const cv::Scalar mean = cv::mean(clear);
    ASSERT_TRUE(found.tissue);
    expect_near(*found.tissue, {mean[2], mean[1], mean[0]}, 0.01);
}

TEST(ColorLikeness, SmokeIsTheLightWhereTheVeilIs) {
    const HazeLight light{.color = {0.40, 0.37, 0.42}, .fall_off = 0.0};
    const cv::Mat clear = test::tissue();
    const cv::Mat picture = test::veiled(clear, test::ramp(0.3, 0.6), test::light_of(light));
    const MeasuredColors found = colors_of(test::image_of(picture), measured(clear, picture, light));
    ASSERT_TRUE(found.smoke);
    EXPECT_TRUE(found.tinted);
    expect_near(*found.smoke, light.color, 0.04);  // the veil is measured no better
}

TEST(ColorLikeness, SmokeIsWhatTheVeilPutBeforeTheTissueWhateverLightWasAssumed) {
    const HazeLight light{.color = {0.20, 0.25, 0.30}, .fall_off = 0.0};
    const cv::Mat clear = test::tissue(), veil = test::ramp(0.05, 0.4);
    cv::Mat picture = test::veiled(with_blood(clear, 40), veil, test::light_of(light));
    cv::Mat blood(clear.size(), CV_8U, cv::Scalar(0));
    cv::circle(blood, {150, 130}, 42, 255, cv::FILLED);
    const cv::Rect highlight(20, 20, 60, 60);  // says nothing
    picture(highlight).setTo(1.0);
    const MeasuredColors found = colors_of(
        test::image_of(picture), ColorLayers{blood, veil, cv::Mat(clear.size(), CV_8U, cv::Scalar(255)),
                                             test::light_of({.color = {0.6, 0.1, 0.9}}), test::code_picture(clear)});
    ASSERT_TRUE(found.smoke);
    expect_near(*found.smoke, light.color, 0.005);
}

TEST(ColorLikeness, OfTooFewPixelsIsNone) {
    const cv::Mat clear = test::tissue(), bloody = with_blood(clear, 40);
    const MeasuredColors clean = colors_of(test::image_of(clear), measured(clear, clear));
    EXPECT_FALSE(clean.blood);
    EXPECT_FALSE(clean.smoke);
    EXPECT_TRUE(clean.tissue);
    const MeasuredColors with = colors_of(test::image_of(bloody), measured(clear, bloody));
    EXPECT_FALSE(likeness_of(clean, with).blood);
    EXPECT_FALSE(likeness_of(with, clean).blood);
    EXPECT_EQ(likeness_of(clean, with).tissue, 0.0);
}

TEST(ColorLikeness, OfAFewPixelsOfBloodIsNone) {
    const cv::Mat clear = test::tissue(), bloody = with_blood(clear, 5);
    const Estimator estimator = measured(clear, bloody);
    ASSERT_GT(cv::countNonZero(estimator.blood()), 0);
    ASSERT_LT(cv::countNonZero(estimator.blood()), least_pixels);
    EXPECT_FALSE(colors_of(test::image_of(bloody), estimator).blood);
}

TEST(ColorLikeness, BloodBehindDenseSmokeDoesNotCount) {
    const cv::Mat clear = test::tissue(), blood = with_blood(clear, 40), light = test::light_of({});
    cv::Mat mask(clear.size(), CV_8U, cv::Scalar(0)), everywhere(clear.size(), CV_8U, cv::Scalar(255));
    cv::circle(mask, {150, 130}, 40, cv::Scalar(255), cv::FILLED);
    cv::Mat veil = test::ramp(0.0, 0.3);
    ColorLayers layers{mask, veil, everywhere, light, test::code_picture(clear)};
    // The picture is as the layers say, but where the smoke is dense: there it is white.
    cv::Mat picture = test::veiled(blood, veil, light);
    const cv::Rect dense(150, 0, test::width - 150, test::height);
    picture(dense).setTo(1.0);
    veil(dense).setTo(dense_veil + 0.01);
    const MeasuredColors found = colors_of(test::image_of(picture), layers);
    ASSERT_TRUE(found.blood);
    expect_near(*found.blood, {painted_blood[2], painted_blood[1], painted_blood[0]}, 0.002);
    veil.setTo(dense_veil + 0.01);
    EXPECT_FALSE(colors_of(test::image_of(picture), layers).blood);
}

TEST(ColorLikeness, ColorsAreOfAsManyPixelsAsAreAsked) {
    const cv::Mat clear = test::tissue(), none(clear.size(), CV_32F, cv::Scalar(0.0));
    ColorLayers layers{cv::Mat(clear.size(), CV_8U, cv::Scalar(0)), none.clone(),
                       cv::Mat(clear.size(), CV_8U, cv::Scalar(255)), test::light_of({}), test::code_picture(clear)};
    const auto found = [&] { return colors_of(test::image_of(clear), layers); };
    EXPECT_FALSE(found().smoke);
    layers.blood.row(0).colRange(0, least_pixels - 1).setTo(255);
    layers.veil.row(1).colRange(0, least_pixels - 1).setTo(colored_veil + 0.01);
    EXPECT_FALSE(found().blood);
    EXPECT_FALSE(found().smoke);
    layers.blood.row(0).colRange(0, least_pixels).setTo(255);
    layers.veil.row(1).colRange(0, least_pixels).setTo(colored_veil + 0.01);
    EXPECT_TRUE(found().blood);
    EXPECT_TRUE(found().smoke);
}

TEST(ColorLikeness, OnlyTheValidViewCounts) {
    const cv::Mat clear = test::tissue();
    auto survey = std::make_shared<Survey>();
    Estimator estimator(test::image_of(clear), {.region = {0, 0, 0.5, 1}, .survey = std::move(survey)});
    estimator.measure(test::image_of(clear), 0);
    cv::Mat code, linear;
    shrink(test::image_of(clear), estimator.working_size(), code);
    to_linear(code, linear);
    const double mean = cv::mean(linear, estimator.valid())[2];
    ASSERT_GT(std::abs(mean - cv::mean(linear)[2]), 0.003);
    EXPECT_NEAR(colors_of(test::image_of(clear), estimator).tissue->r, mean, 0.001);
}

TEST(ColorLikeness, IsTheDifferenceOfTheLightAsSeen) {
    const MeasuredColors a{.blood = glm::dvec3(0.2, 0.01, 0.01), .smoke = glm::dvec3(0.3), .tissue = {}};
    const MeasuredColors b{.blood = glm::dvec3(0.2, 0.01, 0.01), .smoke = glm::dvec3(0.2), .tissue = glm::dvec3(0.5)};
    const ColorLikeness found = likeness_of(a, b);
    EXPECT_EQ(found.blood, 0.0);
    EXPECT_FALSE(found.tissue);
    // Greys differ by their lightness alone: 116 times the cube root of the light.
    const double dark = 116.0 * std::cbrt(0.2) - 16.0, light = 116.0 * std::cbrt(0.3) - 16.0;
    EXPECT_NEAR(*found.smoke, delta_e_2000({dark, 0, 0}, {light, 0, 0}), 1e-2);
    MeasuredColors red = b, tinted = a;
    red.smoke = glm::dvec3(0.3) / light_of({0.4, 0.2, 0.2}) * glm::dvec3(0.4, 0.2, 0.2);
    EXPECT_NEAR(*likeness_of(a, red).smoke, 0.0, 1e-2) << "as bright, and no tint is told";
    red.tinted = tinted.tinted = true;
    EXPECT_GT(*likeness_of(tinted, red).smoke, 10.0);
}

}  // namespace
}  // namespace lapfx::match
