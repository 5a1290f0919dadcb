#include "bench/measure/figures.h"

#include <gmock/gmock.h>

namespace lapfx::bench {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Pair;
using testing::UnorderedElementsAre;

constexpr double exact = 1e-12;

Reading reading(double truth, double value, double half = 0.1) {
    return {.truth = truth, .measured = {.value = value, .low = std::max(value - half, 0.0), .high = value + half}};
}

TEST(Figures, OfReadingsByHand) {
    std::vector<Reading> readings{reading(0.1, 0.2), reading(0.3, 0.2, 0.05), reading(0.5, 0.8, 0.1)};
    readings[0].dice = 0.5;
    readings[2].dice = 0.9;
    EXPECT_THAT(figures_of(readings),
                UnorderedElementsAre(Pair("count", 3.0), Pair("mean_absolute_error", DoubleNear(0.5 / 3, exact)),
                                     Pair("bias", DoubleNear(0.1, exact)), Pair("zero_error", DoubleNear(0.3, exact)),
                                     Pair("error_over_zero", DoubleNear(0.5 / 0.9, exact)),
                                     // the covariance 0.12 over the root of 0.08 * 0.24
                                     Pair("correlation", DoubleNear(0.12 / std::sqrt(0.08 * 0.24), exact)),
                                     Pair("dice", DoubleNear(0.7, exact)),
                                     Pair("interval_coverage", DoubleNear(1.0 / 3, exact)),
                                     Pair("interval_width", DoubleNear(0.5 / 3, exact))));
}

TEST(Figures, FalseAreaIsThatOfPicturesWithNothingInThem) {
    const std::vector<Reading> readings{reading(0.0, 0.02), reading(0.0, 0.04), reading(0.3, 0.9)};
    EXPECT_NEAR(figures_of(readings).at("false_area"), 0.03, exact);
    EXPECT_NEAR(figures_of(readings).at("false_area_95"), 0.04, exact);
}

TEST(Figures, OneInTwentyFalseAreasMayBeLarger) {
    std::vector<Reading> readings(20, reading(0.0, 0.01));
    readings[7].measured.value = 0.5;
    EXPECT_NEAR(figures_of(readings).at("false_area_95"), 0.01, exact);
    readings[8].measured.value = 0.3;
    EXPECT_NEAR(figures_of(readings).at("false_area_95"), 0.3, exact);
}

TEST(Figures, WithoutReadingsThereIsOnlyTheirCount) {
    EXPECT_THAT(figures_of(std::vector<Reading>{}), ElementsAre(Pair("count", 0.0)));
}

TEST(Figures, OfEqualAmountsThereIsNoCorrelation) {
    EXPECT_FALSE(figures_of(std::vector<Reading>{reading(0.2, 0.1), reading(0.2, 0.3)}).contains("correlation"));
}

TEST(Bounds, ABiasOfEitherSignIsBounded) {
    const Bound bound{"bias", 0.02};
    EXPECT_TRUE(meets(Figures{{"bias", 0.02}}, bound));
    EXPECT_TRUE(meets(Figures{{"bias", -0.019}}, bound));
    EXPECT_FALSE(meets(Figures{{"bias", -0.021}}, bound));
}

TEST(Bounds, AMissingFigureIsNotWithin) {
    EXPECT_FALSE(meets(Figures{}, {"dice", 0.85, true}));
    EXPECT_FALSE(meets(Figures{}, {"mean_absolute_error", 0.03}));
}

TEST(Bounds, LeastIsALowerBound) {
    const Bound bound{"correlation", 0.95, true};
    EXPECT_TRUE(meets(Figures{{"correlation", 0.95}}, bound));
    EXPECT_FALSE(meets(Figures{{"correlation", 0.94}}, bound));
    EXPECT_EQ(text_of(bound), "r >= 0.95");
    EXPECT_EQ(text_of({"mean_absolute_error", 0.03}), "MAE <= 0.03");
}

/// Of errors 1..9 half widths, nine in number, the 90 % quantile with its correction for ten is the largest.
TEST(LeaveOneOut, TheFactorComesFromTheOtherGroups) {
    std::map<std::string, std::vector<Reading>> groups;
    for (int i = 1; i <= 9; ++i) groups["a"].push_back(reading(0.5, 0.5 + 0.01 * i, 0.01));
    groups["b"] = {reading(0.5, 0.5, 0.01), reading(0.5, 0.58, 0.01), reading(0.5, 0.6, 0.01), reading(0.5, 0.7, 0.01)};
    const std::vector<LeftOut> left = leave_one_out(groups);
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left[1].group, "b");
    EXPECT_EQ(left[1].count, 4U);
    EXPECT_NEAR(left[1].factor, 9.0, 1e-9);
    EXPECT_NEAR(left[1].coverage, 0.5, exact);
    EXPECT_NEAR(left[0].factor, 20.0, 1e-9);  // five scores would be needed for less than the largest
    EXPECT_NEAR(left[0].coverage, 1.0, exact);
}

TEST(LeaveOneOut, AnIntervalThatIsCutOffHasItsLongerSide) {
    const Reading cut{.truth = 0.03, .measured = {.value = 0.0, .low = 0.0, .high = 0.02}};
    const std::vector<LeftOut> left = leave_one_out({{"a", {cut}}, {"b", {cut}}});
    EXPECT_THAT(left, testing::Each(Field(&LeftOut::factor, DoubleNear(1.5, 1e-9))));
}

TEST(LeaveOneOut, NeedsTwoGroups) {
    EXPECT_THAT(leave_one_out({{"a", {reading(0.1, 0.1)}}}), IsEmpty());
}

}  // namespace
}  // namespace lapfx::bench
