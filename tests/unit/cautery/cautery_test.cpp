#include "cautery/cautery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The mark at a vertex of flat().
glm::vec2 mark_at(const Cautery& cautery, int x, int z) {
    return cautery.marks()[static_cast<std::size_t>((z + 40) * 81 + x + 40)];
}

bool same(std::span<const glm::vec2> a, std::span<const glm::vec2> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

class CauteryTest : public testing::Test {
  protected:
    void expect_like_fresh(const std::vector<ToolContact>& contacts, double time) {
        LoggedCautery fresh(flat(), {});
        fresh.set(contacts, parameters);
        fresh.update(time);
        ASSERT_TRUE(same(cautery.marks(), fresh.marks())) << time;
        ASSERT_TRUE(
            std::equal(cautery.wounds().begin(), cautery.wounds().end(), fresh.wounds().begin(), fresh.wounds().end()))
            << time;
    }

    CauteryParameters parameters = simple_parameters();
    LoggedCautery cautery{flat(), {}};
};

TEST_F(CauteryTest, CharIsThatOfTheHottestThatEachVertexHasBeen) {
    cautery.set(std::vector{at({0, 0, 0}, 1.0, 1.2)}, parameters);
    for (const double time : {1.6, 2.0, 2.2, 50.0}) {
        cautery.update(time);
        const double stayed = std::min(time - 1.0, 1.2), radius2 = 1.5 * 1.5 + 4.0 * stayed;
        for (int x = 0; x <= 12; ++x) {
            const double peak = 37.0 + 400.0 * (1.0 - std::exp(-stayed / 2.0)) * std::exp(-x * x / radius2);
            EXPECT_NEAR(mark_at(cautery, x, 0).x, char_of(peak, parameters), 1e-6) << time << ' ' << x;
        }
    }
    EXPECT_GT(mark_at(cautery, 0, 0).x, 0.6f);
    EXPECT_EQ(mark_at(cautery, 12, 0).x, 0.0f);
}

TEST_F(CauteryTest, HeatDividesWhenItIsHotEnough) {
    cautery.set(std::vector{at({0, 0, 0}, 1.0, 1.2)}, parameters);
    const double opens = 1.0 - 2.0 * std::log(1.0 - 140.0 / 400.0);
    cautery.update(opens - 0.01);
    EXPECT_EQ(mark_at(cautery, 0, 0).y, 0.0f);
    cautery.update(opens + 0.01);
    EXPECT_EQ(mark_at(cautery, 0, 0).y, 1.0f);
    EXPECT_NEAR(mark_at(cautery, 1, 0).y, divided_at(1.0, ToolAction::cut, parameters), 1e-6);
    EXPECT_EQ(mark_at(cautery, 2, 0).y, 0.0f);
}

TEST_F(CauteryTest, AKnifeDividesAlongItsPathAsItGoes) {
    cautery.set(std::vector{along({0, 0, 0}, {10, 0, 0}, 1.0, 2.0, ToolAction::cut)}, parameters);
    cautery.update(2.0);
    for (int x = 0; x <= 5; ++x) EXPECT_EQ(mark_at(cautery, x, 0), glm::vec2(0.0f, 1.0f)) << x;
    EXPECT_EQ(mark_at(cautery, 7, 0).y, 0.0f) << "not there yet";
    EXPECT_NEAR(mark_at(cautery, 3, 1).y, divided_at(1.0, ToolAction::cut, parameters), 1e-6);
    EXPECT_EQ(mark_at(cautery, 3, 2).y, 0.0f);
    cautery.update(9.0);
    EXPECT_EQ(mark_at(cautery, 10, 0).y, 1.0f);
}

TEST_F(CauteryTest, OtherActionsAndNoPowerLeaveNoMarks) {
    ToolContact powerless = at({0, 0, 0}, 0.0, 5.0);
    powerless.power = 0.0;
    cautery.set(std::vector{at({0, 0, 0}, 0.0, 5.0, ToolAction::suction), powerless,
                            at({0, 0, 0}, 0.0, 5.0, ToolAction::irrigation)},
                parameters);
    cautery.update(9.0);
    for (const glm::vec2 mark : cautery.marks()) ASSERT_EQ(mark, glm::vec2(0.0f));
    EXPECT_TRUE(cautery.wounds().empty());
}

TEST_F(CauteryTest, AnyOrderOfTimesAndListsGivesTheSame) {
    std::mt19937 random(5);
    const auto chance = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    std::vector<ToolContact> contacts;
    const ToolAction actions[] = {ToolAction::cauterise, ToolAction::cut, ToolAction::coagulate, ToolAction::tear};
    double time = 0.0;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 from(chance(-15, 15), 0, chance(-15, 15)), to = from + glm::dvec3(chance(-4, 4), 0, 0);
        contacts.push_back(along(from, i % 3 == 0 ? from : to, time, chance(0.2, 3.0), actions[random() % 4]));
        time += i % 5 == 0 ? 0.3 * contacts.back().duration : contacts.back().duration;
        if (i % 7 == 0) {  // continues
            contacts.push_back(along(contacts.back().to, from, contacts.back().end(), 1.0, contacts.back().action));
            time = contacts.back().end();
        }
    }
    const auto first = [&](std::size_t count) {
        return std::vector<ToolContact>(contacts.begin(), contacts.begin() + static_cast<std::ptrdiff_t>(count));
    };
    for (int round = 0; round < 25; ++round) {
        const std::vector<ToolContact> list = first(1 + random() % contacts.size());
        cautery.set(list, parameters);
        const double now = chance(-1.0, time + 5.0);
        cautery.update(now);
        expect_like_fresh(list, now);
    }
    // One after the other, as they happen.
    for (std::size_t count = 1; count <= contacts.size(); ++count) {
        cautery.set(first(count), parameters);
        cautery.update(contacts[count - 1].end());
    }
    expect_like_fresh(contacts, contacts.back().end());
    // One in the middle changes, then all are given in another order.
    std::vector<ToolContact> edited = contacts;
    edited[20].power = 0.3;
    cautery.set(edited, parameters);
    cautery.update(time);
    expect_like_fresh(edited, time);
    std::reverse(edited.begin(), edited.end());
    cautery.set(edited, parameters);
    cautery.update(time);
    expect_like_fresh(edited, time);
}

