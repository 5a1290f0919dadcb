#include "cautery/bioheat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

CauteryParameters bioheat_parameters() {
    CauteryParameters c = simple_parameters();
    c.model = HeatModel::bioheat;
    c.diffusivity = 0.13;
    c.perfusion = 0.05;
    c.maximum_temperature = 600.0;
    return c;
}

/// Rise on an infinite plane, `r` mm from a Gaussian source that is on from 0 to `off`: the heat of every moment
/// spreads as a Gaussian, and perfusion removes it. Simpson's rule.
double closed_form(const CauteryParameters& c, double r, double time, double off) {
    const double w2 = c.tip_radius * c.tip_radius;
    const auto share = [&](double age) {
        const double wide = w2 + 4.0 * c.diffusivity * age;
        return c.heat_rate * w2 / wide * std::exp(-r * r / wide) * std::exp(-c.perfusion * age);
    };
    const double oldest = time, youngest = std::max(0.0, time - off);
    constexpr int n = 400;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i)
        sum += (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * share(youngest + (oldest - youngest) * i / n);
    return sum * (oldest - youngest) / (3.0 * n);
}

/// Largest difference from the closed form, relative to the rise at the centre at that time.
double worst_error(const Surface& surface, glm::dvec3 centre, const CauteryParameters& c) {
    constexpr double off = 1.2;
    LoggedCautery cautery(surface, {});
    cautery.set(std::vector{at(centre, 0.0, off)}, c);
    double worst = 0.0;
    for (const double time : {0.1, 0.5, 1.2, 1.5, 3.0, 8.0, 15.0}) {
        const double top = closed_form(c, 0.0, time, off);
        for (const double r : {0.0, 0.6, 1.0, 1.5, 2.0, 3.0, 4.5})
            for (const double angle : {0.0, 0.7, 1.9, 4.0}) {
                const glm::dvec3 place = centre + r * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
                const double wanted = closed_form(c, r, time, off);
                const double found = cautery.temperature(place, time) - 37.0;
                worst = std::max(worst, std::abs(found - wanted) / top);
            }
    }
    return worst;
}

TEST(Bioheat, MeetsTheClosedFormOnAPlane) {
    const CauteryParameters c = bioheat_parameters();
    for (const auto cut : {test::Cut::regular, test::Cut::irregular}) {
        const Surface fine(test::plane(30.0, 60, cut));
        EXPECT_LT(worst_error(fine, {0, 0, 0}, c), 0.03) << "0.5 mm, a vertex of the regular plane";
        EXPECT_LT(worst_error(fine, {0.21, 0, -0.13}, c), 0.03) << "0.5 mm";
    }
    const Surface coarse(test::plane(30.0, 30));
    EXPECT_LT(worst_error(coarse, {0, 0, 0}, c), 0.03) << "1 mm";
    EXPECT_LT(worst_error(coarse, {0.4, 0, 0.3}, c), 0.03) << "1 mm";
    const Surface uneven(test::plane(30.0, 30, test::Cut::irregular));
    EXPECT_LT(worst_error(uneven, {0.4, 0, 0.3}, c), 0.06) << "1 mm and uneven: two thirds of the tip's radius";
}

TEST(Bioheat, MeetsTheClosedFormForOtherTissueToo) {
    const Surface surface(test::plane(40.0, 80, test::Cut::irregular));
    CauteryParameters c = bioheat_parameters();
    c.diffusivity = 0.6;
    c.perfusion = 0.0;
    EXPECT_LT(worst_error(surface, {0.1, 0, 0.3}, c), 0.03);
    c.diffusivity = 0.0;
    c.perfusion = 0.2;
    EXPECT_LT(worst_error(surface, {0.1, 0, 0.3}, c), 0.03);
}

