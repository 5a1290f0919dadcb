// What is said of a parameter that a reference does not tell.
#include "match/fit/undetermined.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lapfx::match {
namespace {

std::vector<FreeParameter> parameters(std::vector<std::string> keys) {
    return free_parameters({}, keys);
}

/// Ten moments, one a second: blood and veil over time; what is below 0 is not measurable.
template <typename Blood, typename Veil>
std::vector<TargetPoint> target_with(Blood blood, Veil veil) {
    const auto amount = [](double value) -> std::optional<Amount> {
        if (value < 0.0) return {};
        return Amount{value, value - 0.01, value + 0.01};
    };
    std::vector<TargetPoint> target;
    for (int i = 0; i < 10; ++i)
        target.push_back({.time = static_cast<double>(i), .blood = amount(blood(i)), .veil = amount(veil(i))});
    return target;
}

std::string why(const std::string& key, const std::vector<TargetPoint>& target, int alike = -1) {
    const Certainty certainty{.alike = alike};
    return why_undetermined(0, parameters({key, "bleeding.speed=1..9"}), {certainty, certainty}, target,
                            courses_of(target));
}

TEST(Undetermined, BloodThatSmokeHidesIsNotCalledMissing) {
    const auto none = [](int) { return 0.0; };
    EXPECT_EQ(why("bleeding.max_extent", target_with(none, none)), "no bleeding is seen, left as it is");
    EXPECT_EQ(why("bleeding.max_extent", target_with([](int i) { return i == 5 ? 0.3 : 0.0; }, none)),
              "no bleeding is seen, left as it is")
        << "for a moment alone";
    EXPECT_EQ(why("bleeding.max_extent", target_with([](int) { return 0.3; }, none)),
              "the blood of the reference does not change beyond the error of measuring")
        << "all of it was there before";
    EXPECT_EQ(why("smoke.haze.accumulation", target_with(none, [](int) { return 0.3; })),
              "the veil of the reference does not change beyond the error of measuring");
    EXPECT_EQ(why("smoke.haze.accumulation", target_with(none, none)),
              "the reference shows no veil beyond the error of measuring");
    const auto hidden_late = [](int i) { return i < 6 ? 0.0 : -1.0; };
    EXPECT_EQ(why("bleeding.max_extent", target_with(hidden_late, [](int i) { return 0.07 * i; })),
              "no bleeding is seen, left as it is; smoke hides it in 40 % of the moments");
    EXPECT_EQ(why("bleeding.max_extent", target_with([](int) { return -1.0; }, [](int) { return 0.7; })),
              "blood of the reference is not measurable; smoke hides it in 100 % of the moments");
    EXPECT_EQ(why("bleeding.max_extent", target_with(hidden_late, [](int) { return -1.0; })),
              "no bleeding is seen, left as it is")
        << "what hides the veil as well is no smoke";
    EXPECT_EQ(why("bleeding.max_extent", target_with([](int) { return -1.0; }, [](int) { return 0.3; })),
              "blood of the reference is not measurable")
        << "nor is it dense enough: the tissue is not found";
}

TEST(Undetermined, BloodThatIsNotSeenShowsNothingOfBleeding) {
    const auto none = [](int) { return 0.0; };
    const auto shows = [&](auto blood) {
        return shows_anything_of("bleeding.speed", courses_of(target_with(blood, none)));
    };
    EXPECT_TRUE(shows([](int i) { return 0.1 * i; }));
    EXPECT_FALSE(shows([](int i) { return i == 5 ? 0.3 : 0.0; }));
}

TEST(Undetermined, BloodInFewMomentsIsTooRare) {
    const auto seen_for = [](int moments) {
        return target_with([moments](int i) { return i < moments ? 0.1 * i : -1.0; }, [](int) { return 0.0; });
    };
    EXPECT_TRUE(too_rare("bleeding.speed", seen_for(2)));
    EXPECT_FALSE(too_rare("bleeding.speed", seen_for(3)));
    EXPECT_FALSE(too_rare("smoke.haze.ventilation", seen_for(2)));
    EXPECT_EQ(why("bleeding.max_extent", seen_for(2)), "blood of the reference is measurable in 2 of 10 moments only");
    EXPECT_THAT(why("bleeding.max_extent", seen_for(3)), testing::StartsWith("blood still spreads"));
    const auto then_smoke =
        target_with([](int i) { return i < 2 ? 0.1 * i : -1.0; }, [](int i) { return i < 4 ? 0.0 : 0.7; });
    EXPECT_EQ(why("bleeding.max_extent", then_smoke),
              "blood of the reference is measurable in 2 of 10 moments only; smoke hides it in 60 % of the moments");
}

TEST(Undetermined, VentilationNeedsFourSecondsOfClearing) {
    const auto none = [](int) { return 0.0; };
    const auto cleared_for = [](int seconds) {
        return
            [seconds](int i) { return i <= 9 - seconds ? 0.05 * i : 0.05 * (9 - seconds) - 0.05 * (i - 9 + seconds); };
    };
    const std::string smokes = "the video ends while it still smokes or soon after; 4 s of clearing would tell it";
    EXPECT_EQ(why("smoke.haze.ventilation", target_with(none, cleared_for(0))), smokes);
    EXPECT_EQ(why("smoke.haze.ventilation", target_with(none, cleared_for(3))), smokes);
    EXPECT_EQ(why("smoke.haze.ventilation", target_with(none, cleared_for(4))), "the curves hardly depend on it");
    EXPECT_EQ(why("smoke.haze.ventilation", target_with(none, cleared_for(4)), 1),
              "it does the same to the curves as bleeding.speed; hold one of both");
}

TEST(Undetermined, WhereTheCurvesAreNearestTellsWhatIsPossible) {
    const FreeParameter speed = parameters({"bleeding.speed"}).front();
    EXPECT_EQ(where_nearest(speed, 2.04, 14.2, false),
              "it is where the curves are nearest; 2.04 to 14.2 mm/s is possible");
    const FreeParameter extent = parameters({"bleeding.max_extent"}).front();
    EXPECT_EQ(where_nearest(extent, 20.0, 120.4, false),
              "it is where the curves are nearest; 20 to 120 mm is possible");
    EXPECT_EQ(where_nearest(speed, 2.0, 20.0, true),
              "it is where the curves are nearest, at its bound; 2 to 20 mm/s is possible");
    const FreeParameter density = parameters({"smoke.plume.density"}).front();
    EXPECT_EQ(where_nearest(density, 0.25, 0.5, false), "it is where the curves are nearest; 0.25 to 0.5 is possible");
}

}  // namespace
}  // namespace lapfx::match
