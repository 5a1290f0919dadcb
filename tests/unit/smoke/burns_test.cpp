#include "smoke/burns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/contacts.h"
#include "tool/recorder.h"
#include "unit/smoke/support.h"

namespace lapfx::smoke {
namespace {

ToolContact contact(double from, double to, double x_from, double x_to, ToolAction action = ToolAction::cauterise) {
    return test::contact(action, from, to - from, {x_from, 0, 0}, {x_to, 0, 0});
}

std::vector<std::pair<double, double>> spans(const std::vector<ToolContact>& contacts, double after = -1e9) {
    const BurnList burns = burns_of(contacts);
    std::vector<std::pair<double, double>> all;
    for (const Burn& burn : burns.after(after)) all.emplace_back(burn.start, burn.end);
    return all;
}

using Spans = std::vector<std::pair<double, double>>;

TEST(Burns, JoinContactsThatGoOnInTimeAndPlace) {
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2, 5), contact(2, 4, 5, 5)}), (Spans{{0, 4}}));
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1 + 1e-7, 2, 2.3, 5)}), (Spans{{0, 2}})) << "rounded, one sample on";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1.01, 2, 2, 5)}), (Spans{{0, 1}, {1.01, 2}})) << "a pause";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2.6, 5)}), (Spans{{0, 1}, {1, 2}})) << "elsewhere";
    EXPECT_EQ(spans({contact(0, 1, 0, 2), contact(1, 2, 2, 5, ToolAction::coagulate)}), (Spans{{0, 1}, {1, 2}}));
}

// Samples of a haptic thread become many contacts, which are one burn, also when the pedal changes the power.
TEST(Burns, ARecordedStayIsOne) {
    tool::Recorder recorder;
    for (int i = 0; i <= 2000; ++i) {
        const double time = 5.0 + 0.001 * i, angle = 2.0 * (time - 5.0);
        recorder.add({.time = time,
                      .position = {20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0},
                      .touching = true,
                      .action = ToolAction::cauterise,
                      .power = i < 1200 ? 0.5 : 0.9});
    }
    const std::span<const ToolContact> contacts = recorder.contacts();
    EXPECT_GT(contacts.size(), 18u);
    const auto found = spans({contacts.begin(), contacts.end()});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].first, 5.0, 1e-9);
    EXPECT_NEAR(found[0].second, 7.0, 1e-9);
}

TEST(Burns, KeepTwoToolsApart) {
    EXPECT_EQ(spans({contact(0, 1, 0, 1), contact(0, 1, 50, 51), contact(1, 2, 1, 2), contact(1, 3, 51, 52)}),
              (Spans{{0, 2}, {0, 3}}));
}

TEST(Burns, LeaveOutWhatIsColdOrCannotBe) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(
        spans({contact(0, 1, 0, 1, ToolAction::cut), contact(0, 1, 0, 1, ToolAction::suction), contact(nan, 1, 0, 1),
               contact(0, 1, nan, 1), contact(1, 0, 0, 1), contact(0, INFINITY, 0, 1), contact(3, 4, 0, 1)}),
        (Spans{{3, 4}}));
}

TEST(Burns, FindTheirPartAtATime) {
    const std::vector<ToolContact> contacts{contact(0, 1, 0, 2), contact(1, 2, 2, 5), contact(2, 4, 5, 9)};
    const BurnList burns = burns_of(contacts);
    const Burn& burn = burns.after(0.0).front();
    for (const auto& [time, start] : {std::pair{-1.0, 0.0}, {0.5, 0.0}, {1.0, 1.0}, {1.9, 1.0}, {2.0, 2.0}, {9.0, 2.0}})
        EXPECT_EQ(burn.at(burns.parts(), time).contact.time, start) << time;
}

TEST(Burns, ThatAreLongOverAreSkipped) {
    std::vector<ToolContact> contacts;
    for (int i = 0; i < 100; ++i) contacts.push_back(contact(i, i + 0.5, 0, 0));
    EXPECT_EQ(spans(contacts, 97.6), (Spans{{98, 98.5}, {99, 99.5}}));
    contacts[3].duration = 200.0;
    EXPECT_EQ(spans(contacts, 97.6).size(), 97u) << "one that still goes on, and those that come after it";
    EXPECT_TRUE(spans(contacts, 300.0).empty());
}

TEST(Burns, KeepTheirNumberWhileTheyGoOn) {
    std::vector<ToolContact> contacts{contact(0, 1, 0, 2), contact(3, 4, 2, 5)};
    tool::Log log;
    BurnList burns([](const glm::dvec3&) { return true; }, [](const glm::dvec3&) { return 0.0; });
    for (int i = 0; i < 50; ++i) {
        log.update(contacts);
        burns.update(log);
        ASSERT_EQ(burns.after(3.0).size(), 1u);
        EXPECT_EQ(burns.after(3.0).front().number, 1u);
        contacts.push_back(contact(4 + 0.1 * i, 4.1 + 0.1 * i, 5, 5));
    }
}