TEST_F(CauteryTest, TwoToolsAtOnePlaceAtOnceGiveTheSameInAnyOrderOfTimes) {
    const std::vector contacts{at({0, 0, 0}, 0.0, 2.0, ToolAction::coagulate), at({0, 0, 0}, 0.5, 1.0),
                               at({1, 0, 0}, 1.2, 1.5)};
    cautery.set(contacts, parameters);
    for (double time = 0.0; time < 4.0; time += 0.13) {
        cautery.update(time);
        expect_like_fresh(contacts, time);
    }
}

TEST_F(CauteryTest, BluntDissectionFraysWiderThanAKnifeCuts) {
    cautery.set(std::vector{at({0, 0, 0}, 0.0, 1.0, ToolAction::cut), at({20, 0, 0}, 0.0, 1.0, ToolAction::tear)},
                parameters);
    cautery.update(1.0);
    EXPECT_EQ(mark_at(cautery, 0, 0).y, 1.0f);
    EXPECT_EQ(mark_at(cautery, 2, 0).y, 0.0f);
    EXPECT_NEAR(mark_at(cautery, 20, 0).y, 0.6f, 1e-6);
    EXPECT_GT(mark_at(cautery, 21, 0).y, 0.3f);
    EXPECT_GT(mark_at(cautery, 22, 0).y, 0.0f);
    EXPECT_EQ(mark_at(cautery, 23, 0).y, 0.0f);
}

TEST_F(CauteryTest, CoagulationBlanchesAndDoesNotChar) {
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        cautery.set(std::vector{at({0, 0, 0}, 0.0, 5.0, ToolAction::coagulate)}, parameters);
        cautery.update(6.0);
        const double gentle = 0.5 * (parameters.coagulation_temperature + parameters.char_temperature);
        EXPECT_GT(mark_at(cautery, 0, 0).x, 0.5 * char_of(gentle, parameters));
        EXPECT_LT(mark_at(cautery, 0, 0).x, 1.3 * char_of(gentle, parameters)) << "a step of the solver beyond at most";
        EXPECT_LT(mark_at(cautery, 0, 0).x, 0.35f) << "nothing is burnt";
        EXPECT_EQ(mark_at(cautery, 0, 0).y, 0.0f);
    }
}

