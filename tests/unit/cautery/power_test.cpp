#include "cautery/power.h"

#include <gtest/gtest.h>

#include "cautery/cautery.h"
#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

const std::vector<CurvePoint> fading{{1.0, 1.0}, {3.0, 0.0}};

ToolContact stroke(double time, double duration) {
    return {.time = time, .duration = duration, .position = {0, 0, 0}, .to = {duration, 0, 0}, .power = 0.8};
}

std::vector<ToolContact> applied(std::span<const CurvePoint> points, const std::vector<ToolContact>& contacts) {
    PowerCurve curve;
    curve.set(points);
    const auto parts = curve.apply(contacts);
    return {parts.begin(), parts.end()};
}

TEST(PowerCurve, NoCurveGivesTheSameList) {
    PowerCurve curve;
    const std::vector contacts{stroke(0, 2)};
    EXPECT_EQ(curve.apply(contacts).data(), contacts.data());
}

TEST(PowerCurve, PartsJoinAndHaveTheWorkOfTheLine) {
    const auto parts = applied(fading, {stroke(0.0, 4.0)});
    ASSERT_EQ(parts.size(), 1 + 50 + 1u);
    EXPECT_EQ(parts.front().time, 0.0);
    EXPECT_EQ(parts.front().power, 0.8);
    EXPECT_NEAR(parts.back().end(), 4.0, 1e-12);
    EXPECT_EQ(parts.back().power, 0.0);
    double work = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        work += parts[i].power * parts[i].duration;
        if (i > 0) {
            EXPECT_TRUE(continues(parts[i - 1], parts[i])) << i;
            EXPECT_NEAR(parts[i].power, 0.8 * curve_at(fading, parts[i].time + 0.5 * parts[i].duration), 1e-12) << i;
        }
    }
    EXPECT_NEAR(work, 0.8 * (1.0 + 0.5 * 2.0), 1e-12);
}

TEST(PowerCurve, OnlyHotContactsAreCut) {
    ToolContact cold = stroke(0.0, 4.0);
    cold.action = ToolAction::cut;
    EXPECT_EQ(applied(fading, {cold}), std::vector{cold});
}

TEST(PowerCurve, PartsThatAreOverStayWhileAContactGrows) {
    const auto shorter = applied(fading, {stroke(0.5, 1.21)});
    auto longer_stroke = stroke(0.5, 1.93);
    const auto longer = applied(fading, {longer_stroke});
    for (std::size_t i = 0; i + 1 < shorter.size(); ++i) {
        EXPECT_DOUBLE_EQ(shorter[i].time, longer[i].time) << i;
        EXPECT_EQ(shorter[i].power, longer[i].power) << i;
    }
    EXPECT_EQ(shorter.back().power, longer[shorter.size() - 1].power) << "also that of the one which grows";
}

TEST(PowerCurve, NeverMorePartsThanThereIsRoomFor) {
    std::vector<CurvePoint> zigzag;
    for (int i = 0; i < 256; ++i) zigzag.push_back({2.0 * i, i % 2 == 0 ? 0.0 : 1.0});
    const auto parts = applied(zigzag, std::vector(4096, stroke(0.0, 500.0)));
    EXPECT_LE(parts.size(), PowerCurve::most_parts);
    EXPECT_GE(parts.size(), 4096u);
    EXPECT_NEAR(parts.front().power, 0.8 * 0.5, 0.01) << "the mean";
}

/// Heat: one stay under a curve is as many small stays, each with the power of its time.
TEST(PowerCurve, HeatIsThatOfManySmallContacts) {
    CauteryParameters parameters = simple_parameters();
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        std::vector<ToolContact> small;
        constexpr int count = 1600;
        for (int i = 0; i < count; ++i) {
            const double time = 0.5 + i * (2.0 / count), length = 2.0 / count;
            small.push_back({.time = time, .duration = length, .power = curve_at(fading, time + 0.5 * length)});
        }
        Cautery many(flat(), {}), one(flat(), {});
        many.set(small, parameters);
        one.set(applied(fading, {{.time = 0.5, .duration = 2.0}}), parameters);
        for (const double time : {0.7, 1.5, 2.2, 2.5, 4.0}) {
            many.update(time);
            one.update(time);
            const double expected = many.temperature({0, 0, 0}, time);
            EXPECT_NEAR(one.temperature({0, 0, 0}, time), expected, 0.01 * expected) << time;
        }
        EXPECT_GT(one.temperature({0, 0, 0}, 2.5), 45.0);
    }
}

}  // namespace
}  // namespace lapfx::cautery
