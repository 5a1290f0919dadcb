#include "match/frame/blood_strokes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lapfx/error.h"

namespace lapfx::match {
namespace {

using testing::HasSubstr;

constexpr glm::ivec2 size(200, 100);
const std::string blood = R"({"time": 1.5, "marks": "blood", "radius": 4, "points": [[20, 10], [100, 50]]})";

std::string file_of(const std::string& strokes, const std::string& more = "") {
    return R"({"format": "lapfx.blood_strokes", "version": 1, )" + more + R"("strokes": [)" + strokes + "]}";
}

std::string fault_of(const std::string& text) {
    try {
        read_blood_strokes(text, "s.json", size);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_EQ(error.faults().size(), 1U);
        return error.what();
    }
    return "no fault";
}

TEST(BloodStrokes, AFileIsInPixelsOrInFractions) {
    const BloodStrokes pixels =
        read_blood_strokes(file_of(blood + R"(, {"time": 2, "marks": "other", "radius": 2, "points": [[1, 0]]})",
                                   "\"without_blood\": 0.25,"),
                           "s.json", size);
    EXPECT_EQ(pixels.file, "s.json");
    EXPECT_EQ(pixels.without_blood, 0.25);
    ASSERT_EQ(pixels.strokes.size(), 2U);
    EXPECT_EQ(pixels.strokes[0].time, 1.5);
    EXPECT_EQ(pixels.strokes[0].marks, StrokeMark::blood);
    EXPECT_EQ(pixels.strokes[0].radius, 0.02);
    EXPECT_EQ(pixels.strokes[0].points, (std::vector<PicturePlace>{{0.1, 0.1}, {0.5, 0.5}}));
    EXPECT_EQ(pixels.strokes[1].marks, StrokeMark::other);
    EXPECT_EQ(pixels.strokes[1].points[0], (PicturePlace{0.005, 0.0})) << "pixels, because the other has pixels";
    const BloodStrokes fractions = read_blood_strokes(
        file_of(R"({"time": 1.5, "marks": "blood", "radius": 0.02, "points": [[0.1, 0.1], [0.5, 0.5]]})"), "s.json",
        size);
    EXPECT_EQ(fractions.strokes[0].points, pixels.strokes[0].points);
    EXPECT_EQ(fractions.strokes[0].radius, 0.02);
    EXPECT_FALSE(fractions.without_blood);
}

TEST(BloodStrokes, AreWrittenAsTheyAreRead) {
    BloodStrokes given{.file = "s.json",
                       .without_blood = 0.4,
                       .strokes = {{.time = 1.521, .radius = 0.0125, .points = {{0.1, 0.25}, {0.5, 1.0}}},
                                   {.time = 0.1, .marks = StrokeMark::other, .points = {}},
                                   {.time = 2.0, .marks = StrokeMark::other, .radius = 0.2, .points = {{0.0, 0.0}}}}};
    const BloodStrokes read = read_blood_strokes(write_blood_strokes(given), "t.json", size);
    EXPECT_EQ(read.without_blood, 0.4);
    given.strokes.erase(given.strokes.begin() + 1);  // without points it is nothing
    ASSERT_EQ(read.strokes.size(), given.strokes.size());
    for (std::size_t i = 0; i < read.strokes.size(); ++i) {
        EXPECT_EQ(read.strokes[i].time, given.strokes[i].time);
        EXPECT_EQ(read.strokes[i].marks, given.strokes[i].marks);
        EXPECT_EQ(read.strokes[i].radius, given.strokes[i].radius);
        EXPECT_EQ(read.strokes[i].points, given.strokes[i].points);
    }
    given.without_blood.reset();
    EXPECT_FALSE(read_blood_strokes(write_blood_strokes(given), "t.json", size).without_blood);
}

TEST(BloodStrokes, WhatIsWrongIsToldWithItsPlaceAndWhatIsAllowed) {
    const auto stroke = [](const std::string& from, const std::string& to) {
        std::string changed = blood;
        return file_of(changed.replace(changed.find(from), from.size(), to));
    };
    const std::pair<std::string, std::string> cases[] = {
        {"{", "s.json: line 1: is no JSON"},
        {"{\"format\": \"lapfx.blood_strokes\",\n \"version\": }", "s.json: line 2: is no JSON"},
        {std::string(100'000, '[') + std::string(100'000, ']'), "s.json: is nested deeper than 32 levels"},
        {file_of("{\"" + std::string(5000, 'x') + "\": 1}"),
         "/strokes/0/" + std::string(40, 'x') + "...: unknown key (allowed: time, marks, radius, points)"},
        {file_of("{\"" + std::string(39, 'x') + "\u00e4\": 1}"), std::string(39, 'x') + "...: unknown key"},
        {"[]", "s.json: is no JSON object with \"format\": \"lapfx.blood_strokes\""},
        {"{}", "s.json: /format: missing; expected \"lapfx.blood_strokes\""},
        {R"({"format": "lapfx.scene", "version": 1})", R"(/format: "lapfx.scene" is not "lapfx.blood_strokes")"},
        {R"({"format": "lapfx.blood_strokes"})", "/version: missing; expected 1"},
        {R"({"format": "lapfx.blood_strokes", "version": 2})", "/version: 2 is not 1"},
        {R"({"format": "lapfx.blood_strokes", "version": 1})", "/strokes: missing"},
        {file_of(blood, "\"strokes_of\": 1, "),
         "/strokes_of: unknown key (allowed: format, version, without_blood, strokes)"},
        {file_of(blood, "\"without_blood\": -1, "), "/without_blood: -1 is outside the allowed 0 to 86400"},
        {file_of(blood, "\"without_blood\": \"0\", "), "/without_blood: \"0\" is not a number"},
        {file_of(blood, "\"version\": 1, "), "the key \"version\" is there twice"},
        {file_of(""), "/strokes: has 0 (allowed: 1 to 500)"},
        {file_of("3"), "/strokes/0: 3 is not an object"},
        {stroke("\"time\": 1.5", "\"times\": 1.5"),
         "/strokes/0/times: unknown key (allowed: time, marks, radius, points)"},
        {stroke("\"time\": 1.5, ", ""), "/strokes/0/time: missing"},
        {stroke("1.5", "1e999"), "has a number that is too large"},
        {stroke("\"blood\"", "\"bleed\""), "/strokes/0/marks: \"bleed\" is not \"blood\" or \"other\""},
        {stroke("\"blood\"", "\"other\""), "/strokes: no stroke marks blood"},
        {stroke("\"radius\": 4", "\"radius\": 0"), "/strokes/0/radius: 0 is not above 0"},
        {stroke("\"radius\": 4", "\"radius\": 51"), "/strokes/0/radius: 51 is outside the allowed 0 to 50"},
        {file_of(blood + R"(, {"time": 1, "marks": "other", "radius": 4, "points": []})"),
         "/strokes/1/points: has 0 (allowed: 1 to 2000)"},
        {stroke("[20, 10]", "[20, 10, 3]"), "/strokes/0/points/0: [20,10,3] is not [x,y]"},
        {stroke("[100, 50]", "[100, \"x\"]"), "/strokes/0/points/1: [100,\"x\"] is not [x,y]"},
        {stroke("[100, 50]", "[100, 101]"), "/strokes/0/points/1: [100,101] is not inside the picture of 200x100"},
        {stroke("[20, 10]", "[-1, 10]"), "/strokes/0/points/0: [-1,10] is not inside the picture of 200x100"}};
    for (const auto& [text, told] : cases) EXPECT_THAT(fault_of(text), HasSubstr(told)) << text;
}

TEST(BloodStrokes, HaveABoundedNumberOfPointsTogether) {
    const auto of = [](int strokes, int points_each) {
        std::string points, all;
        for (int i = 0; i < points_each; ++i) points += i > 0 ? ",[9,9]" : "[9,9]";
        for (int i = 0; i < strokes; ++i)
            all += (i > 0 ? "," : "") + (R"({"time": 1, "marks": "blood", "radius": 4, "points": [)" + points + "]}");
        return file_of(all);
    };
    EXPECT_EQ(read_blood_strokes(of(10, 2000), "s.json", size).strokes.size(), 10U);
    EXPECT_EQ(fault_of(of(11, 1900)), "s.json: /strokes: have 20900 points together (allowed: up to 20000)");
}

BloodStroke stroke_at(StrokeMark marks, double radius, std::vector<PicturePlace> points) {
    return {.time = 0.0, .marks = marks, .radius = radius, .points = std::move(points)};
}

TEST(BloodStrokes, MarkWhatIsWithinTheirRadiusAndTheLaterOneCounts) {
    const cv::Mat view(50, 100, CV_8U, cv::Scalar(255));
    const BloodStrokes strokes{.file = "s.json",
                               .without_blood = {},
                               .strokes = {stroke_at(StrokeMark::blood, 0.1, {{0.5, 0.5}}),
                                           stroke_at(StrokeMark::other, 0.02, {{0.2, 0.5}, {0.8, 0.5}}),
                                           stroke_at(StrokeMark::blood, 1e-6, {{1.0, 1.0}})}};
    const std::vector<std::size_t> first{0}, all{0, 1, 2};
    const cv::Mat disc = marks_of(strokes, first, view), both = marks_of(strokes, all, view);
    EXPECT_NEAR(cv::countNonZero(disc), 3.14159 * 10 * 10, 8);
    EXPECT_EQ(disc.at<std::uint8_t>(25, 50), 1);
    EXPECT_EQ(disc.at<std::uint8_t>(25, 61), 0);
    EXPECT_EQ(both.at<std::uint8_t>(25, 50), 2) << "painted over";
    EXPECT_EQ(both.at<std::uint8_t>(20, 50), 1);
    EXPECT_EQ(both.at<std::uint8_t>(24, 25), 2);
    EXPECT_EQ(both.at<std::uint8_t>(28, 25), 0);
    EXPECT_EQ(both.at<std::uint8_t>(49, 99), 1) << "the thinnest brush has the pixel below it";
}

TEST(BloodStrokes, OutsideOfTheViewAreAFault) {
    cv::Mat view(50, 100, CV_8U, cv::Scalar(255));
    view.colRange(0, 50) = 0;
    const BloodStrokes strokes{
        .file = "s.json",
        .without_blood = {},
        .strokes = {stroke_at(StrokeMark::blood, 0.1, {{0.5, 0.5}}), stroke_at(StrokeMark::other, 0.1, {{0.2, 0.5}})}};
    EXPECT_NEAR(cv::countNonZero(marks_of(strokes, std::vector<std::size_t>{0}, view)), 157, 6) << "half of it";
    try {
        marks_of(strokes, std::vector<std::size_t>{0, 1}, view);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "s.json: /strokes/1: lies outside of the view that is measured");
    }
}

}  // namespace
}  // namespace lapfx::match