TEST_F(CauteryTest, ParametersTakeEffectAtOnce) {
    const std::vector contacts{at({0, 0, 0}, 0.0, 1.0), along({5, 0, 0}, {9, 0, 0}, 2.0, 4.0)};
    cautery.set(contacts, parameters);
    cautery.update(9.0);
    const auto before = cautery.wounds_version();
    for (const HeatModel model : {HeatModel::bioheat, HeatModel::radial}) {
        parameters.model = model;
        parameters.heat_rate += 30.0;
        parameters.tip_radius += 0.7;
        cautery.set(contacts, parameters);
        cautery.update(9.0);
        expect_like_fresh(contacts, 9.0);
        EXPECT_NE(cautery.wounds_version(), before);
    }
}

TEST_F(CauteryTest, ChangedVerticesAreTheOnesThatChange) {
    cautery.set(std::vector{at({0, 0, 0}, 1.0, 2.0)}, parameters);
    cautery.update(2.0);
    std::vector<glm::vec2> sent(cautery.marks().size(), glm::vec2(0.0f));
    std::size_t vertices = 0;
    const auto send = [&] {
        vertices = 0;
        for (const VertexRun run : cautery.changed().take()) {
            vertices += run.end - run.begin;
            for (std::uint32_t v = run.begin; v < run.end; ++v) sent[v] = cautery.marks()[v];
        }
        return same(sent, cautery.marks());
    };
    EXPECT_TRUE(send());
    EXPECT_GT(vertices, 20u);
    EXPECT_LT(vertices, 900u) << "of 6561";
    for (const double time : {2.5, 3.0, 9.0, 1.5, 0.0}) {
        cautery.update(time);
        EXPECT_TRUE(send()) << time;
    }
    cautery.update(-1.0);
    EXPECT_TRUE(cautery.changed().empty());
}

TEST_F(CauteryTest, VesselsDecideHowStronglyItBleeds) {
    LoggedCautery with(flat(), [](const glm::dvec3& p) { return p.x < 0.0 ? 0.0 : 0.25 * p.x; });
    with.set(std::vector{at({-5, 0, 0}, 0.0, 0.1, ToolAction::cut), at({2, 0, 0}, 1.0, 0.1, ToolAction::cut),
                         at({8, 0, 0}, 2.0, 1.0)},
             parameters);
    with.update(9.0);
    ASSERT_EQ(with.wounds().size(), 2u);
    EXPECT_EQ(with.wounds()[0].strength, 0.5);
    EXPECT_EQ(with.wounds()[1].strength, 2.0);
    EXPECT_EQ(mark_at(with, -5, 0).y, 1.0f) << "divided all the same";
}

TEST_F(CauteryTest, WoundsTooCloseToAStrongerOpenOneAddNothing) {
    const auto knife = [](double x, double time, double strength) {
        ToolContact contact = at({x, 0, 0}, time, 0.1, ToolAction::cut);
        contact.strength = strength;
        return contact;
    };
    cautery.set(std::vector{knife(0, 0, 1), knife(0.9, 1, 1), knife(1.1, 2, 1), knife(0, 3, 1.5),
                            at({0, 0, 0}, 5.0, 1.0, ToolAction::coagulate), knife(0, 9, 1)},
                parameters);
    cautery.update(20.0);
    std::vector<double> starts;
    for (const Wound& wound : cautery.wounds()) starts.push_back(wound.start);
    EXPECT_EQ(starts, (std::vector<double>{0.0, 2.0, 3.0, 9.0}));
}

TEST_F(CauteryTest, BeyondTheLimitLaterWoundsAreLeftOutAndCounted) {
    std::vector<ToolContact> contacts;
    for (int i = 0; i < 5000; ++i)
        contacts.push_back(at({i % 71 * 1.1 - 39.0, 0, i / 71 * 1.1 - 39.0}, 0.01 * i, 0.01, ToolAction::cut));
    cautery.set(contacts, parameters);
    cautery.update(60.0);
    EXPECT_EQ(cautery.wounds().size(), WoundList::most);
    EXPECT_EQ(cautery.left_out(), 5000 - WoundList::most);
    EXPECT_NEAR(cautery.wounds().back().start, 0.01 * 4095, 1e-9) << "the first ones stay";
}

