#include "match/frame/blood.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

const BloodFinder::Laid exactly{}, beside{.well = false, .likeness = 0.6}, far{.well = false, .likeness = 0.2};

struct Found {
    explicit Found(const cv::Mat& frame, const cv::Mat& veil, const BloodQualifier& qualifier = {},
                   const cv::Mat& clear = test::tissue(), const BloodFinder::Laid& laid = beside) {
        cv::Mat redness;
        redness_of(clear, redness);
        finder.find(clear, redness, frame, veil, test::light_of({}),
                    cv::Mat(test::height, test::width, CV_8U, cv::Scalar(255)), qualifier, laid);
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

/// A film of that thickness over the disc, by the law of Beer and Lambert.
cv::Mat filmed(double thickness, const cv::Mat& clear = test::tissue()) {
    cv::Mat frame = clear.clone(), part = cv::Mat::zeros(clear.size(), CV_8U);
    cv::circle(part, {150, 130}, radius, 255, cv::FILLED);
    const cv::Vec3d powers = cv::Vec3d(7.5, 8.0, 2.6) * thickness;
    frame.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int* at) {
        if (part.at<std::uint8_t>(at[0], at[1]) == 0) return;
        for (int k = 0; k < 3; ++k) p[k] *= static_cast<float>(std::exp2(-powers[k]));
    });
    return frame;
}

TEST(Blood, OfAThinFilmHasItsArea) {
    for (const double thickness : {0.15, 0.3, 0.6})
        EXPECT_NEAR(Found(filmed(thickness), even(0), {}, test::tissue(), exactly).blood(), disc, 0.06 * disc)
            << thickness;
    EXPECT_EQ(Found(test::tissue(), even(0), {}, test::tissue(), exactly).blood(), 0.0);
}

TEST(Blood, OfAFilmBehindSmokeHasItsArea) {
    for (const double veil : {0.2, 0.4}) {
        const auto behind = [veil](const cv::Mat& tissue) {
            return Found(test::veiled(tissue, even(veil), test::light_of({})), even(veil), {}, test::tissue(), exactly)
                .blood();
        };
        EXPECT_NEAR(behind(filmed(0.4)), disc, 0.1 * disc) << veil;
        EXPECT_EQ(behind(test::tissue()), 0.0) << veil;
    }
}

TEST(Blood, IsFoundThoughTheCameraGainedItsChannels) {
    cv::Mat frame = filmed(0.3);
    frame = frame.mul(cv::Scalar(0.9, 0.85, 1.1));
    EXPECT_NEAR(Found(frame, even(0), {}, test::tissue(), exactly).blood(), disc, 0.06 * disc);
    frame = test::tissue().mul(cv::Scalar(0.9, 0.85, 1.1));
    EXPECT_EQ(Found(frame, even(0), {}, test::tissue(), exactly).blood(), 0.0);
}

TEST(Blood, OfAFilmFollowsTheQualifier) {
    const auto found = [](const BloodQualifier& qualifier) {
        return Found(filmed(0.3), even(0), qualifier, test::tissue(), exactly).blood();
    };
    EXPECT_EQ(found({.redness = 15}), 0.0);
    EXPECT_EQ(found({.rise = 5}), 0.0);
    EXPECT_EQ(found({.brightness = 0.05}), 0.0);
}

/// As bright as the light makes it in the middle of a view: blood on it is brighter than most tissue.
cv::Mat bright_tissue() {
    cv::Mat tissue = test::tissue();
    return tissue.mul(cv::Scalar::all(0.9 / cv::mean(tissue)[2]));
}

TEST(Blood, OfAFilmOnBrightTissueHasItsArea) {
    const auto found = [](const cv::Mat& frame, const BloodQualifier& qualifier = {}) {
        return Found(frame, even(0), qualifier, bright_tissue(), exactly).blood();
    };
    EXPECT_NEAR(found(filmed(0.15, bright_tissue())), disc, 0.06 * disc);
    EXPECT_EQ(found(bright_tissue()), 0.0);
    EXPECT_EQ(found(filmed(0.15, bright_tissue()), {.brightness = 0.05}), 0.0);
}

TEST(Blood, IsNoFilmWhereAllIsDarker) {
    EXPECT_EQ(Found(0.6 * test::tissue(), even(0), {}, test::tissue(), exactly).blood(), 0.0);
}

/// The veil is known too badly there: one that is too dense would make all tissue redder, were it removed.
TEST(Blood, BehindSmokeIsMissedRatherThanInventedWhereTissueMoved) {
    const auto behind = [](const cv::Mat& tissue, double veil, double taken_for) {
        return Found(test::veiled(tissue, even(veil), test::light_of({})), even(taken_for)).blood();
    };
    EXPECT_NEAR(behind(bloody(), 0.02, 0.02), disc, 0.1 * disc);
    EXPECT_LT(behind(bloody(), 0.4, 0.4), 0.5 * disc);
    for (const double taken_for : {0.2, 0.4, 0.6}) EXPECT_EQ(behind(test::tissue(), 0.2, taken_for), 0.0) << taken_for;
}

/// What the smoke surely adds is removed there, too, up to where the tissue is as red as it was.
TEST(Blood, BehindThinSmokeIsFoundWhereTissueMoved) {
    for (const double veil : {0.1, 0.2, 0.3}) {
        const auto behind = [veil](const cv::Mat& tissue) {
            return Found(test::veiled(tissue, even(veil), test::light_of({})), even(veil)).blood();
        };
        EXPECT_NEAR(behind(bloody()), disc, 0.1 * disc) << veil;
        EXPECT_EQ(behind(test::tissue()), 0.0) << veil;
    }
}

