#include "match/fit/worse.h"

#include <gmock/gmock.h>

namespace lapfx::match {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

FitResult result_of(double veil_before, double veil_after) {
    FitResult result;
    result.veil_before = veil_before, result.veil_after = veil_after;
    return result;
}

TEST(WhatIsWorse, NamesEachFigureThatIsFartherThanBefore) {
    FitResult result = result_of(0.12, 0.04);
    result.blood_before = 0.031, result.blood_after = 0.05;
    result.colors_before = {.blood = 9.0, .smoke = 4.0, .tissue = 6.5};
    result.colors_after = {.blood = 3.0, .smoke = 4.2, .tissue = 11.9};
    EXPECT_THAT(what_is_worse(result), ElementsAre("blood: off by 3.1 % before, 5.0 % after",
                                                   "colour of tissue: Delta E 6.5 before, 11.9 after"));
}

TEST(WhatIsWorse, IsNothingWhereNobodyWouldSeeItOrItIsNotKnown) {
    EXPECT_THAT(what_is_worse({}), IsEmpty());
    EXPECT_THAT(what_is_worse(result_of(0.1, 0.104)), IsEmpty()) << "0.4 % of the view";
    FitResult result = result_of(0.1, 0.1);
    result.blood_after = 0.5;
    result.colors_before.blood = 2.0;
    EXPECT_THAT(what_is_worse(result), IsEmpty()) << "not known before, or not after";
    result.colors_after.blood = 2.9;
    EXPECT_THAT(what_is_worse(result), IsEmpty()) << "hardly noticeable";
    result.colors_after.blood = 3.1;
    EXPECT_THAT(what_is_worse(result), ElementsAre("colour of blood: Delta E 2.0 before, 3.1 after"));
}

}  // namespace
}  // namespace lapfx::match
