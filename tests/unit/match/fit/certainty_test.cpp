// How certain a fit is, where it can be worked out by hand: curves that are straight lines of one parameter.
#include "match/fit/certainty.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lapfx::match {
namespace {

constexpr std::size_t times = 13;  // one a second: each is a block of its own
constexpr double slope = 0.05, deviates = 1.645;

std::vector<TargetPoint> target_with(double half_of_blood) {
    std::vector<TargetPoint> target;
    for (std::size_t i = 0; i < times; ++i)
        target.push_back({.time = static_cast<double>(i),
                          .blood = Amount{0.2, 0.2 - half_of_blood, 0.2 + half_of_blood},
                          .veil = {}});
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
    at.slopes[2 * times * columns + 1] = 1.0 / Objective::prior;
    at.slopes[(2 * times + 1) * columns] = 1.0 / Objective::offset_error;
    return at;
}

/// Half of the interval, coordinates, in standard errors: without the scale it is the error of the line.
double error_of(double half_of_blood, double off, Errors errors) {
    const Objective objective(target_with(half_of_blood), {}, {0.0});
    return certainty_of(objective, line(objective, off), std::vector{0.0}, errors, 1).front().error;
}
/// Of the scale: the slopes are all alike, so it is what the parameter needs to make up for it.
const double of_scale = blood_course.scale_error * 0.2 / slope;  // 0.6

// As far off as stated: 13 blocks and one unknown make reduced chi-squared 13 / 12.
TEST(Certainty, IsThatOfLeastSquares) {
    const double expected = 0.006 * std::sqrt(13.0 / 12.0) / (slope * std::sqrt(13.0));
    EXPECT_NEAR(error_of(0.012, 0.006, Errors::of_course), expected, 0.002 * expected);
    EXPECT_NEAR(error_of(0.112, 0.006, Errors::of_course), expected, 0.002 * expected) << "what a search goes by";
    EXPECT_NEAR(error_of(0.012, 0.006, Errors::all), std::hypot(expected, of_scale), 0.002 * of_scale);
}

TEST(Certainty, IsLessWhereSmokeMayHideBlood) {
    // Half an interval of 0.512 is 0.5 above a clear one: 0.15 may be missed for 3 s.
    const double all = std::hypot(0.006, std::sqrt(3.0) * 0.15);
    const double expected = all * std::sqrt(13.0 / 12.0) / (slope * std::sqrt(13.0));
    const double of_prior = expected / Objective::prior, part = 1.0 / (1.0 + of_prior * of_prior);
    EXPECT_NEAR(error_of(0.512, all, Errors::all), std::hypot(expected * std::sqrt(part), of_scale * part),
                0.01 * expected);
}

TEST(Certainty, IntervalHoldsTheErrorOfTheScaleThatNoCourseShows) {
    const Objective objective(target_with(0.012), {}, {0.0});
    const Linearised at = line(objective, 0.006);
    for (const Errors errors : {Errors::of_course, Errors::all}) {
        const Certainty found = certainty_of(objective, at, std::vector{0.0}, errors, 1).front();
        EXPECT_NEAR(found.high, deviates * of_scale, 0.02 * of_scale);
        EXPECT_NEAR(found.low, -found.high, 0.02 * of_scale);
        EXPECT_EQ(found.determined, errors == Errors::of_course) << "0.6 is more than 0.4";
    }
}

}  // namespace
}  // namespace lapfx::match