TEST(Blood, OverMostOfTheViewIsFoundBehindSmokeWhereTissueMoved) {
    cv::Mat frame = test::tissue();
    test::bleed(frame, {test::width / 2, test::height / 2}, 125);
    const double much = Found(frame, even(0)).blood(),
                 behind = Found(test::veiled(frame, even(0.3), test::light_of({})), even(0.3)).blood();
    EXPECT_GT(much, 0.5);
    EXPECT_NEAR(behind, much, 0.1 * much);
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
    EXPECT_EQ(Found(with_red_tissue(158), even(0), {}, with_red_tissue(150)).blood(), 0.0);
    EXPECT_GT(Found(with_red_tissue(170), even(0), {}, with_red_tissue(150)).blood(), 0.2 * disc);
    EXPECT_EQ(Found(with_red_tissue(170), even(0), {}, with_red_tissue(150), far).blood(), 0.0)
        << "the less the baseline is alike, the farther red tissue may have come";
    EXPECT_GT(Found(bloody(), even(0), {}, test::tissue(), far).blood(), 0.9 * disc);
}

/// Less light makes no blood, though the little that comes back from a shadow seems redder.
TEST(Blood, IsNoShadowWhereTissueMoved) {
    cv::Mat shaded = test::tissue();
    cv::Mat part = cv::Mat::zeros(shaded.size(), CV_8U);
    cv::circle(part, {150, 130}, radius, 255, cv::FILLED);
    shaded.forEach<cv::Vec3f>([&](cv::Vec3f& p, const int* at) {
        if (part.at<std::uint8_t>(at[0], at[1]) != 0) p = p.mul(cv::Vec3f(0.005F, 0.005F, 0.04F));
    });
    EXPECT_EQ(Found(shaded, even(0)).blood(), 0.0);
}

/// Code values, all over.
cv::Mat even_color(int red, int green, int blue) {
    const auto light = [](int code) { return linear_of(static_cast<float>(code)); };
    return {test::height, test::width, CV_32FC3, cv::Scalar(light(blue), light(green), light(red))};
}

/// A disc of that colour on it.
cv::Mat with_disc(const cv::Mat& tissue, const cv::Mat& color) {
    cv::Mat frame = tissue.clone(), part = cv::Mat::zeros(tissue.size(), CV_8U);
    cv::circle(part, {150, 130}, radius, 255, cv::FILLED);
    color.copyTo(frame, part);
    return frame;
}

/// Colours of livers in real clips, lit and at the rim of the light.
TEST(Blood, IsNoShadedRimOfTheSameTissue) {
    struct Liver {
        cv::Mat lit, rim;
    };
    const Liver livers[] = {{even_color(173, 93, 93), even_color(65, 18, 21)},
                            {even_color(106, 36, 41), even_color(71, 13, 17)},
                            {even_color(103, 27, 33), even_color(75, 10, 15)}};
    for (const Liver& liver : livers)
        for (const BloodFinder::Laid& laid : {beside, far})
            EXPECT_EQ(Found(with_disc(liver.lit, liver.rim), even(0), {}, liver.lit, laid).blood(), 0.0);
}

TEST(Blood, IsFoundInTheShade) {
    // Real blood in the light and in half and a quarter of it, on a liver that is lit as the blood is.
    EXPECT_NEAR(
        Found(with_disc(even_color(173, 93, 93), even_color(145, 7, 10)), even(0), {}, even_color(173, 93, 93)).blood(),
        disc, 0.05 * disc);
    EXPECT_NEAR(
        Found(with_disc(even_color(125, 58, 61), even_color(106, 5, 7)), even(0), {}, even_color(125, 58, 61)).blood(),
        disc, 0.05 * disc);
    EXPECT_NEAR(
        Found(with_disc(even_color(65, 18, 21), even_color(75, 3, 4)), even(0), {}, even_color(65, 18, 21)).blood(),
        disc, 0.05 * disc);
}

/// A liver with a strip of that colour, 60 px wide, from the right edge of the view to its middle.
cv::Mat with_strip(const cv::Mat& color) {
    cv::Mat made = even_color(81, 39, 43);
    const cv::Rect strip(test::width / 2, 100, test::width / 2, 60);
    color(strip).copyTo(made(strip));
    return made;
}

TEST(Blood, IsNotWhatABlackShaftUncovers) {
    const cv::Mat clear = with_strip(even_color(40, 25, 24)), frame = even_color(81, 39, 43);
    for (const BloodFinder::Laid& laid : {exactly, beside})
        EXPECT_EQ(Found(frame, even(0), {}, clear, laid).blood(), 0.0) << laid.well;
}

TEST(Blood, IsFoundInADarkHollowOfTissue) {
    const cv::Mat clear = with_strip(even_color(45, 12, 14)), frame = with_strip(even_color(110, 5, 7));
    const double strip = 0.5 * 60 / test::height;
    EXPECT_NEAR(Found(frame, even(0), {}, clear).blood(), strip, 0.05 * strip);
}

TEST(Blood, IsSureInALargePartOfItsPatch) {
    // A quarter of the redness may be blood, the whole of it in the middle surely is.
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
