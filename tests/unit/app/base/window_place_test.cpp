#include "app/base/window_place.h"

#include <gtest/gtest.h>

#include <array>

namespace lapfx::app {
namespace {

const std::array<ScreenArea, 2> two{{{{0, 30}, {1920, 1050}}, {{1920, 0}, {2560, 1440}}}};

ScreenArea area_of(ScreenArea area, std::span<const ScreenArea> monitors = two) {
    return fitted({.area = area}, monitors).area;
}

TEST(WindowPlace, StaysWhereItFits) {
    EXPECT_EQ(area_of({{100, 100}, {1440, 900}}), (ScreenArea{{100, 100}, {1440, 900}}));
    EXPECT_EQ(area_of({{2000, 200}, {1440, 900}}), (ScreenArea{{2000, 200}, {1440, 900}})) << "on the second monitor";
    EXPECT_EQ(area_of({{5, 5}, {7, 7}}, {}), (ScreenArea{{5, 5}, {7, 7}})) << "no monitor is known";
}

TEST(WindowPlace, ComesToTheMonitorThatHasMostOfIt) {
    EXPECT_EQ(area_of({{1800, 100}, {1440, 900}}), (ScreenArea{{1920, 100}, {1440, 900}}));
    EXPECT_EQ(area_of({{-200, -50}, {1440, 900}}), (ScreenArea{{0, 30}, {1440, 900}})) << "off the edge and its bar";
    EXPECT_EQ(area_of({{4000, 1300}, {1440, 900}}), (ScreenArea{{3040, 540}, {1440, 900}}));
}

TEST(WindowPlace, OfAMonitorThatIsGoneComesToTheFirst) {
    const std::array<ScreenArea, 1> one{two[0]};
    EXPECT_EQ(area_of({{2000, 200}, {2400, 1300}}, one), (ScreenArea{{0, 30}, {1920, 1050}})) << "no larger than that";
    EXPECT_EQ(area_of({{2000, 200}, {10, 10}}, one), (ScreenArea{{1600, 200}, least_window})) << "and no speck";
}

TEST(WindowPlace, MaximisedStaysSoAndNothingIsNothing) {
    EXPECT_TRUE(fitted({.area = {{0, 30}, {800, 600}}, .maximized = true}, two).maximized);
    EXPECT_FALSE(fitted({}, two));
}

}  // namespace
}  // namespace lapfx::app
