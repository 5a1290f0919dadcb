#include "tool/log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "unit/cautery/support.h"

namespace lapfx::tool {
namespace {

const std::vector<CurvePoint> fading{{1.0, 1.0}, {3.0, 0.0}};

ToolContact stroke(double time, double duration, double x = 0.0) {
    return {.time = time, .duration = duration, .position = {x, 0, 0}, .to = {x + duration, 0, 0}, .power = 0.8};
}

std::vector<ToolContact> contacts_of(const Log& log) {
    std::vector<ToolContact> all;
    for (const Piece& piece : log.pieces()) all.push_back(piece.contact);
    return all;
}

std::vector<ToolContact> applied(std::span<const CurvePoint> points, const std::vector<ToolContact>& contacts) {
    Log log;
    log.set_power(points);
    log.update(contacts);
    return contacts_of(log);
}

TEST(Log, PiecesAreTheUsableContactsInTheOrderOfTheirTimes) {
    ToolContact broken = stroke(2, 1);
    broken.time = std::numeric_limits<double>::quiet_NaN();
    Log log;
    log.update(std::vector{stroke(5, 1), broken, stroke(1, 1), stroke(3, 1)});
    EXPECT_EQ(contacts_of(log), (std::vector{stroke(1, 1), stroke(3, 1), stroke(5, 1)}));
}

TEST(Log, ContactsThatGoOnFromEachOtherAreOneStroke) {
    const auto befores = [](const std::vector<ToolContact>& contacts) {
        Log log;
        log.update(contacts);
        std::vector<int> all;
        for (const Piece& piece : log.pieces())
            all.push_back(piece.before == Piece::none ? -1 : static_cast<int>(piece.before));
        return all;
    };
    using Befores = std::vector<int>;
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(1, 2, 1), stroke(3, 1, 3)}), (Befores{-1, 0, 1}));
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(1 + 1e-7, 2, 1.4)}), (Befores{-1, 0})) << "rounded, one sample on";
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(1.01, 2, 1)}), (Befores{-1, -1})) << "a pause";
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(1, 2, 1.6)}), (Befores{-1, -1})) << "elsewhere";
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(0, 1, 50), stroke(1, 1, 1), stroke(1, 2, 51)}), (Befores{-1, -1, 0, 1}))
        << "two tools";
    EXPECT_EQ(befores({stroke(0, 1, 0), stroke(1, 1, 1), stroke(1, 2, 1)}), (Befores{-1, 0, -1}))
        << "only one goes on from another";
    std::vector<ToolContact> other{stroke(0, 1, 0), stroke(1, 2, 1)};
    other[1].action = ToolAction::cut;
    EXPECT_EQ(befores(other), (Befores{-1, -1}));
    other[1].action = ToolAction::cauterise;
    other[1].power = 0.3;
    EXPECT_EQ(befores(other), (Befores{-1, 0})) << "its power may change";
}

TEST(Log, WhoKnowsARevisionTakesWhatWasWrittenAfterIt) {
    Log log;
    EXPECT_EQ(log.first_after(0), 0u);
    std::vector<ToolContact> contacts{stroke(0, 1), stroke(2, 1), stroke(4, 1)};
    log.update(contacts);
    EXPECT_EQ(log.first_after(0), 0u);
    const std::uint64_t first = log.revision();
    EXPECT_EQ(log.first_after(first), 3u);
    log.update(contacts);
    EXPECT_EQ(log.revision(), first) << "nothing is new";
    contacts[2].duration = 1.5;
    log.update(contacts, 2);
    const std::uint64_t second = log.revision();
    EXPECT_EQ(log.first_after(first), 2u);
    contacts.push_back(stroke(6, 1));
    log.update(contacts, 3);
    EXPECT_EQ(log.first_after(second), 3u);
    EXPECT_EQ(log.first_after(first), 2u);
    contacts.resize(1);
    const std::uint64_t third = log.revision();
    log.update(contacts);
    EXPECT_GT(log.revision(), third);
    EXPECT_EQ(log.first_after(third), 1u) << "those behind are gone";
    contacts.push_back(stroke(-3, 1));
    const std::uint64_t fourth = log.revision();
    log.update(contacts, 1);
    EXPECT_EQ(log.first_after(fourth), 0u) << "one comes earlier";
    EXPECT_EQ(contacts_of(log), (std::vector{stroke(-3, 1), stroke(0, 1)}));
}