TEST(Bioheat, DoesNotDependOnTheMesh) {
    const CauteryParameters c = bioheat_parameters();
    for (const auto cut : {test::Cut::regular, test::Cut::irregular}) {
        const Surface coarse(test::plane(30.0, 30, cut)), fine(test::plane(30.0, 60, cut));
        LoggedCautery on_coarse(coarse, {}), on_fine(fine, {});
        const glm::dvec3 centre(0.3, 0, 0.4);
        for (LoggedCautery* cautery : {&on_coarse, &on_fine}) cautery->set(std::vector{at(centre, 0.0, 1.0)}, c);
        for (const double time : {0.3, 1.0, 2.0, 5.0, 10.0}) {
            const double top = on_fine.temperature(centre, time) - 37.0;
            for (const double r : {0.0, 0.8, 1.5, 2.5}) {
                const double wanted = on_fine.temperature(centre + glm::dvec3(r, 0, 0), time) - 37.0;
                const double found = on_coarse.temperature(centre + glm::dvec3(r, 0, 0), time) - 37.0;
                EXPECT_LT(std::abs(found - wanted) / top, cut == test::Cut::regular ? 0.03 : 0.06) << time << ' ' << r;
            }
        }
    }
}

class BioheatTest : public testing::Test {
  protected:
    /// Marks and wounds equal those of a new model that has seen no other time.
    void expect_like_fresh(double time) {
        LoggedCautery fresh(flat(), {});
        fresh.set(operation, parameters);
        fresh.update(time);
        EXPECT_TRUE(same(cautery.marks(), fresh.marks()));
        EXPECT_TRUE(
            std::equal(cautery.wounds().begin(), cautery.wounds().end(), fresh.wounds().begin(), fresh.wounds().end()));
    }

    std::vector<Wound> wounds(const std::vector<ToolContact>& contacts) {
        cautery.set(contacts, parameters);
        cautery.update(60.0);
        return {cautery.wounds().begin(), cautery.wounds().end()};
    }
    static std::vector<glm::vec2> copy(const Cautery& of) { return {of.marks().begin(), of.marks().end()}; }
    static bool same(std::span<const glm::vec2> a, std::span<const glm::vec2> b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    }

    CauteryParameters parameters = bioheat_parameters();
    LoggedCautery cautery{flat(), {}};
    // Two strokes, a stay, a knife and a coagulation.
    std::vector<ToolContact> operation{
        along({-5, 0, 0}, {5, 0, 0}, 0.503, 10.0), along({5, 0, 0}, {5, 0, 6}, 10.503, 6.0), at({10, 0, -8}, 18.0, 2.5),
        at({-12, 0, 9}, 19.0, 0.1, ToolAction::cut), at({-12, 0, 8}, 21.0, 1.0, ToolAction::coagulate)};
};

TEST_F(BioheatTest, UpdateIsAFunctionOfTheTime) {
    cautery.set(operation, parameters);
    for (const double time : {30.0, 2.345, 19.5, 0.1, 12.0, 11.98, 60.0, 0.52}) {
        cautery.update(time);
        LoggedCautery fresh(flat(), {});
        fresh.set(operation, parameters);
        fresh.update(time);
        ASSERT_TRUE(same(cautery.marks(), fresh.marks())) << time;
        ASSERT_EQ(cautery.temperature({5, 0, 0}, time), fresh.temperature({5, 0, 0}, time)) << time;
        std::size_t started = 0;
        for (const Wound& wound : fresh.wounds()) {
            if (wound.start > time) continue;
            ASSERT_EQ(cautery.wounds()[started].start, wound.start) << time;
            ASSERT_EQ(cautery.wounds()[started].position, wound.position) << time;
            ASSERT_EQ(std::min(cautery.wounds()[started].stop, time), std::min(wound.stop, time)) << time;
            ++started;
        }
    }
    cautery.update(60.0);
    EXPECT_GT(cautery.wounds().size(), 5u);
}

TEST_F(BioheatTest, StepByStepIsTheSameAsAtOnce) {
    cautery.set(operation, parameters);
    for (int frame = 0; frame <= 25 * 60; ++frame) cautery.update(frame / 60.0);
    expect_like_fresh(25.0);
}

