#include "match/blood.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

struct Found {
    explicit Found(const cv::Mat& frame, const cv::Mat& veil, const BloodQualifier& qualifier = {},
                   const cv::Mat& clear = test::tissue()) {
        cv::Mat redness;
        redness_of(clear, redness);
        finder.find(clear, redness, frame, veil, test::light_of({}),
                    cv::Mat(test::height, test::width, CV_8U, cv::Scalar(255)), qualifier);
    }
    BloodFinder finder;
    double blood() const { return cv::countNonZero(finder.blood()) / static_cast<double>(test::width * test::height); }
    double hidden() const {
        return cv::countNonZero(finder.hidden()) / static_cast<double>(test::width * test::height);
    }
};

constexpr int radius = 40;
constexpr double disc = 3.14159 * radius * radius / (test::width * test::height);

cv::Mat bloody() {
    cv::Mat frame = test::tissue();
    test::bleed(frame, {150, 130}, radius);
    return frame;
}

cv::Mat even(double veil) {
    return {test::height, test::width, CV_32F, cv::Scalar(veil)};
}

TEST(Blood, OfADiscHasItsArea) {
    EXPECT_NEAR(Found(bloody(), even(0)).blood(), disc, 0.05 * disc);
    EXPECT_EQ(Found(test::tissue(), even(0)).blood(), 0.0);
}

TEST(Blood, BehindSmokeHasTheSameArea) {
    for (const double veil : {0.2, 0.4, 0.6}) {
        // Behind dense smoke, what is darkest cannot be told from tissue.
        const double missing = veil > 0.5 ? 0.3 : 0.15;
        EXPECT_NEAR(Found(test::veiled(bloody(), even(veil), test::light_of({})), even(veil)).blood(), disc,
                    missing * disc)
            << veil;
    }
}

TEST(Blood, CannotBeReadBehindDenseSmoke) {
    const Found found(test::veiled(bloody(), even(0.9), test::light_of({})), even(0.9));
    EXPECT_EQ(found.blood(), 0.0);
    EXPECT_GT(found.hidden(), 0.99);
}

TEST(Blood, FollowsTheQualifier) {
    EXPECT_EQ(Found(bloody(), even(0), {.redness = 15}).blood(), 0.0);
    EXPECT_EQ(Found(bloody(), even(0), {.rise = 9}).blood(), 0.0);
    EXPECT_EQ(Found(bloody(), even(0), {.brightness = 0.05}).blood(), 0.0);
}

TEST(Blood, NeedsAPlaceThatIsSurelyBlood) {
    cv::Mat frame = test::tissue();
    test::bleed(frame, {100, 100}, 1);  // five pixels
    EXPECT_EQ(Found(frame, even(0)).blood(), 0.0);
}

/// Tissue with a red disc of its own, at `x`.
cv::Mat with_red_tissue(int x) {
    cv::Mat tissue = test::tissue();
    test::bleed(tissue, {x, 130}, radius);
    return tissue;
}

TEST(Blood, IsNotRedTissueThatMovedALittle) {
    EXPECT_EQ(Found(with_red_tissue(152), even(0), {}, with_red_tissue(150)).blood(), 0.0);
    EXPECT_GT(Found(with_red_tissue(170), even(0), {}, with_red_tissue(150)).blood(), 0.2 * disc);
}

TEST(Blood, IsSureInALargePartOfItsPatch) {
    // All that is left of the drop of green and blue is what makes it sure.
    const auto patch = [](int sure) {
        cv::Mat frame = test::tissue();
        const cv::Mat clear = frame.clone();
        test::bleed(frame, {150, 130}, radius);
        frame = 0.25 * frame + 0.75 * clear;
        if (sure > 0) test::bleed(frame, {150, 130}, sure);
        return Found(frame, even(0)).blood();
    };
    EXPECT_EQ(patch(0), 0.0);
    EXPECT_LT(patch(8), 0.1 * disc) << "a tenth of the patch";
    EXPECT_GT(patch(30), 0.5 * disc);
}

TEST(Blood, IsNotTissueWhoseVeilWasTakenForTooDense) {
    const cv::Mat smoky = test::veiled(test::tissue(), even(0.4), test::light_of({}));
    EXPECT_LT(Found(smoky, even(0.42)).blood(), 0.02);
}

}  // namespace
}  // namespace lapfx::match
