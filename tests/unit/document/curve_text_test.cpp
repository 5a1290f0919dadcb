#include "document/curve_text.h"

#include <gmock/gmock.h>

namespace lapfx::document {
namespace {

using testing::ElementsAre;
using Points = std::vector<CurvePoint>;

std::vector<std::string> faults_of(std::string_view text, std::string_view key = "emission") {
    try {
        parse_curve_text(text, *curve_table(key));
    } catch (const Error& error) {
        std::vector<std::string> texts;
        for (const Fault& fault : error.faults()) texts.push_back(fault.text());
        return texts;
    }
    return {};
}

TEST(CurveText, GoesThereAndBack) {
    const Points points{{0.0, 1.0}, {2.125, 0.1}, {1e-3 + 3.0, 4.0}};
    EXPECT_EQ(curve_text(points), "0\t1\n2.125\t0.1\n3.001\t4\n");
    EXPECT_EQ(parse_curve_text(curve_text(points), *curve_table("emission")), points);
}

TEST(CurveText, TakesWhatSpreadsheetsAndPeopleWrite) {
    EXPECT_EQ(parse_curve_text("Time,Value\r\n0, 1\r\n\r\n 2.5;0.5\n3 2", *curve_table("emission")),
              (Points{{0.0, 1.0}, {2.5, 0.5}, {3.0, 2.0}}));
}

TEST(CurveText, NamesTheLineOfEachFault) {
    EXPECT_THAT(faults_of("0 1\n2 x1\n3\n1 5\n4 1\n4 2"),
                ElementsAre("line 2: \"2 x1\" is not a time and a value", "line 3: \"3\" is not a time and a value",
                            "line 4: Value: 5 is above the maximum 4 (allowed: 0 to 4)",
                            "line 6: 4 s is not after 4 s, the time of the point before"));
    EXPECT_THAT(faults_of(""), ElementsAre("no points: expected a time and a value in each line"));
    EXPECT_THAT(faults_of("hello"), ElementsAre("line 1: no points: expected a time and a value in each line"));
    EXPECT_THAT(faults_of("0 1.5", "cautery_power"),
                ElementsAre("line 1: Value: 1.5 is above the maximum 1 (allowed: 0 to 1)"));
}

TEST(CurveText, TooManyPointsAreRefused) {
    std::string text;
    for (int i = 0; i < 300; ++i) text += std::to_string(i) + " 1\n";
    EXPECT_THAT(faults_of(text), ElementsAre("line 300: 300 points are more than 256"));
}

TEST(CurveText, ThereIsATableForEachCurveAndNoOther) {
    EXPECT_NE(curve_table("cautery_power"), nullptr);
    EXPECT_EQ(curve_table("speed"), nullptr);
}

}  // namespace
}  // namespace lapfx::document
