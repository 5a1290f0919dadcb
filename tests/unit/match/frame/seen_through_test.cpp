#include "match/frame/seen_through.h"

#include <gtest/gtest.h>

#include "match/frame/smoke_tint.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

const cv::Rect patch(60, 50, 60, 40), inside(64, 54, 52, 32);  // inside: whose windows lie in the patch

/// The tissue with a patch that lets so much of it through and adds this light; blue, green, red.
cv::Mat with_patch(double transmission, const cv::Vec3f& light) {
    cv::Mat made = test::tissue();
    cv::Mat part = made(patch);
    part = part * transmission + cv::Scalar(light[0], light[1], light[2]);
    return made;
}

SeenThrough found_in(const cv::Mat& frame) {
    SeenThrough through;
    cv::Mat part = cv::Mat::zeros(frame.size(), CV_8U);
    part(patch) = 255;
    through.find(test::tissue(), frame, part);
    return through;
}

TEST(SeenThrough, IsSmokeWithTheVeilThatItIs) {
    for (const double transmission : {0.4, 0.6, 0.85}) {
        const SeenThrough through = found_in(with_patch(transmission, 0.12F * usual_smoke_tint));
        EXPECT_EQ(cv::countNonZero(through.smoke()(inside)), inside.area()) << transmission;
        EXPECT_NEAR(cv::mean(through.veil(), through.smoke())[0], 1.0 - transmission, 0.02);
        EXPECT_LE(cv::countNonZero(through.smoke()), patch.area()) << "only where it looks";
    }
}

TEST(SeenThrough, SmokeMayBeUneven) {
    cv::Mat frame = test::tissue();
    for (int y = patch.y; y < patch.br().y; ++y)
        for (int x = patch.x; x < patch.br().x; ++x) {
            const float light = (x / 3 + y / 4) % 2 == 0 ? 0.05F : 0.2F;
            frame.at<cv::Vec3f>(y, x) = 0.7F * frame.at<cv::Vec3f>(y, x) + light * usual_smoke_tint;
        }
    const SeenThrough through = found_in(frame);
    EXPECT_GT(cv::countNonZero(through.smoke()), 0.9 * patch.area());
    EXPECT_NEAR(cv::mean(through.veil()(inside), through.smoke()(inside))[0], 0.3, 0.02);
}

TEST(SeenThrough, IsNoInstrument) {
    const cv::Vec3f steel(0.3F, 0.3F, 0.3F), black(0.004F, 0.004F, 0.004F), yellow(0.1F, 0.25F, 0.3F);
    for (const cv::Vec3f& of : {steel, black, yellow})
        for (const double reflected : {0.0, 0.15, 0.25})
            EXPECT_EQ(cv::countNonZero(found_in(with_patch(reflected, of)).smoke()), 0) << of << ", " << reflected;
    EXPECT_EQ(cv::countNonZero(found_in(with_patch(0.5, yellow)).smoke()), 0) << "light of another tint";
}

TEST(SeenThrough, IsNotWhatOnlyChangedItsLight) {
    EXPECT_EQ(cv::countNonZero(found_in(with_patch(0.7, {})).smoke()), 0) << "a shadow adds no light";
    EXPECT_EQ(cv::countNonZero(found_in(with_patch(1.0, {0.1F, 0.1F, 0.1F})).smoke()), 0) << "glare hides nothing";
}

TEST(SeenThrough, KeepsNothingOfTheFrameBefore) {
    SeenThrough through = found_in(with_patch(0.6, 0.12F * usual_smoke_tint));
    EXPECT_GT(cv::countNonZero(through.smoke()), 0);
    through.find(test::tissue(), test::tissue(), cv::Mat::zeros(test::tissue().size(), CV_8U));
    EXPECT_EQ(cv::countNonZero(through.smoke()), 0);
}

}  // namespace
}  // namespace lapfx::match
