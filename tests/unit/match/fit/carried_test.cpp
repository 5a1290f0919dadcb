// Curves that are told without drawing.
#include "match/fit/carried.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lapfx::match {
namespace {

constexpr std::size_t times = 20;

/// E, emission and blood area of a scene whose haze and area are multiplied.
std::vector<Amounts> core(double haze, double area) {
    std::vector<Amounts> amounts(times);
    for (std::size_t i = 0; i < times; ++i) {
        amounts[i].haze = haze * static_cast<double>(i) / times;
        amounts[i].emission = i < times / 2 ? 1.0 : 0.0;
        amounts[i].blood_area = area * std::min(static_cast<double>(i), 10.0);
    }
    return amounts;
}

/// What a camera sees of it: tau = 1.4 E + 0.2 emission, of which 0.03 E + 0.05 emission stands out; 1e-4 of the view
/// for each mm2.
ShownCurves seen(const std::vector<Amounts>& amounts) {
    ShownCurves curves;
    for (const Amounts& a : amounts) {
        curves.veil.push_back(1.0 - std::exp(-1.4 * a.haze - 0.2 * a.emission));
        curves.plume.push_back(0.03 * a.haze + 0.05 * a.emission);
        curves.blood.push_back(1e-4 * a.blood_area);
    }
    return curves;
}

TEST(Carried, TellsWhatItWasDrawnAs) {
    Carried carried(1, 5e-5);
    const auto amounts = core(0.5, 20.0);
    carried.drawn(std::vector{0.0}, amounts, seen(amounts));
    const ShownCurves told = carried.at(std::vector{0.0}, amounts);
    for (std::size_t i = 0; i < times; ++i) {
        EXPECT_NEAR(told.veil[i], seen(amounts).veil[i], 1e-12);
        EXPECT_NEAR(told.plume[i], seen(amounts).plume[i], 1e-12);
        EXPECT_NEAR(told.blood[i], seen(amounts).blood[i], 1e-12);
    }
}

TEST(Carried, FollowsTheCore) {
    Carried carried(1, 5e-5);
    carried.drawn(std::vector{0.0}, core(0.5, 20.0), seen(core(0.5, 20.0)));
    const ShownCurves told = carried.at(std::vector{0.7}, core(0.9, 45.0));
    for (std::size_t i = 0; i < times; ++i) {
        EXPECT_NEAR(told.veil[i], seen(core(0.9, 45.0)).veil[i], 1e-9) << i;
        EXPECT_NEAR(told.plume[i], seen(core(0.9, 45.0)).plume[i], 1e-9) << i;
        EXPECT_NEAR(told.blood[i], seen(core(0.9, 45.0)).blood[i], 1e-9) << i;
    }
}

TEST(Carried, WithoutBloodTakesTheShareThatIsGiven) {
    Carried carried(1, 5e-5);
    carried.drawn(std::vector{0.0}, core(0.5, 0.0), seen(core(0.5, 0.0)));
    EXPECT_NEAR(carried.at(std::vector{0.0}, core(0.5, 10.0)).blood[8], 5e-5 * 80.0, 1e-12);
}

TEST(Carried, LearnsWhatTheCoreDoesNotTell) {
    // The veil also depends on a parameter of which the core knows nothing: tau is 0.3 more for each coordinate.
    const auto amounts = core(0.5, 20.0);
    const auto with = [&](double coordinate) {
        ShownCurves curves = seen(amounts);
        for (double& veil : curves.veil) veil = 1.0 - (1.0 - veil) * std::exp(-0.3 * coordinate);
        return curves;
    };
    Carried carried(2, 5e-5);
    carried.drawn(std::vector{0.0, 0.0}, amounts, with(0.0));
    carried.learn(1, 0.25, with(0.25));
    for (std::size_t i = 0; i < times; ++i)
        EXPECT_NEAR(carried.at(std::vector{0.0, 0.8}, amounts).veil[i], with(0.8).veil[i], 1e-9) << i;
    // A drawn curve that was told wrongly teaches the same.
    Carried taught(2, 5e-5);
    taught.drawn(std::vector{0.0, 0.0}, amounts, with(0.0));
    taught.drawn(std::vector{0.0, 0.5}, amounts, with(0.5));
    taught.stand_at(std::vector{0.0, 0.0}, amounts, with(0.0));
    for (std::size_t i = 0; i < times; ++i)
        EXPECT_NEAR(taught.at(std::vector{0.0, 0.8}, amounts).veil[i], with(0.8).veil[i], 1e-9) << i;
}

/// What the factors explain is not learnt a second time, whichever amount is there.
TEST(Carried, TellsALaterPlaceAsItWasDrawn) {
    const auto told_as_drawn = [](const std::vector<Amounts>& first, const std::vector<Amounts>& second) {
        // The view shows a little more than the core says as the parameter moves.
        const auto drawn = [](const std::vector<Amounts>& amounts, double coordinate) {
            ShownCurves curves = seen(amounts);
            for (double& veil : curves.veil) veil = 1.0 - (1.0 - veil) * std::exp(-0.1 * coordinate);
            return curves;
        };
        Carried carried(1, 5e-5);
        carried.drawn(std::vector{0.0}, first, drawn(first, 0.0));
        carried.drawn(std::vector{0.5}, second, drawn(second, 0.5));
        const ShownCurves told = carried.at(std::vector{0.0}, first);
        for (std::size_t i = 0; i < times; ++i) {
            EXPECT_NEAR(told.veil[i], drawn(first, 0.0).veil[i], 1e-9) << i;
            EXPECT_NEAR(told.blood[i], drawn(first, 0.0).blood[i], 1e-9) << i;
        }
    };
    told_as_drawn(core(0.5, 20.0), core(0.8, 30.0));
    told_as_drawn(core(0.5, 0.0), core(0.8, 0.0));
    told_as_drawn(core(0.5, 0.0), core(0.8, 30.0));
    told_as_drawn(core(0.0, 20.0), core(0.0, 30.0));
}

TEST(Carried, StaysWithinWhatAPictureCanShow) {
    Carried carried(1, 5e-5);
    carried.drawn(std::vector{0.0}, core(0.5, 20.0), seen(core(0.5, 20.0)));
    const ShownCurves none = carried.at(std::vector{0.0}, core(-9.0, -1e3)),
                      all = carried.at(std::vector{0.0}, core(1e3, 1e6));
    for (std::size_t i = 1; i < times; ++i) {
        EXPECT_EQ(none.blood[i], 0.0);
        EXPECT_EQ(none.veil[i], 0.0);
        EXPECT_EQ(all.blood[i], 1.0);
        EXPECT_LE(all.veil[i], 1.0);
    }
}

TEST(Carried, CurvesHaveNoGaps) {
    std::vector<FrameAmounts> frames(6);
    const double blood[] = {0.1, 0.2, 9.0, 9.0, 0.5, 9.0};
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].blood.value = blood[i], frames[i].veil.value = 0.3;
        if (blood[i] > 1.0) frames[i].flags = told::dense;
    }
    const ShownCurves curves = curves_of(frames);
    const double expected[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.5};
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_NEAR(curves.blood[i], expected[i], 1e-12);
        EXPECT_EQ(curves.veil[i], 0.3);
    }
    for (FrameAmounts& frame : frames) frame.flags = told::dark;
    EXPECT_EQ(curves_of(frames).veil, std::vector<double>(6, 0.0)) << "nothing is known";
}

}  // namespace
}  // namespace lapfx::match