TEST_F(BioheatTest, AContactThatGrowsWithEveryFrameIsTheSameAsTheWholeOne) {
    // As the recorder writes them: a moving contact lasts a tenth of a second.
    std::vector<ToolContact> moving = in_pieces(operation[1], 60);
    std::vector<ToolContact> pieces = in_pieces(operation[0], 100);
    pieces.insert(pieces.end(), moving.begin(), moving.end());
    operation.erase(operation.begin(), operation.begin() + 2);
    operation.insert(operation.begin(), pieces.begin(), pieces.end());
    for (int frame = 0; frame <= 22 * 25; ++frame) {
        const double now = frame / 25.0;
        std::vector<ToolContact> so_far;
        for (const ToolContact& contact : operation) {
            if (contact.time > now) break;
            so_far.push_back(contact);
            so_far.back().to = contact.tip(now);
            so_far.back().duration = std::min(contact.duration, now - contact.time);
        }
        cautery.set(so_far, parameters);
        cautery.update(now);
    }
    cautery.set(operation, parameters);
    cautery.update(25.0);
    expect_like_fresh(25.0);
}

TEST_F(BioheatTest, WhatComesLaterDoesNotDisturbThePast) {
    std::vector<ToolContact> first(operation.begin(), operation.begin() + 2);
    cautery.set(first, parameters);
    cautery.update(18.0);
    const std::vector<glm::vec2> before = copy(cautery);
    cautery.set(operation, parameters);
    cautery.update(30.0);
    EXPECT_FALSE(same(before, cautery.marks()));
    cautery.update(18.0);
    EXPECT_TRUE(same(before, cautery.marks()));
}

TEST_F(BioheatTest, EditingThePastRunsAgainFromThere) {
    cautery.set(operation, parameters);
    cautery.update(30.0);
    std::vector<ToolContact> edited = operation;
    edited[1].power = 0.4;
    edited.erase(edited.begin() + 3);
    cautery.set(edited, parameters);
    cautery.update(30.0);
    LoggedCautery fresh(flat(), {});
    fresh.set(edited, parameters);
    fresh.update(30.0);
    EXPECT_TRUE(same(cautery.marks(), fresh.marks()));
    EXPECT_TRUE(
        std::equal(cautery.wounds().begin(), cautery.wounds().end(), fresh.wounds().begin(), fresh.wounds().end()));
    cautery.set({}, parameters);
    cautery.update(30.0);
    for (const glm::vec2 mark : cautery.marks()) ASSERT_EQ(mark, glm::vec2(0.0f));
    EXPECT_TRUE(cautery.wounds().empty());
}

TEST_F(BioheatTest, AWoundOpensWhenTheTipPassesTheCutTemperature) {
    const std::vector<Wound> found = wounds({at({0, 0, 0}, 5.0, 1.2)});
    ASSERT_EQ(found.size(), 1u);
    double low = 0.0, high = 1.2;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (closed_form(parameters, 0.0, middle, 1.2) < 140.0 ? low : high) = middle;
    }
    EXPECT_NEAR(found[0].start, 5.0 + low, 0.03 * low);
    EXPECT_EQ(found[0].stop, never);
    EXPECT_TRUE(wounds({at({0, 0, 0}, 5.0, 0.6)}).empty()) << "too short";
    EXPECT_TRUE(wounds({at({0, 0, 0}, 5.0, 3.0, ToolAction::coagulate)}).empty());
}

TEST_F(BioheatTest, AMovingTipOpensARow) {
    const std::vector<Wound> found = wounds({along({-5, 0, 0}, {5, 0, 0}, 1.0, 10.0)});
    ASSERT_GE(found.size(), 3u);
    for (std::size_t i = 2; i < found.size(); ++i) {  // the tip leaves the first place as it comes
        EXPECT_NEAR(found[i].position.x - found[i - 1].position.x, 2.5, 1e-9);
        EXPECT_NEAR(found[i].start - found[i - 1].start, 2.5, 0.2) << "1 mm/s";
    }
    EXPECT_TRUE(wounds({along({-15, 0, 0}, {15, 0, 0}, 1.0, 3.0)}).empty()) << "too fast";
}

TEST_F(BioheatTest, CoagulationClosesWhenTheWoundIsWarm) {
    const std::vector<Wound> found =
        wounds({at({0, 0, 0}, 1.0, 0.1, ToolAction::cut), at({8, 0, 0}, 1.0, 0.1, ToolAction::cut),
                at({1, 0, 0}, 4.0, 1.0, ToolAction::coagulate)});
    ASSERT_EQ(found.size(), 2u);
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (closed_form(parameters, 1.0, middle, 1.0) < 20.0 ? low : high) = middle;
    }
    EXPECT_NEAR(found[0].stop, 4.0 + low, 0.01);
    EXPECT_EQ(found[1].stop, never) << "7 mm away it stays cold";
}

