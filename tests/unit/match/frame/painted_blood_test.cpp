#include "match/frame/painted_blood.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lapfx/error.h"
#include "match/frame/estimator.h"
#include "match/frame/interval.h"
#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

constexpr int radius = 40;
constexpr double disc = 3.14159 * radius * radius / (test::width * test::height);

cv::Mat bloody(int seed, cv::Point middle, int of_radius = radius) {
    cv::Mat frame = test::tissue(seed);
    test::bleed(frame, middle, of_radius);
    return frame;
}

PicturePlace at(double x, double y) {
    return {x / test::width, y / test::height};
}

BloodStroke stroke(StrokeMark marks, std::vector<PicturePlace> points) {
    return {.time = 0.0, .marks = marks, .radius = 5.0 / test::width, .points = std::move(points)};
}

/// Over bloody(1, {150, 130}).
BloodStrokes strokes() {
    return {.file = "s.json",
            .without_blood = {},
            .strokes = {stroke(StrokeMark::blood, {at(130, 120), at(165, 140)}),
                        stroke(StrokeMark::blood, {at(150, 105)}), stroke(StrokeMark::other, {at(30, 30), at(120, 40)}),
                        stroke(StrokeMark::other, {at(250, 60), at(280, 220)}),
                        stroke(StrokeMark::other, {at(40, 220), at(150, 230)})}};
}

struct Learned {
    Image painted = test::image_of(bloody(1, {150, 130})), clear;
    PaintedBlood blood;
    Learned(const BloodStrokes& from, const cv::Mat& clear_frame, WithoutBlood without_blood, const LookedAt& part = {})
        : clear(test::image_of(clear_frame)), blood(from, pictures(from), {&clear, without_blood}, part) {}
    std::vector<PaintedPicture> pictures(const BloodStrokes& from) const {
        PaintedPicture made{.picture = painted, .strokes = {}};
        for (std::size_t i = 0; i < from.strokes.size(); ++i) made.strokes.push_back(i);
        return {made};
    }
};

cv::Mat code_at_working_size(const Image& image) {
    cv::Mat code;
    shrink(image, working_size_of(image), code);
    return code;
}

cv::Mat found_in(const PaintedBlood& blood, const cv::Mat& frame, const cv::Mat& clear = test::tissue()) {
    cv::Mat found;
    const cv::Mat haze = blood.haze_of(code_at_working_size(test::image_of(clear)));
    blood.find(code_at_working_size(test::image_of(frame)), haze, found);
    return found;
}

TEST(PaintedBlood, IsFoundWhereverItIsInAnyFrame) {
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    for (const auto& [seed, middle] :
         {std::pair{1, cv::Point(150, 130)}, {1, cv::Point(230, 90)}, {2, cv::Point(90, 120)}})
        EXPECT_NEAR(test::share(found_in(learned.blood, bloody(seed, middle))), disc, 0.12 * disc) << seed << middle;
    for (const int seed : {1, 2, 3}) EXPECT_LE(test::share(found_in(learned.blood, test::tissue(seed))), 0.005) << seed;
}

/// A plate that bleeds already, and what is drawn over it.
TEST(PaintedBlood, OfABaselineCountsBesideWhatIsNew) {
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    cv::Mat drawn = bloody(1, {150, 130});
    test::bleed(drawn, {230, 90}, 20);
    const auto measured = [&](std::shared_ptr<const PaintedBlood> held) {
        Estimator estimator(test::image_of(bloody(1, {150, 130})), {.held_blood = std::move(held)});
        const double before = estimator.measure(test::image_of(bloody(1, {150, 130})), 0.0).blood.value;
        return std::pair(before, estimator.measure(test::image_of(drawn), 0.04).blood.value);
    };
    const auto [none, fresh] = measured(nullptr);
    EXPECT_LT(none, 0.001) << "what is new alone";
    EXPECT_NEAR(fresh, disc / 4, 0.2 * disc / 4);
    const auto [held, all] = measured(std::make_shared<const PaintedBlood>(learned.blood));
    EXPECT_NEAR(held, disc, 0.12 * disc);
    EXPECT_NEAR(all - held, fresh, 0.1 * fresh) << "no pixel counts twice";
}

TEST(PaintedBlood, SaysHowMuchOfTheStrokesItFindsAgain) {
    EXPECT_EQ(Learned(strokes(), test::tissue(), WithoutBlood::yes).blood.found_again(), 1.0);
    BloodStrokes half = strokes();  // as much tissue again is marked as blood
    half.strokes.push_back(stroke(StrokeMark::blood, {at(60, 120), at(95, 140)}));
    half.strokes.push_back(stroke(StrokeMark::blood, {at(80, 180)}));
    EXPECT_NEAR(Learned(half, test::tissue(), WithoutBlood::yes).blood.found_again(), 0.5, 0.15);
}

