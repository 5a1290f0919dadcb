#include "commands/measured_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lapfx/error.h"
#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

using testing::HasSubstr;

constexpr glm::ivec2 size(200, 100);

template <typename Act>
std::string fault_of(const Act& act) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return error.what();
    }
    return "no fault";
}

class MeasuredPart : public ::testing::Test {
  protected:
    std::string file(const std::string& text) const {
        const std::filesystem::path path = folder / "masks.json";
        std::ofstream(path) << text;
        return path.string();
    }
    test::Folder folder;
};

TEST_F(MeasuredPart, APolygonIsInPixelsOrInFractions) {
    const auto pixels = masks_of("20,10,100,10,100,50", size), fractions = masks_of("0.1,0.1,0.5,0.1,0.5,0.5", size);
    ASSERT_EQ(pixels.size(), 1U);
    ASSERT_EQ(pixels[0].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        for (int k = 0; k < 2; ++k) EXPECT_NEAR(pixels[0][i][k], fractions[0][i][k], 1e-12);
    EXPECT_EQ(pixels[0][2], glm::dvec2(0.5, 0.5));
}

TEST_F(MeasuredPart, AFileHasSeveralPolygonsAllOfOneKind) {
    const auto masks = masks_of(file("[[[0,0],[20,0],[20,10]], [[1,1],[0.5,1],[1,0.5],[0,0]]]"), size);
    ASSERT_EQ(masks.size(), 2U);
    EXPECT_EQ(masks[0][2], glm::dvec2(0.1, 0.1));
    EXPECT_EQ(masks[1][0], glm::dvec2(1.0 / 200, 1.0 / 100));  // pixels, because the other has pixels
    EXPECT_TRUE(masks_of(file("[]"), size).empty());
}

TEST_F(MeasuredPart, WhatIsNoPolygonIsRefusedWithItsPlace) {
    for (const char* text : {"", "1,2,3", "0,0,1,1", "a,b,c,d,e,f", "0,0,nan,0,1,1"})  // strtod reads nan
        EXPECT_THAT(fault_of([&] { masks_of(text, size); }), HasSubstr("--mask")) << text;
    EXPECT_THAT(fault_of([] { masks_of("0,0,300,0,10,10", size); }), HasSubstr("picture of 200x100"));
    const auto of_file = [this](const char* text) {
        const std::string name = file(text);
        return fault_of([&] { masks_of(name, size); });
    };
    EXPECT_THAT(of_file("{}"), HasSubstr("masks.json"));
    EXPECT_THAT(of_file("[[[0,0],[1,1]]]"), HasSubstr("/0: is not x,y of 3"));
    EXPECT_THAT(of_file("[[[0,0],[1,1],[0,1]], [[0,0],[1,\"x\"],[0,1]]]"), HasSubstr("/1/1: is not [x,y]"));
    EXPECT_THAT(of_file("[[[0,0],[1,1],[0,-1]]]"), HasSubstr("/0: is not inside"));
    EXPECT_THAT(fault_of([] { masks_of("nowhere.json", size); }), HasSubstr("nowhere.json"));
}

TEST_F(MeasuredPart, ARegionLiesInThePicture) {
    EXPECT_EQ(region_of("20,10,100,50", size), glm::dvec4(0.1, 0.1, 0.5, 0.5));
    EXPECT_EQ(region_of("0,0,1,1", size), glm::dvec4(0, 0, 1, 1));
    for (const char* text : {"1,2,3", "0,0,0,1", "0.5,0.5,0.6,0.1", "-1,0,10,10", "0,0,1,1x"})
        EXPECT_THAT(fault_of([&] { region_of(text, size); }), HasSubstr("--roi")) << text;
}

TEST_F(MeasuredPart, ARoundViewHasAMiddleAndARadiusInHeights) {
    EXPECT_EQ(round_view_of("100,50,40", size), glm::dvec3(0.5, 0.5, 0.4));
    EXPECT_EQ(round_view_of("0.5,0.5,0.4", size), glm::dvec3(0.5, 0.5, 0.4));
    EXPECT_EQ(round_view_of("0.5,0.5,1.2", size), glm::dvec3(0.5, 0.5, 1.2));
    EXPECT_EQ(round_view_of("0.5,0.5,0.1", size), glm::dvec3(0.5, 0.5, 0.1));
    for (const char* text : {"1,2", "0.5,0.5,0", "0.5,0.5,0.09", "300,50,40", "100,50,900", "x,y,r"})
        EXPECT_THAT(fault_of([&] { round_view_of(text, size); }), HasSubstr("--view")) << text;
}

}  // namespace
}  // namespace lapfx::commands
