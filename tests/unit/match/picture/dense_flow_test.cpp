#include "match/picture/dense_flow.h"

#include <gtest/gtest.h>

#include "match/picture/placement.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

constexpr double pi = 3.14159;

cv::Mat texture_of_tissue(const cv::Mat& tissue) {
    cv::Mat texture;
    texture_of(test::code_picture(tissue), texture);
    return texture;
}

/// Tissue that bends: its columns go up and down by some pixels.
cv::Mat bent(const cv::Mat& tissue, double by) {
    cv::Mat map(test::height, test::width, CV_32FC2), made;
    for (int y = 0; y < test::height; ++y)
        for (int x = 0; x < test::width; ++x)
            map.at<cv::Vec2f>(y, x) =
                cv::Vec2f(static_cast<float>(x), static_cast<float>(y + by * std::sin(2.0 * pi * x / test::width)));
    cv::remap(tissue, made, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return made;
}

const cv::Mat& all() {
    static const cv::Mat whole(test::height, test::width, CV_8U, cv::Scalar(255));
    return whole;
}

TEST(DenseFlow, SeesTissueThatBent) {
    const cv::Mat before = texture_of_tissue(test::tissue()), now = texture_of_tissue(bent(test::tissue(), 4.0));
    const double as_it_lies = likeness_of(before, now, all());
    EXPECT_LT(as_it_lies, 0.5);
    DenseFlow flow;
    EXPECT_TRUE(flow.find(before, all(), now, as_it_lies));
    EXPECT_GT(flow.likeness(), 0.8);
}

TEST(DenseFlow, MakesOtherTissueNotAlike) {
    const cv::Mat before = texture_of_tissue(test::tissue(1)), now = texture_of_tissue(test::tissue(2));
    DenseFlow flow;
    const double as_it_lies = likeness_of(before, now, all());
    flow.find(before, all(), now, as_it_lies);
    EXPECT_LT(flow.likeness(), 0.5);
}

TEST(DenseFlow, KeepsTheLikenessWhereThereIsNothingToGain) {
    const cv::Mat texture = texture_of_tissue(test::tissue());
    DenseFlow flow;
    EXPECT_FALSE(flow.find(texture, all(), texture, 1.0));
    EXPECT_EQ(flow.likeness(), 1.0);
}

}  // namespace
}  // namespace lapfx::match