TEST(Log, AReaderIsToldWhereWhatItReadEnds) {
    Log log;
    Reader reader;
    std::vector<ToolContact> contacts{stroke(0, 1), stroke(2, 1), stroke(4, 1)};
    log.update(contacts);
    EXPECT_EQ(reader.take(log), 0u);
    EXPECT_EQ(reader.take(log), 3u) << "nothing is new";
    contacts[2].duration = 1.5;
    log.update(contacts, 2);
    contacts.push_back(stroke(6, 1));
    log.update(contacts, 3);
    EXPECT_EQ(reader.take(log), 2u);
    contacts.resize(1);
    log.update(contacts);
    EXPECT_EQ(reader.take(log), 1u) << "those behind are gone";
    EXPECT_EQ(reader.take(log), 1u);
    reader.forget();
    EXPECT_EQ(reader.take(log), 0u);
    EXPECT_EQ(reader.take(log), 1u);
}

TEST(Log, AStrokeBeforeOthersCostsThoseThatComeAfterIt) {
    Log log;
    std::vector<ToolContact> contacts{stroke(0, 1), stroke(2, 1, 7), stroke(20, 1), stroke(21, 1, 1), stroke(10, 1)};
    log.update(contacts);
    const std::uint64_t known = log.revision();
    contacts.back().duration = 1.5;
    contacts.push_back(stroke(11.5, 1, 1.5));
    log.update(contacts, 4);
    EXPECT_EQ(log.first_after(known), 2u) << "what came before it is known";
    EXPECT_EQ(contacts_of(log),
              (std::vector{contacts[0], contacts[1], contacts[4], contacts[5], contacts[2], contacts[3]}));
    EXPECT_EQ(log.pieces()[3].before, 2u);
    EXPECT_EQ(log.pieces()[5].before, 4u) << "joints of what comes after it stay";
}

/// A log depends only on its list, however it was made, and a reader that follows it by revisions misses nothing.
TEST(Log, IsAFunctionOfItsListAndCurve) {
    std::mt19937 random(3);
    const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    const std::vector<std::vector<CurvePoint>> curves{{}, fading, {{2.0, 0.3}, {2.4, 1.0}, {30.0, 0.1}}};
    Log kept;
    std::vector<CurvePoint> curve;
    std::vector<ToolContact> contacts;
    std::vector<Piece> followed;
    std::uint64_t known = 0;
    for (int step = 0; step < 2000; ++step) {
        std::size_t same = contacts.size();
        if (number(20) == 0) kept.set_power(curve = curves[static_cast<std::size_t>(number(3))]);
        for (int i = number(10) == 0 ? number(30) : 0; i > 0 && !contacts.empty(); --i) contacts.pop_back();
        same = std::min(same, contacts.size());
        if (!contacts.empty() && number(2) == 0) {
            contacts.back().duration += 0.125 * number(3);
            same = std::min(same, contacts.size() - 1);
        }
        for (int i = number(3); i > 0; --i) {
            const double end = contacts.empty() ? 0.0 : contacts.back().end();
            const double x = contacts.empty() ? 0.0 : contacts.back().to.x;
            const bool bad = number(15) == 0;
            contacts.push_back(
                stroke(number(12) == 0 ? 0.25 * number(40) : end + 0.25 * number(2), 0.25 * number(5), x));
            if (number(5) == 0) contacts.back().action = ToolAction::suction;
            if (bad) contacts.back().duration = -1.0;
        }
        kept.update(contacts, static_cast<std::size_t>(number(2)) * same);
        Log fresh;
        fresh.set_power(curve);
        fresh.update(contacts);
        ASSERT_TRUE(std::equal(kept.pieces().begin(), kept.pieces().end(), fresh.pieces().begin(), fresh.pieces().end(),
                               [](const Piece& a, const Piece& b) { return a.same_as(b); }))
            << step;
        if (number(3) == 0) continue;  // some revisions are not looked at
        const std::size_t first = kept.first_after(known);
        ASSERT_LE(first, followed.size()) << step;
        followed.resize(first);
        for (const Piece& piece : kept.pieces().subspan(first)) followed.push_back(piece);
        known = kept.revision();
        ASSERT_TRUE(std::equal(followed.begin(), followed.end(), kept.pieces().begin(), kept.pieces().end(),
                               [](const Piece& a, const Piece& b) { return a.same_as(b); }))
            << step;
    }
}

TEST(LogPower, NoCurveLeavesContactsWhole) {
    EXPECT_EQ(applied({}, {stroke(0, 2)}), std::vector{stroke(0, 2)});
}

