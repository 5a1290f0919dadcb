#include "match/frame/haze_light.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

TEST(HazeLight, FallsOffToTheRimOfTheView) {
    const HazeLight light{.color = {0.4, 0.3, 0.35}, .fall_off = 0.5};
    EXPECT_DOUBLE_EQ(light.at(0).r, 0.4);
    EXPECT_DOUBLE_EQ(light.at(1).g, 0.15);
    const cv::Mat over = light.over({101, 81}, {0, 0, 101, 81});
    EXPECT_NEAR(over.at<cv::Vec3f>(40, 50)[2], 0.4, 1e-3);
    EXPECT_NEAR(over.at<cv::Vec3f>(40, 50)[0], 0.35, 1e-3);  // blue comes first
    EXPECT_NEAR(over.at<cv::Vec3f>(40, 0)[1], 0.15, 0.01);
}

class SurveyedLight : public ::testing::TestWithParam<double> {};

TEST_P(SurveyedLight, IsFoundFromContrastNotFromBrightnessAlone) {
    const HazeLight truth{.color = glm::dvec3(1.0, 0.92, 1.05) * GetParam(), .fall_off = 0.25};
    const cv::Mat clear = test::tissue(), counts(test::height, test::width, CV_32F, cv::Scalar(1));
    HazeLightSurvey survey;
    survey.add(clear, test::veiled(clear, test::ramp(0.1, 0.7), test::light_of(truth)), counts, test::box());
    const HazeLight found = survey.found();
    EXPECT_NEAR(found.color.r / truth.color.r, 1.0, 0.05);
    EXPECT_NEAR(found.color.b / found.color.r, 1.05, 0.06);
    EXPECT_NEAR(found.fall_off, 0.25, 0.26);
}
INSTANTIATE_TEST_SUITE_P(Brightness, SurveyedLight, ::testing::Values(0.12, 0.17, 0.22, 0.25, 0.3, 0.4));

TEST(HazeLight, StaysAsAssumedWhereThereIsNoSmoke) {
    const cv::Mat clear = test::tissue(), counts(test::height, test::width, CV_32F, cv::Scalar(1));
    HazeLightSurvey survey;
    EXPECT_DOUBLE_EQ(survey.found().color.r, HazeLight{}.color.r);
    survey.add(clear, clear, counts, test::box());
    EXPECT_NEAR(survey.found().color.r / HazeLight{}.color.r, 1.0, 0.35);
}

}  // namespace
}  // namespace lapfx::match
