#include "match/interval.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace lapfx::match
