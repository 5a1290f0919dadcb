#include "tool/usable_contact.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/contacts.h"

namespace lapfx::tool {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

ToolContact along(glm::dvec3 from, glm::dvec3 to, double time, double duration) {
    return test::contact(ToolAction::cauterise, time, duration, from, to);
}
ToolContact at(glm::dvec3 place, double time, double duration) {
    return along(place, place, time, duration);
}

TEST(Usable, LeavesOutWhatCannotBe) {
    EXPECT_TRUE(usable(at({1, 2, 3}, 4.0, 5.0)));
    EXPECT_TRUE(usable(at({1, 2, 3}, 4.0, 0.0)));
    EXPECT_FALSE(usable(at({nan, 2, 3}, 4.0, 5.0)));
    EXPECT_FALSE(usable(at({1, 2, 1e30}, 4.0, 5.0)));
    EXPECT_FALSE(usable(at({1, 2, 3}, nan, 5.0)));
    EXPECT_FALSE(usable(at({1, 2, 3}, infinity, 5.0)));
    EXPECT_FALSE(usable(at({1, 2, 3}, 4.0, nan)));
    EXPECT_FALSE(usable(at({1, 2, 3}, 4.0, -1.0)));
    EXPECT_FALSE(usable(at({1, 2, 3}, 4.0, infinity)));
    EXPECT_FALSE(usable(along({0, 0, 0}, {0, 0, 2000}, 0.0, 1.0)));
    EXPECT_FALSE(usable(along({0, 0, 0}, {0, nan, 0}, 0.0, 1.0)));
    ToolContact contact = at({1, 2, 3}, 4.0, 5.0);
    contact.power = nan;
    EXPECT_FALSE(usable(contact));
    contact.power = 7.0;
    EXPECT_EQ(usable(contact)->power, 1.0);
    contact.power = -7.0;
    EXPECT_EQ(usable(contact)->power, 0.0);
    contact.strength = -0.1;
    EXPECT_FALSE(usable(contact));
    contact.strength = nan;
    EXPECT_FALSE(usable(contact));
}

TEST(Usable, OfAVeryLongContactOnlyTheBeginningCounts) {
    const auto contact = usable(along({0, 0, 0}, {60, 0, 0}, 1.0, 6000.0));
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->duration, longest_stay);
    EXPECT_NEAR(contact->to.x, 6.0, 1e-12);
}

}  // namespace
}  // namespace lapfx::tool
