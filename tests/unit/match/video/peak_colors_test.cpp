#include "match/video/peak_colors.h"

#include <gtest/gtest.h>

#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

/// Gives painted pictures as a video that is measured gives its frames.
class PeakColorsTest : public ::testing::Test {
  protected:
    const cv::Mat clear = test::tissue();

    static cv::Mat with_blood(const cv::Mat& tissue, int radius, const cv::Vec3f& color) {
        cv::Mat picture = tissue.clone();
        cv::circle(picture, {150, 130}, radius, cv::Scalar(color), cv::FILLED);
        return picture;
    }
    void add(PeakColors& colors, const cv::Mat& picture, double time) {
        Image frame = test::image_of(picture);
        const FrameAmounts amounts = estimator_.measure(frame, time);
        colors.add(frame, &estimator_, amounts);
    }

    Estimator& estimator() { return estimator_; }

  private:
    static Estimator made(const cv::Mat& baseline) {
        auto survey = std::make_shared<Survey>();
        return Estimator(test::image_of(baseline), {.survey = std::move(survey)});
    }
    Estimator estimator_ = made(clear);
};

const cv::Vec3f dark_blood(0.01F, 0.008F, 0.15F), light_blood(0.02F, 0.02F, 0.30F);  // blue, green, red

TEST_F(PeakColorsTest, BloodIsThatOfAllFramesByHowMuchTheyShow) {
    PeakColors colors(0.0, 10.0);
    add(colors, with_blood(clear, 25, dark_blood), 0.0);
    add(colors, with_blood(clear, 45, light_blood), 1.0);
    add(colors, with_blood(clear, 25, dark_blood), 2.0);
    ASSERT_TRUE(colors.found().blood);
    const double dark = 2.0 * 25.0 * 25.0, light = 45.0 * 45.0;
    EXPECT_NEAR(colors.found().blood->r, (dark * dark_blood[2] + light * light_blood[2]) / (dark + light), 0.02);
    const double share = 3.14159 * 45.0 * 45.0 / static_cast<double>(clear.total());
    EXPECT_NEAR(colors.at_peak().blood.value, share, 0.2 * share);
    ASSERT_TRUE(colors.found().tissue);
    const cv::Scalar mean = cv::mean(clear);
    EXPECT_NEAR(colors.found().tissue->r, mean[2], 0.01);
}

TEST_F(PeakColorsTest, SmokeIsThatOfTheDensestVeilAndBloodStaysThatOfAnotherFrame) {
    PeakColors colors(0.0, 10.0);
    add(colors, with_blood(clear, 45, light_blood), 0.0);
    const std::optional<glm::dvec3> blood = colors.found().blood;
    EXPECT_FALSE(colors.found().smoke) << "there is none";
    add(colors, test::smoky(clear, 0.3), 1.0);
    EXPECT_TRUE(colors.found().smoke);
    EXPECT_EQ(colors.found().blood, blood);
}

TEST_F(PeakColorsTest, BloodBehindLittleSmokeIsWorthMore) {
    PeakColors colors(0.0, 10.0);
    add(colors, with_blood(clear, 40, dark_blood), 0.0);
    add(colors, test::smoky(with_blood(clear, 45, light_blood), 0.3), 1.0);
    ASSERT_TRUE(colors.found().blood);
    EXPECT_NEAR(colors.found().blood->r, dark_blood[2], 0.03);
    EXPECT_TRUE(colors.found().smoke);
}

TEST_F(PeakColorsTest, FramesOutsideTheTimesDoNotCount) {
    PeakColors colors(1.0, 2.0);
    add(colors, with_blood(clear, 45, dark_blood), 0.9);
    add(colors, with_blood(clear, 45, dark_blood), 2.1);
    EXPECT_FALSE(colors.found().blood);
    EXPECT_FALSE(colors.found().tissue);
    add(colors, with_blood(clear, 30, light_blood), 1.0);
    ASSERT_TRUE(colors.found().blood);
    EXPECT_NEAR(colors.found().blood->r, light_blood[2], 0.03);
}

TEST_F(PeakColorsTest, AnyPartOfAVideoIsAskedForAfterwards) {
    struct Shown {
        double time;
        cv::Mat picture;
    };
    const std::vector<Shown> video = {{0.0, clear},
                                      {0.9, with_blood(clear, 30, dark_blood)},
                                      {1.5, with_blood(clear, 45, light_blood)},
                                      {2.1, test::smoky(clear, 0.25)},
                                      {2.9, with_blood(clear, 35, dark_blood)},
                                      {3.5, test::smoky(clear, 0.4)}};
    ColorsOverTime all;
    for (const Shown& shown : video) {
        Image frame = test::image_of(shown.picture);
        const FrameAmounts amounts = estimator().measure(frame, shown.time);
        all.add(frame, &estimator(), amounts);
    }
    for (const auto& [from, to] :
         {std::pair{0.0, 4.0}, std::pair{0.5, 1.0}, std::pair{1.6, 3.0}, std::pair{2.0, 3.4}, std::pair{2.5, 3.5}}) {
        PeakColors part(from, to);
        estimator().forget();
        for (const Shown& shown : video) add(part, shown.picture, shown.time);
        const ColorsAtPeak found = all.at_peak(from, to), wanted = part.at_peak();
        EXPECT_EQ(found.colors.blood, wanted.colors.blood) << from << ' ' << to;
        EXPECT_EQ(found.colors.smoke, wanted.colors.smoke) << from << ' ' << to;
        EXPECT_EQ(found.colors.tissue, wanted.colors.tissue) << from << ' ' << to;
        EXPECT_EQ(found.colors.tinted, wanted.colors.tinted);
        EXPECT_EQ(found.blood.value, wanted.blood.value);
        EXPECT_EQ(found.veil.value, wanted.veil.value);
    }
    EXPECT_FALSE(all.at_peak(5.0, 6.0).colors.tissue);
}

TEST_F(PeakColorsTest, FramesThatAreNotMeasurableDoNotCount) {
    PeakColors colors(0.0, 10.0);
    const Image frame = test::image_of(clear);
    colors.add(frame, nullptr, {.time = 1.0, .flags = told::no_baseline});
    add(colors, clear * 0.0, 2.0);
    EXPECT_FALSE(colors.found().tissue);
}

}  // namespace
}  // namespace lapfx::match
