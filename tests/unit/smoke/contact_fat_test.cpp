#include "smoke/contact_fat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lapfx::smoke {
namespace {

/// Fat from x = 0 on, and counts how often it was asked.
struct Tissue {
    int asked = 0;
    ContactFat::Sample sample = [this](const glm::dvec3& place) {
        ++asked;
        return place.x >= 0.0 ? 1.0 : 0.0;
    };
};

ToolContact contact(glm::dvec3 from, glm::dvec3 to, ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = 1.0, .duration = 2.0, .position = from, .to = to};
}

double fat_of(const ToolContact& c) {
    Tissue tissue;
    ContactFat fat;
    return fat.update(std::vector{c}, tissue.sample)[0];
}

TEST(ContactFat, IsTheTissuesWhereTheToolStands) {
    EXPECT_EQ(fat_of(contact({5, 0, 0}, {5, 0, 0})), 1.0);
    EXPECT_EQ(fat_of(contact({-5, 0, 0}, {-5, 0, 0})), 0.0);
    EXPECT_EQ(fat_of(contact({5, 0, 0}, {5, 0, 0}, ToolAction::coagulate)), 1.0);
    EXPECT_EQ(fat_of(contact({5, 0, 0}, {5, 0, 0}, ToolAction::cut)), 0.0) << "cold";
}

TEST(ContactFat, OfAPathIsTheMeanAlongIt) {
    EXPECT_NEAR(fat_of(contact({-10, 0, 0}, {10, 0, 0})), 0.5, 0.06);
    EXPECT_NEAR(fat_of(contact({-3, 0, 0}, {9, 0, 0})), 0.75, 0.08);
    EXPECT_NEAR(fat_of(contact({-250, 0, 0}, {750, 0, 0})), 0.75, 0.04) << "a long one too";
}

TEST(ContactFat, AContactThatGoesOnAtOnePlaceIsAskedForOnce) {
    Tissue tissue;
    ContactFat fat;
    std::vector<ToolContact> contacts{contact({3, 1, 2}, {3, 1, 2})};
    for (int frame = 0; frame < 100; ++frame) {
        contacts[0].duration = 0.1 * frame;
        contacts[0].to.x = 3.0 + 0.1 * std::sin(frame);  // a hand trembles
        EXPECT_EQ(fat.update(contacts, tissue.sample)[0], 1.0);
    }
    EXPECT_EQ(tissue.asked, 1);
    contacts.push_back(contact({3.05, 1, 2}, {3.05, 1, 2}));
    EXPECT_EQ(fat.update(contacts, tissue.sample)[1], 1.0);
    EXPECT_EQ(tissue.asked, 1) << "the same place";
}

TEST(ContactFat, AGrowingPathGivesWhatTheFinishedOneGives) {
    Tissue tissue;
    ContactFat fat;
    std::vector<ToolContact> contacts{contact({-7, 0, 0}, {-7, 0, 0})};
    double last = 0.0;
    for (int frame = 0; frame <= 60; ++frame) {
        contacts[0].to = {-7.0 + 0.3 * frame, 0.1 * frame, 0.0};
        last = fat.update(contacts, tissue.sample)[0];
    }
    EXPECT_EQ(last, fat_of(contacts[0]));
    EXPECT_GT(last, 0.4);
    EXPECT_LT(tissue.asked, 100) << "60 frames of up to 11 places";
}

TEST(ContactFat, OtherTissueIsAskedAnew) {
    Tissue tissue;
    ContactFat fat;
    const std::vector<ToolContact> contacts{contact({3, 0, 0}, {3, 0, 0})};
    fat.update(contacts, tissue.sample);
    fat.clear();
    EXPECT_EQ(fat.update(contacts, [](const glm::dvec3&) { return 0.25; })[0], 0.25);
    EXPECT_EQ(fat.update(contacts, [](const glm::dvec3&) { return 7.0; })[0], 0.25) << "kept";
}

TEST(ContactFat, WhereNoOrganCanBeThereIsNone) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double x : {nan, infinity, -infinity, 1e12, -1e300}) {
        EXPECT_EQ(fat_of(contact({x, 0, 0}, {0, 0, 0})), 0.0);
        EXPECT_EQ(fat_of(contact({0, 0, 0}, {0, x, 0})), 0.0);
    }
    ContactFat fat;
    EXPECT_TRUE(fat.update({}, [](const glm::dvec3&) { return 1.0; }).empty());
}

}  // namespace
}  // namespace lapfx::smoke