TEST(PaintedBlood, IsTheSameEachTime) {
    const Learned one(strokes(), test::tissue(), WithoutBlood::yes), two(strokes(), test::tissue(), WithoutBlood::yes);
    const cv::Mat frame = bloody(2, {90, 120});
    EXPECT_EQ(cv::norm(found_in(one.blood, frame), found_in(two.blood, frame), cv::NORM_INF), 0.0);
    EXPECT_EQ(one.blood.threshold(), two.blood.threshold());
}

TEST(PaintedBlood, BehindSmokeIsFoundByTheHazeOfTheClearFrame) {
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    const cv::Mat veil(test::height, test::width, CV_32F, cv::Scalar(0.15));
    EXPECT_NEAR(test::share(found_in(learned.blood, test::veiled(bloody(1, {150, 130}), veil, test::light_of({})))),
                disc, 0.25 * disc);
}

TEST(PaintedBlood, SmallPiecesAreNoneAndSmallHolesBelongToIt) {
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    EXPECT_EQ(test::share(found_in(learned.blood, bloody(1, {150, 130}, 5))), 0.0);
    cv::Mat frame = bloody(1, {150, 130});
    const double whole = test::share(found_in(learned.blood, frame));
    cv::Mat hole = cv::Mat::zeros(frame.size(), CV_8U);
    cv::circle(hole, {150, 130}, 6, 255, cv::FILLED);
    test::tissue().copyTo(frame, hole);
    EXPECT_NEAR(test::share(found_in(learned.blood, frame)), whole, 0.03 * whole);
}

/// A person's mask may leave corners that are smaller than a hole in blood.
TEST(PaintedBlood, APartThatNoBloodTouchesIsNone) {
    const LookedAt corner{.masks = {{{0.05, 0}, {0.12, 0}, {0.12, 0.12}, {0.05, 0.12}},
                                    {{0, 0.06}, {0.12, 0.06}, {0.12, 0.12}, {0, 0.12}}}};
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes, corner);
    EXPECT_EQ(learned.blood.found_without(), 0.0);
    EXPECT_EQ(test::share(found_in(learned.blood, test::tissue())), 0.0);
}

/// Nothing is known of the haze where the clear frame is dark.
TEST(PaintedBlood, WhereTheClearFrameShowsNothingNoHazeIsRemoved) {
    cv::Mat cut_off = test::tissue();
    cut_off(cv::Rect(0, 0, 60, test::height)) = cv::Scalar::all(0);
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    cv::Mat found;
    learned.blood.find(code_at_working_size(test::image_of(test::tissue())),
                       learned.blood.haze_of(code_at_working_size(test::image_of(cut_off))), found);
    EXPECT_LE(test::share(found), 0.005);
}

/// Something like blood in a frame that has none: the more, the higher the threshold; where it is blood itself, or no
/// such frame is known, the highest.
TEST(PaintedBlood, TheThresholdIsTheLowestThatSparesAFrameWithoutBlood) {
    EXPECT_EQ(Learned(strokes(), test::tissue(), WithoutBlood::yes).blood.threshold(), 0.5);
    EXPECT_EQ(Learned(strokes(), test::tissue(), WithoutBlood::no).blood.threshold(), 0.9);
    const cv::Mat alike = bloody(1, {230, 90});
    std::vector<double> thresholds;
    for (const double share : {0.5, 0.8, 0.84, 0.88, 0.92, 0.96, 1.0}) {
        const cv::Mat frame = test::tissue() * (1.0 - share) + alike * share;
        thresholds.push_back(Learned(strokes(), frame, WithoutBlood::yes).blood.threshold());
    }
    EXPECT_TRUE(std::ranges::is_sorted(thresholds)) << testing::PrintToString(thresholds);
    EXPECT_EQ(thresholds.back(), 0.9);
    EXPECT_GT(Learned(strokes(), alike, WithoutBlood::yes).blood.found_without(), 4.0 * most_found_without)
        << "said to have none";
    EXPECT_LE(Learned(strokes(), test::tissue(), WithoutBlood::yes).blood.found_without(), most_found_without);
    EXPECT_TRUE(std::ranges::any_of(thresholds, [](double t) { return t > 0.5 && t < 0.9; }))
        << testing::PrintToString(thresholds);
}