TEST_F(BioheatTest, CauteryClosesEarlierWoundsAndNotItsOwn) {
    EXPECT_LT(wounds({at({0, 0, 0}, 0.0, 0.1, ToolAction::cut), at({0, 0, 0}, 4.0, 0.3)}).at(0).stop, 4.3);
    EXPECT_EQ(wounds({at({0, 0, 0}, 4.0, 3.0)}).at(0).stop, never);
    EXPECT_EQ(wounds(in_pieces(at({0, 0, 0}, 4.0, 3.0), 10)).at(0).stop, never);
}

TEST_F(BioheatTest, ReadingsNeverExceedTheMaximum) {
    parameters.maximum_temperature = 150.0;
    cautery.set(std::vector{at({0, 0, 0}, 0.0, 5.0)}, parameters);
    EXPECT_EQ(cautery.temperature({0, 0, 0}, 5.0), 150.0);
    cautery.update(5.0);
    EXPECT_TRUE(cautery.wounds().empty()) << "the cut temperature is above it";
}

TEST_F(BioheatTest, ThinAndBrokenTrianglesKeepItFinite) {
    Organ organ = test::plane(20.0, 20, test::Cut::irregular);
    // A needle, a triangle without area, one that uses an edge a third time, and two with the same corners.
    const std::uint32_t middle = 10 * 21 + 10;
    organ.positions[middle + 1] = organ.positions[middle] + glm::vec3(1e-5f, 0.0f, 0.0f);
    organ.indices.insert(organ.indices.end(), {middle, middle, middle + 5, middle, middle + 22, middle + 44});
    organ.indices.insert(organ.indices.end(), {middle, middle + 21, middle + 100});
    const Surface surface(organ);
    LoggedCautery broken(surface, {});
    broken.set(std::vector{at(glm::dvec3(organ.positions[middle]), 0.0, 1.0)}, parameters);
    broken.update(1.0);
    const double hot = broken.temperature(glm::dvec3(organ.positions[middle]), 1.0);
    EXPECT_GT(hot, 150.0);
    EXPECT_LT(hot, 240.0);
    for (const glm::vec2 mark : broken.marks()) {
        ASSERT_TRUE(mark.x >= 0.0f && mark.x <= 1.0f);
        ASSERT_TRUE(mark.y >= 0.0f && mark.y <= 1.0f);
    }
    EXPECT_NEAR(broken.temperature(glm::dvec3(organ.positions[middle]), 300.0), 37.0, 0.5);
}

TEST_F(BioheatTest, HeatThatCannotLeaveIsForgottenInTheEnd) {
    const Surface small(test::plane(6.0, 6));
    parameters.perfusion = 0.0;
    LoggedCautery on(small, {});
    on.set(std::vector{at({0, 0, 0}, 0.0, 1.0)}, parameters);
    // 200 degrees/s for 1 s in a Gaussian of 1.5 mm, most of it on 36 mm2.
    EXPECT_NEAR(on.temperature({3, 0, 3}, 60.0) - 37.0, 200.0 * 3.14159 * 2.25 / 36.0, 3.0);
    EXPECT_EQ(on.temperature({3, 0, 3}, 62.0), 37.0);
    on.update(1e7);
    EXPECT_GT(on.marks()[24].x, 0.3f) << "the char stays";
}

TEST_F(BioheatTest, WorksAtTheRimOfTheSurface) {
    cautery.set(std::vector{at({40, 0, 0}, 0.0, 1.0)}, parameters);
    const double rim = cautery.temperature({40, 0, 0}, 1.0) - 37.0;
    // No heat flows across the rim, as if half a plane were mirrored in it.
    EXPECT_NEAR(rim, closed_form(parameters, 0.0, 1.0, 1.0), 0.05 * rim);
}

}  // namespace
}  // namespace lapfx::cautery