/// Radius around a burn in one place that was at least this hot when it ended, mm, and when it began to cut.
struct Burn {
    double charred, cooked, cut;
};
Burn burn_of(HeatModel model, double duration) {
    static const Surface fine(test::plane(20.0, 50));
    CauteryParameters c;
    c.model = model;
    LoggedCautery cautery(fine, {});
    cautery.set(std::vector{at({0, 0, 0}, 0.0, duration)}, c);
    cautery.update(duration);
    const auto radius = [&](double temperature) {
        double inside = 0.0, outside = 9.9;
        for (int i = 0; i < 30; ++i) {
            const double middle = 0.5 * (inside + outside);
            (cautery.temperature({middle, 0.0, 0.0}, duration) > temperature ? inside : outside) = middle;
        }
        return inside;
    };
    return {radius(c.char_temperature), radius(c.coagulation_temperature), cautery.wounds()[0].start};
}

TEST(HeatModels, BurnAlikeByDefault) {
    for (const double duration : {1.0, 2.0, 3.0, 4.0, 5.0}) {
        const Burn radial = burn_of(HeatModel::radial, duration), bioheat = burn_of(HeatModel::bioheat, duration);
        EXPECT_NEAR(radial.charred / bioheat.charred, 1.0, 0.2) << duration << " s: " << bioheat.charred << " mm";
        EXPECT_NEAR(radial.cooked / bioheat.cooked, 1.0, 0.2) << duration << " s: " << bioheat.cooked << " mm";
        EXPECT_NEAR(radial.cut / bioheat.cut, 1.0, 0.2) << duration << " s";
        EXPECT_GT(bioheat.charred, 1.0);
        EXPECT_LT(bioheat.cooked, 4.0);
    }
}

TEST_F(CauteryTest, OffTheSurfaceTheTipTouchesNothing) {
    const auto marks = [&](double y) {
        cautery.set(std::vector{at({0, y, 0}, 0.0, 1.0), at({5, y, 0}, 2.0, 0.1, ToolAction::cut)}, parameters);
        cautery.update(5.0);
        return cautery.wounds().size();
    };
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        EXPECT_EQ(marks(4.9), 2u);
        EXPECT_EQ(marks(-4.9), 2u);
        EXPECT_EQ(marks(5.1), 0u);
        for (const glm::vec2 mark : cautery.marks()) ASSERT_EQ(mark, glm::vec2(0.0f));
        EXPECT_EQ(cautery.temperature({0, 5.1, 0}, 1.0), 37.0);
    }
}

TEST_F(CauteryTest, HeatReachesOtherPartsOfTheSurfaceNearby) {
    const Surface two(test::joined(test::plane(20.0, 20), test::plane(20.0, 20), {0.0f, -1.0f, 0.0f}));
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        LoggedCautery both(two, {});
        both.set(std::vector{at({0, 0, 0}, 0.0, 1.0)}, parameters);
        both.update(1.0);
        EXPECT_GT(both.marks()[220].x, 0.3f);
        EXPECT_GT(both.marks()[441 + 220].x, 0.2f);
        EXPECT_LT(both.marks()[441 + 220].x, both.marks()[220].x);
    }
}