TEST(PaintedBlood, AFrameThatMayHaveBloodIsLearnedFromOnlyIfItHasNone) {
    const Learned clear(strokes(), test::tissue(), WithoutBlood::maybe),
        bled(strokes(), bloody(1, {230, 90}), WithoutBlood::maybe);
    EXPECT_TRUE(clear.blood.without_blood());
    EXPECT_EQ(clear.blood.threshold(), 0.5);
    EXPECT_FALSE(bled.blood.without_blood());
    EXPECT_EQ(bled.blood.threshold(), 0.9);
    EXPECT_NEAR(test::share(found_in(bled.blood, bloody(2, {90, 120}))), disc, 0.15 * disc);
    BloodStrokes blood_alone = strokes();
    blood_alone.strokes.resize(2);
    try {
        const Learned learned(blood_alone, test::tissue(), WithoutBlood::maybe);
        FAIL() << "nothing says whether it has blood";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(),
                     "s.json: /strokes: no stroke marks what is no blood, and no frame without blood is known");
    }
}

std::string fault_of(const BloodStrokes& from, WithoutBlood without_blood, const LookedAt& part = {}) {
    try {
        const Learned learned(from, test::tissue(), without_blood, part);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return error.what();
    }
    return "no fault";
}

TEST(PaintedBlood, NeedsBothKinds) {
    BloodStrokes blood_alone = strokes(), other_alone = strokes();
    blood_alone.strokes.resize(2);
    other_alone.strokes.erase(other_alone.strokes.begin(), other_alone.strokes.begin() + 2);
    EXPECT_EQ(fault_of(other_alone, WithoutBlood::yes), "s.json: /strokes: no stroke marks blood");
    EXPECT_EQ(fault_of(blood_alone, WithoutBlood::no),
              "s.json: /strokes: no stroke marks what is no blood, and no frame without blood is known");
    EXPECT_EQ(fault_of(blood_alone, WithoutBlood::yes), "no fault");
    EXPECT_EQ(fault_of(strokes(), WithoutBlood::yes, {.masks = {{{0, 0}, {0.45, 0}, {0.45, 0.3}, {0, 0.3}}}}),
              "s.json: /strokes/2: lies outside of the view that is measured");
}

TEST(PaintedBlood, TellsTheEstimatorWhatIsThereAlready) {
    const cv::Mat before = bloody(1, {230, 90}), frame = [&] {
        cv::Mat both = before.clone();
        test::bleed(both, {150, 130}, radius);
        return both;
    }();
    const Learned learned(strokes(), test::tissue(), WithoutBlood::yes);
    const auto survey = std::make_shared<const Survey>();
    Estimator news(test::image_of(before), {.survey = survey});
    Estimator all(test::image_of(before),
                  {.survey = survey, .painted_blood = std::make_shared<const PaintedBlood>(learned.blood)});
    const FrameAmounts is_new = news.measure(test::image_of(frame), 0), is = all.measure(test::image_of(frame), 0);
    EXPECT_LT(is_new.blood.value, 1.2 * disc);
    EXPECT_NEAR(is.blood.value, 2.0 * disc, 0.25 * disc);
    EXPECT_NEAR(is.blood.low, 0.5 * is.blood.value - 0.005, 1e-12);
    EXPECT_NEAR(is.blood.high, 2.0 * is.blood.value + 0.005, 1e-12);
    EXPECT_EQ(is.veil.value, is_new.veil.value) << "the veil stays as it is";
    EXPECT_EQ(is.veil.high, is_new.veil.high);
    EXPECT_EQ(is.flags, is_new.flags);
    EXPECT_NEAR(test::share(all.blood() & all.valid()) / test::share(all.valid()), is.blood.value, 1e-9);
    const FrameAmounts black = all.measure(test::image_of(cv::Mat(frame.size(), CV_32FC3, cv::Scalar(0, 0, 0))), 0.04);
    EXPECT_FALSE(black.blood_measurable());
    EXPECT_EQ(black.blood.high, 1.0) << "nothing is known";
}

TEST(PaintedBlood, ItsIntervalIsFromHalfToTwice) {
    const auto of = [](double value) {
        Amount amount{.value = value, .low = -1, .high = -1};
        set_painted_interval(amount);
        return amount;
    };
    EXPECT_NEAR(of(0.1).low, 0.045, 1e-12);
    EXPECT_NEAR(of(0.1).high, 0.205, 1e-12);
    EXPECT_EQ(of(0.004).low, 0.0);
    EXPECT_NEAR(of(0.0).high, 0.005, 1e-12);
    EXPECT_EQ(of(0.6).high, 1.0);
}

}  // namespace
}  // namespace lapfx::match
