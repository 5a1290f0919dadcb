#include "smoke/contact_fat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/contacts.h"

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
    return test::contact(action, 1.0, 2.0, from, to);
}

double fat_of(const ToolContact& c) {
    Tissue tissue;
    ContactFat fat;
    return fat.along(c, tissue.sample);
}

TEST(ContactFat, IsTheTissuesWhereTheToolStands) {
    EXPECT_EQ(fat_of(contact({5, 0, 0}, {5, 0, 0})), 1.0);
    EXPECT_EQ(fat_of(contact({-5, 0, 0}, {-5, 0, 0})), 0.0);
    EXPECT_EQ(fat_of(contact({5, 0, 0}, {5, 0, 0}, ToolAction::coagulate)), 1.0);
}

TEST(ContactFat, OfAPathIsTheMeanAlongIt) {
    EXPECT_NEAR(fat_of(contact({-10, 0, 0}, {10, 0, 0})), 0.5, 0.06);
    EXPECT_NEAR(fat_of(contact({-3, 0, 0}, {9, 0, 0})), 0.75, 0.08);
    EXPECT_NEAR(fat_of(contact({-250, 0, 0}, {750, 0, 0})), 0.75, 0.04) << "a long one too";
}

TEST(ContactFat, AContactThatGoesOnAtOnePlaceIsAskedForOnce) {
    Tissue tissue;
    ContactFat fat;
    ToolContact growing = contact({3, 1, 2}, {3, 1, 2});
    for (int frame = 0; frame < 100; ++frame) {
        growing.duration = 0.1 * frame;
        growing.to.x = 3.0 + 0.1 * std::sin(frame);  // a hand trembles
        EXPECT_EQ(fat.along(growing, tissue.sample), 1.0);
    }
    EXPECT_EQ(tissue.asked, 1);
    EXPECT_EQ(fat.along(contact({3.05, 1, 2}, {3.05, 1, 2}), tissue.sample), 1.0);
    EXPECT_EQ(tissue.asked, 1) << "the same place";
}

TEST(ContactFat, AGrowingPathGivesWhatTheFinishedOneGives) {
    Tissue tissue;
    ContactFat fat;
    ToolContact growing = contact({-7, 0, 0}, {-7, 0, 0});
    double last = 0.0;
    for (int frame = 0; frame <= 60; ++frame) {
        growing.to = {-7.0 + 0.3 * frame, 0.1 * frame, 0.0};
        last = fat.along(growing, tissue.sample);
    }
    EXPECT_EQ(last, fat_of(growing));
    EXPECT_GT(last, 0.4);
    EXPECT_LT(tissue.asked, 100) << "60 frames of up to 11 places";
}

TEST(ContactFat, OtherTissueIsAskedAnew) {
    Tissue tissue;
    ContactFat fat;
    const ToolContact one = contact({3, 0, 0}, {3, 0, 0});
    fat.along(one, tissue.sample);
    fat.clear();
    EXPECT_EQ(fat.along(one, [](const glm::dvec3&) { return 0.25; }), 0.25);
    EXPECT_EQ(fat.along(one, [](const glm::dvec3&) { return 7.0; }), 0.25) << "kept";
}

TEST(ContactFat, WhereNoOrganCanBeThereIsNone) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double x : {nan, infinity, -infinity, 1e12, -1e300}) {
        EXPECT_EQ(fat_of(contact({x, 0, 0}, {0, 0, 0})), 0.0);
        EXPECT_EQ(fat_of(contact({0, 0, 0}, {0, x, 0})), 0.0);
    }
}

}  // namespace
}  // namespace lapfx::smoke
