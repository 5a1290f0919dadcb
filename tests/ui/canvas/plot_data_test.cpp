#include "ui/canvas/plot_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "ui/canvas/plot.h"

namespace lapfx::ui {
namespace {

const double nan_value = std::numeric_limits<double>::quiet_NaN();

std::vector<double> noise(std::size_t count, unsigned seed, bool gaps) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-5, 5);
    std::vector<double> v(count);
    for (double& y : v) y = gaps && random() % 7 == 0 ? nan_value : value(random);
    return v;
}

TEST(PlotData, ExtremesOfAnyRangeAreThoseOfItsSamples) {
    std::mt19937 random(3);
    for (const std::size_t count : {1U, 15U, 16U, 17U, 255U, 256U, 257U, 5000U}) {
        const std::vector<double> y = noise(count, static_cast<unsigned>(count), true);
        PlotData data;
        data.set(y);
        for (int k = 0; k < 300; ++k) {
            const std::size_t first = random() % (count + 1), last = first + random() % (count + 1 - first);
            Extremes expected;
            for (std::size_t i = first; i < last; ++i) {
                if (std::isfinite(y[i])) expected.add(y[i]);
            }
            const Extremes e = data.extremes(first, last);
            ASSERT_EQ(e.any, expected.any) << first << " " << last;
            ASSERT_EQ(e.low, expected.low);
            ASSERT_EQ(e.high, expected.high);
        }
    }
}

TEST(PlotData, InfinityIsAGapAsNanIs) {
    const std::vector<float> y = {1, std::numeric_limits<float>::infinity(), -2};
    PlotData data;
    data.set(y);
    EXPECT_EQ(data.extremes().high, 1);
    EXPECT_EQ(data.extremes().low, -2);
    EXPECT_EQ(data.statistics(0, 2).width, 0) << "both pieces touch the gap";
    EXPECT_TRUE(std::isnan(data.value_at(0.5)));
}

TEST(PlotData, NoSamplesHaveNoExtremes) {
    PlotData data;
    EXPECT_FALSE(data.extremes().any);
    EXPECT_EQ(data.index_from(3), 0U);
    EXPECT_EQ(data.statistics(0, 1).width, 0);
    data.set(std::vector<double>{});
    EXPECT_FALSE(data.extremes().any);
}

TEST(PlotData, FindsSamplesByPlace) {
    const std::vector<double> y(5, 1.0), x = {0, 1, 1, 4, 10};
    PlotData even, own;
    even.set(y, 10, 2);
    own.set(y, x);
    EXPECT_EQ(even.index_from(9), 0U);
    EXPECT_EQ(even.index_from(12), 1U);
    EXPECT_EQ(even.index_from(12.1), 2U);
    EXPECT_EQ(even.index_from(18.1), 5U);
    EXPECT_EQ(even.nearest(12.9), 1U);
    EXPECT_EQ(even.nearest(13.1), 2U);
    EXPECT_EQ(own.index_from(1), 1U);
    EXPECT_EQ(own.index_from(1.5), 3U);
    EXPECT_EQ(own.nearest(6.9), 3U);
    EXPECT_EQ(own.nearest(7.1), 4U);
    EXPECT_EQ(own.nearest(1e9), 4U);
}

TEST(PlotData, AreaAndMeanOfAStraightLineAreExact) {
    std::vector<double> y(101);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = 2.0 * static_cast<double>(i) * 0.1;  // y = 2x, x in 0..10
    PlotData data;
    data.set(y, 0, 0.1);
    const RangeStatistics s = data.statistics(3.33, 1.27);
    EXPECT_NEAR(s.area, 3.33 * 3.33 - 1.27 * 1.27, 1e-12);
    EXPECT_NEAR(s.width, 2.06, 1e-12);
    EXPECT_NEAR(s.mean, 3.33 + 1.27, 1e-12);
    EXPECT_NEAR(s.extremes.low, 2.54, 1e-12);
    EXPECT_NEAR(s.extremes.high, 6.66, 1e-12);
    EXPECT_NEAR(data.statistics(5.01, 5.03).area, 5.03 * 5.03 - 5.01 * 5.01, 1e-12) << "between two samples";
    EXPECT_NEAR(data.statistics(-100, 100).area, 100, 1e-10) << "beyond the samples there is nothing";
}

TEST(PlotData, AreasOfPartsAddUpToTheWhole) {
    std::mt19937 random(11);
    const std::vector<double> y = noise(3000, 4, true);
    PlotData data;
    data.set(y);
    std::uniform_real_distribution<double> place(0, 2999);
    for (int k = 0; k < 500; ++k) {
        const double a = place(random), b = place(random);
        const double low = std::min(a, b), high = std::max(a, b), middle = low + (high - low) * 0.37;
        const RangeStatistics whole = data.statistics(low, high), left = data.statistics(low, middle),
                              right = data.statistics(middle, high);
        ASSERT_NEAR(whole.area, left.area + right.area, 1e-9);
        ASSERT_NEAR(whole.width, left.width + right.width, 1e-9);
    }
}

TEST(PlotData, CsvHasALineForEachPlaceOfAnySeries) {
    const std::vector<double> a = {1, nan_value, 3}, b = {0.5, 0.25};
    PlotData first, second;
    first.set(a, 0, 1);
    second.set(b, 1, 1.5);
    const PlotSeries series[] = {{"Speed, \"raw\"", &first}, {"Fit", &second}};
    EXPECT_EQ(plot_csv(series, "t", -1, 10), "t,\"Speed, \"\"raw\"\"\",Fit\n0,1,\n1,,0.5\n2,3,\n2.5,,0.25\n");
    EXPECT_EQ(plot_csv(series, "t", 1.5, 2), "t,\"Speed, \"\"raw\"\"\",Fit\n2,3,\n");
    EXPECT_EQ(plot_csv({}, "t", 0, 1), "t\n");
}

}  // namespace
}  // namespace lapfx::ui