TEST_F(CauteryTest, NonsenseIsLeftOut) {
    const std::vector<ToolContact> sound{at({0, 0, 0}, 0.0, 1.0), at({5, 0, 0}, 2.0, 0.1, ToolAction::cut)};
    std::vector<ToolContact> mixed = sound;
    for (const double bad : {nan, never, -never, 1e300, -1e300}) {
        mixed.insert(mixed.begin(), at({bad, 0, 0}, 0.0, 1.0));
        mixed.insert(mixed.begin() + 1, at({0, 0, 0}, bad, 1.0));
        mixed.push_back(along({0, 0, 0}, {0, bad, 0}, 0.0, 1.0));
        ToolContact contact = at({10, 0, 0}, 0.0, 1.0);
        contact.duration = bad;
        mixed.push_back(contact);
    }
    mixed.push_back(at({10, 0, 0}, 0.0, -1.0));
    mixed.push_back(at({10, 0, 0}, 0.0, 1.0));
    mixed.back().power = nan;
    mixed.push_back(at({10, 0, 0}, 0.0, 1.0));
    mixed.back().strength = nan;
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        cautery.set(mixed, parameters);
        for (const double time : {3.0, nan, never, 1e300, -1e300, 3.0}) cautery.update(time);
        expect_like_fresh(sound, 3.0);
        EXPECT_EQ(cautery.wounds().size(), 2u);
        EXPECT_EQ(cautery.temperature({nan, 0, 0}, 1.0), 37.0);
        EXPECT_EQ(cautery.temperature({0, 0, 0}, nan), 37.0);
        EXPECT_EQ(cautery.temperature({1e200, 0, 0}, 1.0), 37.0);
    }
}

TEST_F(CauteryTest, AnEmptySurfaceHasNoWounds) {
    const Surface none;
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        LoggedCautery empty(none, {});
        empty.set(std::vector{at({0, 0, 0}, 0.0, 1.0), at({0, 0, 0}, 0.0, 1.0, ToolAction::cut)}, parameters);
        empty.update(3.0);
        EXPECT_TRUE(empty.wounds().empty());
        EXPECT_TRUE(empty.marks().empty());
        EXPECT_EQ(empty.temperature({0, 0, 0}, 1.0), 37.0);
    }
}

TEST_F(CauteryTest, TrianglesWithoutAreaDoNoHarm) {
    Organ organ = test::plane(10.0, 10);
    organ.indices.insert(organ.indices.end(), {60, 60, 60, 60, 61, 60, 60, 61, 62});
    const Surface surface(organ);
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        LoggedCautery on(surface, {});
        on.set(std::vector{at({0, 0, 0}, 0.0, 1.0)}, parameters);
        on.update(3.0);
        EXPECT_EQ(on.wounds().size(), 1u);
        EXPECT_GT(on.marks()[60].x, 0.4f);
        for (const glm::vec2 mark : on.marks()) ASSERT_TRUE(mark.x >= 0.0f && mark.x <= 1.0f);
    }
}

/// What a frame costs at most while the last contact of many grows (Cautery::work()).
std::uint64_t frame_cost(LoggedCautery& cautery, std::vector<ToolContact> contacts,
                         const CauteryParameters& parameters) {
    cautery.set(contacts, parameters);
    cautery.update(contacts.back().end());
    std::uint64_t most = 0;
    for (int frame = 0; frame < 100; ++frame) {
        const std::uint64_t before = cautery.work();
        ToolContact& last = contacts.back();
        last.duration += 0.002;
        last.to += glm::dvec3(0.01, 0, 0);
        cautery.set(contacts, parameters);
        cautery.update(last.end());
        most = std::max(most, cautery.work() - before);
    }
    return most;
}

TEST_F(CauteryTest, ManyContactsCostAFrameLittle) {
    std::vector<ToolContact> apart, chain, same_place;
    for (int i = 0; i < 5000; ++i) {
        const auto place = [](int k) {
            return glm::dvec3(30.0 * std::sin(0.003 * k), 0.0, 30.0 * std::cos(0.0047 * k));
        };
        apart.push_back(at({i % 70 - 35.0, 0, i / 70 - 35.0}, i, 0.3 + 0.1 * (i % 7)));
        chain.push_back(along(place(i), place(i + 1), i == 0 ? 0.0 : chain.back().end(), 0.1));
        same_place.push_back(at({0, 0, 0}, i, 0.9));
    }
    const auto cost_of = [&](const std::vector<ToolContact>& contacts) {
        LoggedCautery fresh(flat(), {});
        return frame_cost(fresh, contacts, parameters);
    };
    EXPECT_LT(cost_of(apart), 2'500u) << "what is far away costs nothing";
    EXPECT_LT(cost_of(chain), 20'000u) << "what crosses the place costs a little";
    EXPECT_LT(cost_of(same_place), 15 * same_place.size()) << "each that has heated the place, a few times";
}

}  // namespace
}  // namespace lapfx::cautery
