#include "cautery/radial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

/// Degrees after so long under a resting tool of simple_parameters(), and when so many are reached: with time constant
/// 2 s it tends to 400 degrees at full power.
double risen(double time, double power = 1.0, double before = 0.0) {
    return 400.0 * power + (before - 400.0 * power) * std::exp(-time / 2.0);
}
double time_to(double rise, double power = 1.0) {
    return -2.0 * std::log(1.0 - rise / (400.0 * power));
}
const double cut_after = time_to(140.0), warm_after = time_to(20.0);
/// Radius of the bell after so long.
double wide(double stayed) {
    return std::sqrt(1.5 * 1.5 + 2.0 * 2.0 * stayed);
}

/// The model as a whole, at any time.
class RadialTest : public testing::Test {
  protected:
    double temperature(const std::vector<ToolContact>& contacts, glm::dvec3 place, double time) {
        cautery.set(contacts, parameters);
        return cautery.temperature(place, time);
    }
    std::vector<Wound> wounds(const std::vector<ToolContact>& contacts) {
        cautery.set(contacts, parameters);
        cautery.update(1e4);
        return {cautery.wounds().begin(), cautery.wounds().end()};
    }

    CauteryParameters parameters = simple_parameters();
    LoggedCautery cautery{flat(), {}};
};

TEST_F(RadialTest, HeatRisesWithTimeAndPowerUpToTheMaximum) {
    ToolContact contact = at({0, 0, 0}, 1.0, 5.0);
    EXPECT_EQ(temperature({contact}, {0, 0, 0}, 0.5), 37.0);
    EXPECT_EQ(temperature({contact}, {0, 0, 0}, 1.0), 37.0);
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 1.5), 37.0 + risen(0.5), 1e-9);
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 2.0), 37.0 + risen(1.0), 1e-9);
    contact.duration = 9.0;
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 8.0), 400.0, 1e-9);
    contact.power = 0.25;
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 2.0), 37.0 + risen(1.0, 0.25), 1e-9);
    contact.power = 0.0;
    EXPECT_EQ(temperature({contact}, {0, 0, 0}, 2.0), 37.0);
}

TEST_F(RadialTest, FallsOffWithARadiusThatGrowsWithTheRootOfTime) {
    const ToolContact contact = at({0, 0, 0}, 0.0, 5.0);
    EXPECT_NEAR(temperature({contact}, {2.5, 0, 0}, 1.0), 37.0 + risen(1.0) * std::exp(-1.0), 1e-9) << "R = 2.5";
    EXPECT_NEAR(temperature({contact}, {0, 0, wide(0.25)}, 0.25), 37.0 + risen(0.25) * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(temperature({contact}, {0, 0, 2.0 * wide(0.25)}, 0.25), 37.0 + risen(0.25) * std::exp(-4.0), 1e-9);
}

TEST_F(RadialTest, TissueCoolsWhenTheToolLeaves) {
    const ToolContact contact = at({0, 0, 0}, 1.0, 0.5);
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 1.5), 37.0 + risen(0.5), 1e-9);
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 3.5), 37.0 + risen(0.5) * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(temperature({contact}, {0, 0, 0}, 99.0), 37.0, 1e-9);
    // H falls at the same rate.
    const double r = 2.0 / wide(0.5 * std::exp(-1.0));
    EXPECT_NEAR(temperature({contact}, {2, 0, 0}, 3.5), 37.0 + risen(0.5) * std::exp(-1.0) * std::exp(-r * r), 1e-9);
}

TEST_F(RadialTest, ASecondContactGoesOnFromTheHeatThatIsLeft) {
    const std::vector contacts{at({0, 0, 0}, 0.0, 0.5), at({0, 0, 0}, 2.5, 0.25)};
    EXPECT_NEAR(temperature(contacts, {0, 0, 0}, 2.5), 37.0 + risen(0.5) * std::exp(-1.0), 1e-9);
    EXPECT_NEAR(temperature(contacts, {0, 0, 0}, 2.75), 37.0 + risen(0.25, 1.0, risen(0.5) * std::exp(-1.0)), 1e-9);
}

