#include "bench/measure/by_strokes.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "match/picture/colors.h"
#include "unit/match/pictures.h"

namespace lapfx::bench {
namespace {

/// A disc of blood that grows from frame to frame; the first has none.
KnownView labelled(int frames) {
    namespace paint = match::test;
    KnownView view{.baseline = paint::image_of(paint::tissue()), .pictures = {}, .labels = {}, .labelled = true};
    for (int i = 0; i < frames; ++i) {
        cv::Mat frame = paint::tissue();
        Shown shown{.code = {}, .view = {}, .blood = cv::Mat::zeros(frame.size(), CV_8U), .veil = {}};
        if (i > 0) {
            paint::bleed(frame, {150, 130}, 20 + 4 * i);
            cv::circle(shown.blood, {150, 130}, 20 + 4 * i, 255, cv::FILLED);
        }
        shown.code = paint::code_picture(frame);
        shown.view = cv::Mat(frame.size(), CV_8U, cv::Scalar(255));
        shown.veil = cv::Mat::zeros(frame.size(), CV_32F);
        KnownPicture made = known(shown);
        made.picture = paint::image_of(frame);
        view.pictures.push_back(std::move(made));
    }
    return view;
}

std::vector<int> not_counted(const PaintedView& painted) {
    std::vector<int> which;
    for (std::size_t i = 0; i < painted.view.pictures.size(); ++i)
        if (!painted.view.pictures[i].counted) which.push_back(static_cast<int>(i));
    return which;
}

TEST(ByStrokes, TheSecondFrameWithBloodIsPaintedAndTheFrameBeforeLeads) {
    Random random(1, 1, 1), other(1, 1, 1);
    const PaintedView one = painted_view(labelled(6), random, 1), same = painted_view(labelled(6), other, 1);
    ASSERT_EQ(one.view.pictures.size(), 7U);
    EXPECT_EQ(one.view.pictures[0].blood, 0.0);
    EXPECT_EQ(one.view.pictures[0].picture.pixels, one.view.baseline.pixels);
    EXPECT_EQ(not_counted(one), std::vector<int>{3});
    EXPECT_EQ(not_counted(painted_view(labelled(6), random, 2)), (std::vector<int>{3, 5}));
    EXPECT_EQ(not_counted(painted_view(labelled(4), random, 2)), (std::vector<int>{3, 4}));
    EXPECT_FALSE(painted_view(labelled(3), random, 1).blood) << "two with blood: none would be left";
    ASSERT_TRUE(one.blood && same.blood);
    EXPECT_EQ(one.blood->threshold(), same.blood->threshold());
    cv::Mat code, found;
    match::shrink(one.view.pictures[6].picture, match::working_size_of(one.view.baseline), code);
    one.blood->find(code, {}, found);
    EXPECT_NEAR(match::test::share(found), one.view.pictures[6].blood, 0.15 * one.view.pictures[6].blood);
}

}  // namespace
}  // namespace lapfx::bench
