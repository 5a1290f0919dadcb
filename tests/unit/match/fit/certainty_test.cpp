// How certain a fit is, where it can be worked out by hand: curves that are straight lines of one parameter.
#include "match/fit/certainty.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lapfx::match {
namespace {

constexpr std::size_t times = 13;  // one a second: each is a block of its own
constexpr double slope = 0.05, deviates = 1.645;

std::vector<TargetPoint> target_with(double hidden) {
    std::vector<TargetPoint> target;
    for (std::size_t i = 0; i < times; ++i)
        target.push_back(
            {.time = static_cast<double>(i), .blood = Amount{0.2, 0.1, 0.3}, .veil = {}, .hidden_blood = hidden});
    return target;
}

/// Blood that grows by `slope` for each unit of the one parameter, and is `off` above the aim, now and then below it.
Linearised line(const Objective& objective, double off) {
    constexpr std::size_t columns = 2;
    Linearised at{.residuals = std::vector<double>(objective.size()),
                  .slopes = std::vector<double>(objective.size() * columns),
                  .columns = columns,
                  .fitted = 1};
    const double error = 0.006;  // blood_course.most
    for (std::size_t i = 0; i < times; ++i) {
        at.residuals[i] = (i % 2 == 0 ? off : -off) / error;
        at.slopes[i * columns + 1] = slope / error;
    }
    at.slopes[objective.amounts() * columns + 1] = 1.0 / Objective::prior;
    at.slopes[(objective.amounts() + 1) * columns] = 1.0 / Objective::offset_error;
    return at;
}

Certainty certainty_with(double hidden, double off, Errors errors) {
    const Objective objective(target_with(hidden), {}, {0.0});
    return certainty_of(objective, line(objective, off), std::vector{0.0}, errors, 1).front();
}
/// The slopes are all alike, so the scale's error is what the parameter needs to make up for it.
const double of_scale = blood_course.scale_error * 0.2 / slope;  // 0.6
/// 13 blocks and one unknown make reduced chi-squared 13 / 12 where the curve is as far off as stated.
const double of_course = 0.006 * std::sqrt(13.0 / 12.0) / (slope * std::sqrt(13.0));

/// Both, where the prior of the parameter counts, too.
double with_scale(double alone) {
    const double of_prior = alone / Objective::prior, part = 1.0 / (1.0 + of_prior * of_prior);
    return std::hypot(alone * std::sqrt(part), of_scale * part);
}

TEST(Certainty, IsThatOfLeastSquares) {
    EXPECT_NEAR(certainty_with(0.0, 0.006, Errors::of_course).error, of_course, 0.002 * of_course);
    EXPECT_NEAR(certainty_with(0.03, 0.006, Errors::of_course).error, of_course, 0.002 * of_course)
        << "what a search goes by";
    EXPECT_NEAR(certainty_with(0.0, 0.009, Errors::of_course).error, 1.5 * of_course, 0.003 * of_course)
        << "what is left says that errors are half as large again";
    EXPECT_NEAR(certainty_with(0.0, 0.0006, Errors::of_course).error, 0.35 * of_course / std::sqrt(13.0 / 12.0),
                0.002 * of_course)
        << "but not that they are none";
}

TEST(Certainty, OfTheScaleIsAdded) {
    for (const Errors errors : {Errors::with_scales, Errors::with_hidden})
        EXPECT_NEAR(certainty_with(0.0, 0.009, errors).error, with_scale(1.5 * of_course), 2e-4);
    EXPECT_NEAR(certainty_with(0.03, 0.009, Errors::with_scales).error, with_scale(1.5 * of_course), 2e-4)
        << "hidden blood is not asked for";
}

TEST(Certainty, IsLessWhereSmokeMayHideBlood) {
    const double hidden = 0.15;  // alike for 10 s, blocks of 1 s
    const double alone = of_course * std::hypot(0.006, std::sqrt(hidden_blood_lasts) * hidden) / 0.006;
    EXPECT_GT(alone, 3.0 * of_scale);
    EXPECT_NEAR(certainty_with(hidden, 0.006, Errors::with_hidden).error, with_scale(alone), 0.01 * alone);
}

TEST(Certainty, IntervalHoldsTheErrorOfTheScaleThatNoCourseShows) {
    for (const Errors errors : {Errors::of_course, Errors::with_scales}) {
        const Certainty found = certainty_with(0.0, 0.006, errors);
        EXPECT_NEAR(found.high, deviates * std::hypot(of_course, of_scale), 0.01);
        EXPECT_NEAR(found.low, -found.high, 0.01);
        EXPECT_EQ(found.determined, errors == Errors::of_course) << "0.6 is more than 0.4";
    }
}

}  // namespace
}  // namespace lapfx::match