TEST_F(RadialTest, ColdActionsHeatNothing) {
    for (const ToolAction action : {ToolAction::cut, ToolAction::tear, ToolAction::suction, ToolAction::irrigation})
        EXPECT_EQ(temperature({at({0, 0, 0}, 0.0, 5.0, action)}, {0, 0, 0}, 3.0), 37.0);
}

TEST_F(RadialTest, AMovingTipHeatsEachPlaceWhileItIsOverIt) {
    // 15 mm/s: over the width of 3 mm in 0.2 s; at the ends over half of it.
    const ToolContact contact = along({0, 0, 0}, {30, 0, 0}, 1.0, 2.0);
    EXPECT_NEAR(temperature({contact}, {10, 0, 0}, 1.0 + 11.5 / 15.0), 37.0 + risen(0.2), 1e-9) << "all the way";
    // Half way over it, at the place itself and s mm behind, where it has been longer.
    double wanted = 0.0;
    for (double s = 0.0; s <= 1.5; s += 0.5) {
        const double stayed = (1.5 + s) / 15.0, r = s / wide(stayed);
        wanted = std::max(wanted, risen(stayed) * std::exp(-r * r));
    }
    EXPECT_NEAR(temperature({contact}, {10, 0, 0}, 1.0 + 10.0 / 15.0), 37.0 + wanted, 1e-9);
    EXPECT_NEAR(temperature({contact}, {30, 0, 0}, 3.0), 37.0 + wanted, 1e-9) << "the end: half of it";
    EXPECT_NEAR(temperature({contact}, {30, 0, 0}, 2.5), 37.0, 0.5) << "still 7.5 mm away";
}

TEST_F(RadialTest, APathInPiecesHeatsLikeThePathInOnePiece) {
    for (const double duration : {6.0, 20.0}) {
        const ToolContact whole = along({-10, 0, 0.2}, {10, 0, 0.2}, 1.0, duration);
        for (const int pieces : {3, 41, 400}) {
            LoggedCautery in_one{flat(), {}}, divided{flat(), {}};
            in_one.set(std::vector{whole}, parameters);
            divided.set(in_pieces(whole, pieces), parameters);
            double worst = 0.0;
            for (const double share : {0.3, 0.7, 1.0}) {
                const double time = whole.time + share * duration + 0.3;
                for (double x = -12.0; x <= 12.0; x += 0.5)
                    for (double z = 0.0; z <= 3.0; z += 1.5) {
                        // The place just ahead of the tip is heated by the piece that goes there.
                        if (share < 1.0 && std::abs(x - whole.tip(time).x) < 4.5) continue;
                        const double wanted = in_one.temperature({x, 0, z}, time);
                        const double found = divided.temperature({x, 0, z}, time);
                        worst = std::max(worst, std::abs(found - wanted));
                    }
            }
            // A hot place is 36 or 120 degrees above the body.
            EXPECT_LT(worst, 0.01) << pieces;
        }
    }
}

TEST_F(RadialTest, StandingInPiecesHeatsLikeStandingInOnePiece) {
    const ToolContact whole = at({0.3, 0, 0}, 0.0, 1.5);
    const std::vector<ToolContact> pieces = in_pieces(whole, 500);
    for (const double time : {0.4, 0.9, 1.5, 4.0})
        EXPECT_NEAR(temperature(pieces, {2, 0, 0}, time), temperature({whole}, {2, 0, 0}, time), 1e-6) << time;
    const std::vector<Wound> found = wounds(pieces);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].start, cut_after, 1e-9);
}

TEST_F(RadialTest, ACurvedPathInPiecesOpensTheSameWounds) {
    const auto circle = [](int pieces) {
        std::vector<ToolContact> out;
        for (int i = 0; i < pieces; ++i) {
            const auto place = [&](int k) {
                const double a = std::numbers::pi * k / pieces;
                return glm::dvec3(10.0 * std::cos(a), 0.0, 10.0 * std::sin(a));
            };
            out.push_back(along(place(i), place(i + 1), i == 0 ? 0.0 : out.back().end(), 10.0 / pieces));
        }
        return out;
    };
    const std::vector<Wound> coarse = wounds(circle(60)), fine = wounds(circle(1000));
    ASSERT_EQ(coarse.size(), fine.size());
    EXPECT_GE(coarse.size(), 12u) << "31.4 mm, but for the last place";
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        EXPECT_LT(glm::distance(coarse[i].position, fine[i].position), 0.1);
        EXPECT_NEAR(coarse[i].start, fine[i].start, 0.05);
    }
}

