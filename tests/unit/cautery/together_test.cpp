// What several tools do at one place: heat adds, nothing cold undoes a burn, a wound is there once, and the order in
// which contacts are given means nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

constexpr glm::dvec3 here{0.0};

struct Outcome {
    std::vector<Wound> wounds;
    std::vector<glm::vec2> marks;
    double burnt = 0.0;
    bool operator==(const Outcome&) const = default;
    int open() const {
        return static_cast<int>(std::ranges::count_if(wounds, [](const Wound& w) { return w.stop == never; }));
    }
};

class Together : public testing::TestWithParam<HeatModel> {
  protected:
    Together() { parameters_.model = GetParam(); }
    Outcome after(const std::vector<ToolContact>& contacts, double time = 12.0) {
        LoggedCautery cautery(flat(), {});
        cautery.set(contacts, parameters_);
        return read(cautery, time);
    }
    static Outcome read(LoggedCautery& cautery, double time) {
        cautery.update(time);
        return {.wounds = {cautery.wounds().begin(), cautery.wounds().end()},
                .marks = {cautery.marks().begin(), cautery.marks().end()},
                .burnt = cautery.burnt_area()};
    }
    CauteryParameters parameters_;
};

ToolContact with_power(ToolContact contact, double power) {
    contact.power = power;
    return contact;
}

TEST_P(Together, ABurnBleedsWhateverElseBeginsThere) {
    const ToolContact burn = at(here, 1.0, 1.0);
    const Outcome alone = after({burn});
    ASSERT_EQ(alone.wounds.size(), 1u);
    const std::vector<std::vector<ToolContact>> others{
        {at(here, 1.0, 1.0, ToolAction::coagulate)}, {at(here, 1.0, 0.0, ToolAction::coagulate)},
        {with_power(at(here, 1.0, 1.0), 0.3)},       {burn},
        {with_power(at(here, 0.9, 0.6), 0.0)},       {with_power(at(here, 0.9, 6.0), 0.0)},
    };
    for (std::size_t i = 0; i < others.size(); ++i) {
        std::vector<ToolContact> contacts = others[i];
        contacts.push_back(burn);
        const Outcome first = after(contacts);
        EXPECT_EQ(first.wounds.size(), 1u) << i;
        EXPECT_EQ(first.open(), 1) << i;
        EXPECT_GE(first.burnt, alone.burnt) << i << ": nothing cools a burn";
        std::reverse(contacts.begin(), contacts.end());
        EXPECT_EQ(after(contacts), first) << i;
    }
    EXPECT_EQ(after({with_power(at(here, 0.9, 0.6), 0.0), burn}), alone) << "no power is no heat";
}

TEST_P(Together, HeatAdds) {
    // Two of half the power are one of the whole.
    const Outcome one = after({at(here, 1.0, 1.5)});
    const Outcome two = after({with_power(at(here, 1.0, 1.5), 0.5), with_power(at(here, 1.0, 1.5), 0.5)});
    ASSERT_EQ(two.wounds.size(), 1u);
    EXPECT_NEAR(two.wounds[0].start, one.wounds[0].start, 1e-6);
    EXPECT_NEAR(two.burnt, one.burnt, 1e-3 * one.burnt);
    EXPECT_TRUE(after({with_power(at(here, 1.0, 1.0), 0.5)}).wounds.empty()) << "one alone does not cut";
}

TEST_P(Together, ACoagulationThatGoesOnClosesWhenTheTissueIsBelowTheCutTemperature) {
    const Outcome both = after({at(here, 1.0, 1.0), at(here, 1.0, 8.0, ToolAction::coagulate)});
    ASSERT_EQ(both.wounds.size(), 1u);
    EXPECT_GT(both.wounds[0].stop, 2.0) << "not while it is divided";
    EXPECT_LT(both.wounds[0].stop, 9.0);
}

/// A scene with ties, duplicates, contacts without power and without duration.
std::vector<ToolContact> random_scene(std::mt19937& random) {
    const auto number = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    std::vector<ToolContact> contacts(static_cast<std::size_t>(4 + number(44)));
    for (ToolContact& c : contacts) {
        c.action = tool_actions[static_cast<std::size_t>(number(5))].action;
        c.time = 0.5 * number(8);
        c.duration = 0.25 * number(6);
        c.position = {2.0 * number(6) - 5.0, 0.0, 2.0 * number(3)};
        c.to = number(2) == 0 ? c.position : c.position + glm::dvec3(1.5 * number(4), 0.0, 0.0);
        c.power = number(4) == 0 ? 0.0 : 0.25 * (1 + number(4));
        c.strength = 0.5 + 0.25 * number(3);
    }
    for (int i = 0; i < 3; ++i) contacts.push_back(contacts[static_cast<std::size_t>(number(4))]);
    return contacts;
}

TEST_P(Together, TheOrderOfContactsMeansNothing) {
    std::mt19937 random(7);
    const int scenes = GetParam() == HeatModel::radial ? 40 : 6;
    for (int scene = 0; scene < scenes; ++scene) {
        std::vector<ToolContact> contacts = random_scene(random);
        const Outcome wanted = after(contacts, 6.0);
        for (int order = 0; order < 3; ++order) {
            std::shuffle(contacts.begin(), contacts.end(), random);
            ASSERT_EQ(after(contacts, 6.0), wanted) << scene;
        }
    }
}

TEST_P(Together, WhatIsAddedOneAfterTheOtherIsAsIfAtOnce) {
    std::mt19937 random(11);
    const int scenes = GetParam() == HeatModel::radial ? 25 : 3;
    for (int scene = 0; scene < scenes; ++scene) {
        std::vector<ToolContact> contacts = random_scene(random), so_far;
        LoggedCautery cautery(flat(), {});
        for (const ToolContact& contact : contacts) {
            so_far.push_back(contact);
            cautery.set(so_far, parameters_);
            cautery.update(contact.time + 0.3);
        }
        EXPECT_EQ(read(cautery, 6.0), after(contacts, 6.0)) << scene;
        while (so_far.size() > 2) {
            so_far.erase(so_far.begin() + static_cast<std::ptrdiff_t>(random() % so_far.size()));
            so_far.pop_back();
            cautery.set(so_far, parameters_);
            ASSERT_EQ(read(cautery, 3.0), after(so_far, 3.0)) << scene << ": " << so_far.size();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, Together, testing::Values(HeatModel::radial, HeatModel::bioheat),
                         [](const auto& model) {
                             return std::string(model.param == HeatModel::radial ? "radial" : "bioheat");
                         });

}  // namespace
}  // namespace lapfx::cautery
