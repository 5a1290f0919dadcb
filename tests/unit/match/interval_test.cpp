#include "match/interval.h"

#include <gtest/gtest.h>

#include <vector>

#include "match/estimator.h"

namespace lapfx::match {
namespace {

FrameAmounts amounts_of(double blood, double smoke, unsigned flags = 0) {
    FrameAmounts a;
    a.blood.value = blood, a.veil.value = smoke, a.flags = flags;
    set_intervals(a);
    return a;
}

double width(const Amount& amount) {
    return amount.high - amount.low;
}

TEST(Interval, IsWiderWhereTheFrameIsHarderToRead) {
    const FrameAmounts plain = amounts_of(0.3, 0.4);
    for (const unsigned flag : {told::tinted, told::bleached, told::motion}) {
        const FrameAmounts spoiled = amounts_of(0.3, 0.4, flag);
        EXPECT_GT(width(spoiled.blood), 1.2 * width(plain.blood)) << flag;
        EXPECT_GT(width(spoiled.veil), 1.2 * width(plain.veil)) << flag;
        EXPECT_LE(spoiled.veil.low, 0.4);
        EXPECT_GE(spoiled.veil.high, 0.4);
    }
    EXPECT_EQ(width(amounts_of(0.3, 0.4, told::cut).veil), width(plain.veil));
    EXPECT_EQ(width(amounts_of(0.3, 0.4, told::dark).veil), 1);
}

TEST(Interval, OfMissingFramesHoldsBothSidesOfTheGap) {
    std::vector<FrameAmounts> frames;
    for (const double smoke : {0.1, 0.1, 0.1, 0.5}) frames.push_back(amounts_of(0.05, smoke));
    frames[1].flags = frames[2].flags = told::missing;
    widen_missing(frames);
    for (const int i : {1, 2}) {
        EXPECT_LE(frames[i].veil.low, frames[0].veil.low);
        EXPECT_GE(frames[i].veil.high, frames[3].veil.high);
        EXPECT_EQ(frames[i].veil.value, 0.1);
    }
    EXPECT_EQ(width(frames[0].veil), width(amounts_of(0.05, 0.1).veil));
    EXPECT_EQ(width(frames[3].veil), width(amounts_of(0.05, 0.5).veil));
}

TEST(Interval, OfMissingFramesAtAnEndIsAll) {
    std::vector<FrameAmounts> frames = {amounts_of(0.1, 0.1), amounts_of(0.1, 0.1, told::missing)};
    widen_missing(frames);
    EXPECT_EQ(width(frames[1].veil), 1);
    EXPECT_EQ(width(frames[1].blood), 1);
    EXPECT_LT(width(frames[0].veil), 0.2);
}

}  // namespace
}  // namespace lapfx::match