TEST_F(RadialTest, WoundsOpenWhenTheCutTemperatureIsReached) {
    const std::vector<Wound> found = wounds({at({1, 0, 3}, 5.0, 1.0)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT(glm::distance(found[0].position, {1, 0, 3}), 1e-9);
    EXPECT_NEAR(found[0].start, 5.0 + cut_after, 1e-9);
    EXPECT_EQ(found[0].stop, never);
    EXPECT_EQ(found[0].strength, 1.0);
    EXPECT_TRUE(wounds({at({1, 0, 3}, 5.0, cut_after - 0.01)}).empty()) << "too short";
}

TEST_F(RadialTest, PowerDelaysWounds) {
    ToolContact contact = at({0, 0, 0}, 0.0, 3.0);
    contact.power = 0.5;
    contact.strength = 0.3;
    const std::vector<Wound> found = wounds({contact});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].start, time_to(140.0, 0.5), 1e-9);
    EXPECT_EQ(found[0].strength, 0.3);
    contact.power = 0.0;
    EXPECT_TRUE(wounds({contact}).empty());
}

TEST_F(RadialTest, NoWoundsBelowTheMaximumTemperature) {
    parameters.maximum_temperature = 170.0;
    EXPECT_TRUE(wounds({at({0, 0, 0}, 0.0, 60.0)}).empty());
}

TEST_F(RadialTest, ColdActionsOpenAtOnceWhateverThePower) {
    for (const ToolAction action : {ToolAction::cut, ToolAction::tear}) {
        ToolContact contact = at({0, 0, 0}, 3.0, 0.01, action);
        contact.power = 0.0;
        const std::vector<Wound> found = wounds({contact});
        ASSERT_EQ(found.size(), 1u);
        EXPECT_DOUBLE_EQ(found[0].start, 3.0);
        EXPECT_EQ(found[0].strength, action == ToolAction::cut ? 1.0 : 0.6);
    }
}

TEST_F(RadialTest, OtherActionsOpenNone) {
    for (const ToolAction action : {ToolAction::coagulate, ToolAction::suction, ToolAction::irrigation})
        EXPECT_TRUE(wounds({at({0, 0, 0}, 0.0, 60.0, action)}).empty());
}

TEST_F(RadialTest, AMovingKnifeOpensARow) {
    // 10 mm in 2 s: 5 wounds 2.5 mm apart, each when the tip arrives; the same when the path is cut into pieces.
    const ToolContact contact = along({0, 0, 0}, {10, 0, 0}, 1.0, 2.0, ToolAction::cut);
    for (const auto& contacts : {std::vector{contact}, in_pieces(contact, 7), in_pieces(contact, 999)}) {
        const std::vector<Wound> found = wounds(contacts);
        ASSERT_EQ(found.size(), 5u);
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_NEAR(found[i].position.x, 2.5 * static_cast<double>(i), 1e-6);
            EXPECT_NEAR(found[i].start, 1.0 + 0.5 * static_cast<double>(i), 1e-6);
        }
    }
}

TEST_F(RadialTest, AHotTipThatMovesTooFastOpensNone) {
    // 30 mm: each place is heated for a tenth of the time.
    const double least = 10.0 * cut_after;
    EXPECT_TRUE(wounds({along({0, 0, 0}, {30, 0, 0}, 0.0, least - 0.1)}).empty());
    // At the very ends the tip is over the place for half as long.
    const double enough = least + 0.1;
    const std::vector<Wound> found = wounds({along({0, 0, 0}, {30, 0, 0}, 0.0, enough)});
    ASSERT_EQ(found.size(), 11u);
    // From 1 mm on it is within 1.5 mm of the place at 2.5 mm.
    EXPECT_NEAR(found.front().start, enough / 30.0 + cut_after, 1e-9);
    EXPECT_NEAR(found.front().position.x, 2.5, 1e-9);
    EXPECT_NEAR(found.back().start, enough * 26.0 / 30.0 + cut_after, 1e-9);
}