/// Tissue is where |x| <= 10.
bool on_tissue(const glm::dvec3& place) {
    return std::abs(place.x) <= 10.0;
}

TEST(Burns, APathThatLeavesTheTissueAndComesBackIsTwo) {
    BurnList burns(on_tissue, [](const glm::dvec3&) { return 0.0; });
    burns.update(test::log_of(std::vector{contact(0, 2, 0, 20), contact(2, 4, 20, 0), contact(4, 5, 0, 1)}));
    const std::span<const Burn> all = burns.after(-1e9);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(all[0].end, 1.0, 1e-3);
    EXPECT_NEAR(all[1].start, 3.0, 1e-3);
    EXPECT_EQ(all[1].end, 5.0) << "it goes on from the stroke's part that touches";
}

TEST(Burns, SuctionIsTakenWhereverItIs) {
    BurnList burns(on_tissue, [](const glm::dvec3&) { return 0.0; });
    burns.update(test::log_of(std::vector{contact(1, 3, 45, 45, ToolAction::suction)}));
    EXPECT_TRUE(burns.parts().empty());
    ASSERT_EQ(burns.suctions().size(), 1u);
    EXPECT_EQ(burns.suctions()[0], (Suction{1.0, 3.0}));
}

/// After any writing, undoing and writing again, the burns are those of the present log.
TEST(Burns, FollowTheLog) {
    std::mt19937 random(5);
    const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
    const auto fat = [](const glm::dvec3& p) { return 0.05 * std::abs(p.x); };
    tool::Log log;
    BurnList kept(on_tissue, fat);
    std::vector<ToolContact> contacts;
    for (int step = 0; step < 400; ++step) {
        for (int i = number(4); i > 0 && !contacts.empty(); --i) contacts.pop_back();
        for (int i = number(5); i > 0; --i) {
            const bool goes_on = !contacts.empty() && number(3) > 0;
            const double start =
                goes_on ? contacts.back().end() : (contacts.empty() ? 0.0 : contacts.back().end() + 0.5);
            const double x = goes_on ? contacts.back().to.x : number(25) - 12.0;
            const auto action = goes_on          ? contacts.back().action
                                : number(4) == 0 ? ToolAction::suction
                                                 : ToolAction::cauterise;
            contacts.push_back(contact(start, start + 0.25 * number(4), x, x + number(9) - 4.0, action));
        }
        log.update(contacts);
        const BurnList::Same same = kept.update(log);
        BurnList fresh(on_tissue, fat);
        fresh.update(test::log_of(contacts));
        ASSERT_LE(same.parts, kept.parts().size());
        ASSERT_EQ(kept.parts().size(), fresh.parts().size()) << step;
        for (std::size_t i = 0; i < kept.parts().size(); ++i) {
            const BurnPart &a = kept.parts()[i], &b = fresh.parts()[i];
            ASSERT_TRUE(a.contact == b.contact && a.fat == b.fat && a.before == b.before && a.burn == b.burn &&
                        a.latest_end == b.latest_end)
                << step << ": " << i;
        }
        for (const double time : {-1e9, 1.0, 3.0, 7.0}) {
            const std::span<const Burn> a = kept.after(time), b = fresh.after(time);
            ASSERT_EQ(a.size(), b.size()) << step;
            for (std::size_t i = 0; i < a.size(); ++i)
                ASSERT_TRUE(a[i].start == b[i].start && a[i].end == b[i].end && a[i].last == b[i].last &&
                            a[i].number == b[i].number)
                    << step << ": " << i;
        }
        ASSERT_TRUE(std::equal(kept.suctions().begin(), kept.suctions().end(), fresh.suctions().begin(),
                               fresh.suctions().end()));
    }
}

TEST(Burns, ASampleOfAHeldStrokeAsksOfItsEndAlone) {
    int asked = 0;
    BurnList burns(
        [&](const glm::dvec3&) {
            ++asked;
            return true;
        },
        [](const glm::dvec3&) { return 0.0; });
    std::vector<ToolContact> contacts;
    for (int i = 0; i < 500; ++i) contacts.push_back(contact(i, i + 0.5, 0, 3));
    tool::Log log;
    log.update(contacts);
    burns.update(log);
    asked = 0;
    contacts.back().to.x = 3.5;
    log.update(contacts, contacts.size() - 1);
    EXPECT_EQ(burns.update(log).parts, 499u);
    EXPECT_LE(asked, 6);
    asked = 0;
    burns.update(log);
    EXPECT_EQ(asked, 0) << "nothing was written";
    burns.clear();
    burns.update(log);
    EXPECT_GT(asked, 1000) << "other tissue";
}

}  // namespace
}  // namespace lapfx::smoke
