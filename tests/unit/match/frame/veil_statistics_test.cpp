#include "match/frame/veil_statistics.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

const cv::Vec3d smoke_light(0.36, 0.36, 0.36);  // grey: it has no chroma of its own

cv::Mat everywhere() {
    return {test::height, test::width, CV_8U, cv::Scalar(255)};
}

/// The tissue, without hollows that 8 bits cannot tell from black.
cv::Mat clear_picture() {
    return test::tissue() + cv::Scalar(0.02, 0.02, 0.02);
}

cv::Mat evenly_veiled(const cv::Mat& clear, double veil, double gain = 1.0) {
    return gain * (clear * (1.0 - veil) + cv::Scalar(smoke_light * veil));
}

VeilStatistics told_by(const cv::Mat& clear, const cv::Mat& veiled) {
    AppearanceFinder finder;
    const Appearance before = finder.find(test::code_picture(clear), everywhere());
    return statistics_of(before, finder.find(test::code_picture(veiled), everywhere()), smoke_light);
}

enum { by_offset, by_slope, dark, low, saturation, chroma, detail, spread };

TEST(VeilStatistics, EachTellsAnEvenVeil) {
    const cv::Mat clear = clear_picture();
    for (const double veil : {0.0, 0.1, 0.3, 0.6}) {
        const VeilStatistics told = told_by(clear, evenly_veiled(clear, veil));
        for (const int which : {by_offset, by_slope, dark, low, chroma, detail, spread})
            EXPECT_NEAR(told[static_cast<std::size_t>(which)], veil, 0.015) << which << ' ' << veil;
        // Saturation is no straight line of the veil.
        EXPECT_GE(told[saturation], veil - 0.01);
    }
}

TEST(VeilStatistics, AChangeOfExposureIsNoVeilByTheOffset) {
    const cv::Mat clear = clear_picture();
    for (const double gain : {0.8, 1.2}) {
        const VeilStatistics told = told_by(clear, evenly_veiled(clear, 0.3, gain));
        EXPECT_NEAR(told[by_offset], 0.3, 0.02) << gain;
        EXPECT_NEAR(told[by_slope], 1.0 - 0.7 * gain, 0.02) << gain;
    }
}

TEST(VeilStatistics, OnlyThePartCounts) {
    const cv::Mat clear = clear_picture();
    cv::Mat veiled = evenly_veiled(clear, 0.2), part = everywhere();
    veiled(cv::Rect(0, 0, test::width / 3, test::height)).setTo(cv::Scalar(1, 1, 1));
    part(cv::Rect(0, 0, test::width / 3 + 3, test::height)) = 0;  // detail looks a little around
    AppearanceFinder finder;
    const Appearance before = finder.find(test::code_picture(clear), part);
    const VeilStatistics told = statistics_of(before, finder.find(test::code_picture(veiled), part), smoke_light);
    for (const int which : {by_offset, by_slope, dark, low, detail, spread})
        EXPECT_NEAR(told[static_cast<std::size_t>(which)], 0.2, 0.015) << which;
}

TEST(VeilStatistics, APictureThatMovedTellsTheSame) {
    const cv::Mat clear = clear_picture(), veiled = evenly_veiled(clear, 0.3);
    cv::Mat moved;
    cv::flip(veiled, moved, 1);
    const VeilStatistics still = told_by(clear, veiled), other = told_by(clear, moved);
    for (std::size_t i = 0; i < still.size(); ++i) EXPECT_NEAR(still[i], other[i], 0.003) << i;
}

TEST(VeilStatistics, OfNothingAreHeldWithinTheirRange) {
    AppearanceFinder finder;
    const cv::Mat clear = test::code_picture(clear_picture());
    const Appearance nothing = finder.find(clear, cv::Mat::zeros(clear.size(), CV_8U)),
                     all = finder.find(clear, everywhere());
    for (const Appearance& from : {nothing, all})
        for (const Appearance& to : {nothing, all})
            for (const double told : statistics_of(from, to, {0, 0, 0})) {
                EXPECT_GE(told, -0.6);
                EXPECT_LE(told, 1.1);
            }
}

}  // namespace
}  // namespace lapfx::match