TEST_F(RadialTest, CoagulatingStopsTheWoundsInReach) {
    const ToolContact knife = at({0, 0, 0}, 0.0, 0.1, ToolAction::cut);
    const auto stop_of = [&](double x, double duration = 1.0) {
        return wounds({knife, at({x, 0, 0}, 4.0, duration, ToolAction::coagulate)}).at(0).stop;
    };
    // Warm enough after 0.1 s; 2.5 mm around a region of sqrt(1.5^2 + 4 H) mm, 2.5 mm after 1 s.
    EXPECT_NEAR(stop_of(0.0), 4.0 + warm_after, 1e-9);
    EXPECT_NEAR(stop_of(4.1), 4.0 + warm_after, 1e-9);
    EXPECT_NEAR(stop_of(4.8), 4.0 + (2.3 * 2.3 - 1.5 * 1.5) / 4.0, 1e-9) << "when the region has grown so far";
    EXPECT_EQ(stop_of(5.1), never);
    EXPECT_EQ(stop_of(0.0, warm_after - 0.01), never) << "too short to get warm";
}

TEST_F(RadialTest, TheFirstCoagulationCountsAndOnlyALaterOne) {
    const ToolContact knife = at({0, 0, 0}, 3.0, 0.1, ToolAction::cut);
    const auto coagulate = [](double time) { return at({0, 0, 0}, time, 1.0, ToolAction::coagulate); };
    parameters.cooling_time = 0.2;
    EXPECT_NEAR(wounds({knife, coagulate(9.0), coagulate(6.0)}).at(0).stop, 6.0 - 0.2 * std::log(0.5), 1e-9);
    EXPECT_EQ(wounds({coagulate(1.0), knife}).at(0).stop, never) << "the wound was not there yet";
}

TEST_F(RadialTest, AMovingCoagulationStopsEachWoundWhenItsPlaceIsWarm) {
    const std::vector<Wound> found =
        wounds({at({0, 0, 0}, 0.0, 0.1, ToolAction::cut), at({20, 0, 0}, 0.0, 0.1, ToolAction::cut),
                along({0, 0, 0}, {20, 0, 0}, 10.0, 10.0, ToolAction::coagulate)});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].stop, 10.0 + warm_after, 1e-9);
    // 2 mm/s. The place 4 mm before the wound is reached first: at 8 mm off by 1.5, then a little more than 0.1 s, and
    // 2.5 + sqrt(1.5^2 + 4 H) mm reach the wound from the one whose H is enough soonest.
    EXPECT_GT(found[1].stop, 10.0 + (20.0 - 2.5 - 3.5 - 1.5) / 2.0);
    EXPECT_LT(found[1].stop, 20.0);
}

TEST_F(RadialTest, CauteryClosesTheWoundsThatWereOpenBeforeItAndNotItsOwn) {
    EXPECT_NEAR(wounds({at({0, 0, 0}, 0.0, 0.1, ToolAction::cut), at({0, 0, 0}, 4.0, 0.3)}).at(0).stop,
                4.0 + warm_after, 1e-9);
    EXPECT_EQ(wounds({at({0, 0, 0}, 4.0, 3.0)}).at(0).stop, never);
    EXPECT_EQ(wounds(in_pieces(at({0, 0, 0}, 4.0, 3.0), 10)).at(0).stop, never) << "nor do later pieces of its chain";
    EXPECT_EQ(wounds({at({0, 0, 0}, 5.0, 0.1, ToolAction::cut), at({0, 0, 0}, 4.0, 0.3)}).at(0).stop, never);
}

TEST_F(RadialTest, AWoundThatOpensUnderARunningCoagulationIsClosedByIt) {
    // The knife comes 0.05 s after the coagulation, which is warm enough 0.1 s after its start.
    const std::vector<Wound> found =
        wounds({at({0, 0, 0}, 1.0, 1.0, ToolAction::coagulate), at({0.5, 0, 0}, 1.05, 0.1, ToolAction::cut)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].stop, 1.0 + warm_after, 1e-9);
}

}  // namespace
}  // namespace lapfx::cautery