TEST(LogPower, PartsJoinAndHaveTheWorkOfTheLine) {
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
            EXPECT_TRUE(goes_on(parts[i - 1], parts[i])) << i;
            EXPECT_NEAR(parts[i].power, 0.8 * curve_at(fading, parts[i].time + 0.5 * parts[i].duration), 1e-12) << i;
        }
    }
    EXPECT_NEAR(work, 0.8 * (1.0 + 0.5 * 2.0), 1e-12);
}

TEST(LogPower, PartsAreOneStrokeAndSoIsWhatGoesOnFromThem) {
    Log log;
    log.set_power(fading);
    log.update(std::vector{stroke(0, 2, 0), stroke(2, 2, 2), stroke(9, 1, 0)});
    const auto pieces = log.pieces();
    ASSERT_GT(pieces.size(), 50u);
    EXPECT_EQ(pieces[0].before, Piece::none);
    for (std::size_t i = 1; i + 1 < pieces.size(); ++i) EXPECT_EQ(pieces[i].before, i - 1) << i;
    EXPECT_EQ(pieces.back().before, Piece::none);
}

TEST(LogPower, OnlyHotContactsAreCut) {
    ToolContact cold = stroke(0.0, 4.0);
    cold.action = ToolAction::cut;
    EXPECT_EQ(applied(fading, {cold}), std::vector{cold});
}

TEST(LogPower, PartsThatAreOverStayWhileAContactGrows) {
    Log log;
    log.set_power(fading);
    log.update(std::vector{stroke(0.5, 1.21)});
    const auto shorter = contacts_of(log);
    const std::uint64_t known = log.revision();
    log.update(std::vector{stroke(0.5, 1.93)}, 0);
    const auto longer = contacts_of(log);
    for (std::size_t i = 0; i + 1 < shorter.size(); ++i) {
        EXPECT_DOUBLE_EQ(shorter[i].time, longer[i].time) << i;
        EXPECT_EQ(shorter[i].power, longer[i].power) << i;
    }
    EXPECT_EQ(shorter.back().power, longer[shorter.size() - 1].power) << "also that of the one which grows";
    EXPECT_GE(log.first_after(known), 1u);
}

TEST(LogPower, NeverMorePiecesThanThereIsRoomForAndFewerLeaveFinerSteps) {
    std::vector<CurvePoint> zigzag;
    for (int i = 0; i < 256; ++i) zigzag.push_back({2.0 * i, i % 2 == 0 ? 0.0 : 1.0});
    Log log;
    log.set_power(zigzag);
    log.update(std::vector(4096, stroke(0.0, 500.0)));
    EXPECT_LE(log.pieces().size(), Log::most_pieces);
    EXPECT_GE(log.pieces().size(), 4096u);
    EXPECT_NEAR(log.pieces().front().contact.power, 0.8 * 0.5, 0.01) << "the mean";
    log.update(std::vector{stroke(0.0, 500.0)});
    EXPECT_EQ(contacts_of(log), applied(zigzag, {stroke(0.0, 500.0)}));
    EXPECT_GT(log.pieces().size(), 1000u);
    std::vector<ToolContact> grown;
    for (const std::size_t count : {100u, 700u, 1500u, 1600u}) {
        const std::size_t same = grown.size();
        while (grown.size() < count) grown.push_back(stroke(0.01 * static_cast<double>(grown.size()), 10.0));
        log.update(grown, same);
        EXPECT_TRUE(contacts_of(log) == applied(zigzag, grown)) << count;
        EXPECT_LE(log.pieces().size(), Log::most_pieces) << count;
        EXPECT_GT(log.pieces().size(), Log::most_pieces / 10) << count << ": as fine as there is room for";
    }
}

/// Heat: one stay under a curve equals many small ones, each with the power of its time.
TEST(LogPower, HeatIsThatOfManySmallContacts) {
    CauteryParameters parameters = cautery::simple_parameters();
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        std::vector<ToolContact> small;
        constexpr int count = 1600;
        for (int i = 0; i < count; ++i) {
            const double time = 0.5 + i * (2.0 / count), length = 2.0 / count;
            small.push_back({.time = time, .duration = length, .power = curve_at(fading, time + 0.5 * length)});
        }
        cautery::LoggedCautery many(cautery::flat(), {}), one(cautery::flat(), {});
        one.log.set_power(fading);
        many.set(small, parameters);
        one.set(std::vector<ToolContact>{{.time = 0.5, .duration = 2.0}}, parameters);
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
}  // namespace lapfx::tool
