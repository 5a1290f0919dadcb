// Written documents read back as the same text and the same values, at both ends of every range.
#include "preset/json_write.h"

#include <gmock/gmock.h>

#include <limits>

#include "preset/text.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::for_each_row;
using test::full_preset;
using test::full_scene;

TEST(WriteJson, LooksLikeThis) {
    preset::JsonWriter out;
    out.open('{');
    out.value("a", "1");
    out.open('{', "empty");
    out.close();
    out.open('[', "list");
    out.open('{');
    out.value("b", "[1, 2, 3]");
    out.close();
    out.close();
    out.close();
    EXPECT_EQ(out.text(), R"({
  "a": 1,
  "empty": {},
  "list": [
    {
      "b": [1, 2, 3]
    }
  ]
}
)");
}

TEST(WriteJson, NumbersAreTheShortestThatReadBack) {
    EXPECT_EQ(preset::number_text(0.1), "0.1");
    EXPECT_EQ(preset::number_text(4.0), "4");
    EXPECT_EQ(preset::number_text(-0.0), "0");
    EXPECT_EQ(preset::number_text(1.0 / 3.0), "0.3333333333333333");
    EXPECT_EQ(preset::number_text(1e22), "1e+22");
}

TEST(WriteJson, StringsAreEscaped) {
    EXPECT_EQ(preset::json_string("a\"b\\c\nd\x7f\xc3\xa4"), "\"a\\\"b\\\\c\\u000ad\\u007f\xc3\xa4\"");
}

TEST(WritePreset, ColoursAreHexWhereThatIsExact) {
    Preset preset;
    preset.bleeding.color_thin = glm::dvec3(0x5d, 0x0f, 0x11) / 255.0;
    preset.bleeding.color_deep = glm::dvec3(0.5, 0.25, 1);
    const std::string text = write_preset(preset);
    EXPECT_NE(text.find("\"color_thin\": \"#5d0f11\","), std::string::npos);
    EXPECT_NE(text.find("\"color_deep\": [0.5, 0.25, 1],"), std::string::npos);
    EXPECT_EQ(parse_preset(text, "p").bleeding.color_thin, preset.bleeding.color_thin);
}

TEST(WritePreset, EveryHexColourReadsBackAsItself) {
    for (int code = 0; code < 256; ++code) {
        Preset preset;
        preset.smoke.haze.color = glm::dvec3(code, 255 - code, 0) / 255.0;
        const std::string text = write_preset(preset);
        EXPECT_NE(text.find("\"color\": \"#"), std::string::npos) << code;
        EXPECT_EQ(parse_preset(text, "p").smoke.haze.color, preset.smoke.haze.color);
    }
}

TEST(WritePreset, NotANumberIsNothingThatCouldBeRead) {
    Preset preset;
    preset.bleeding.speed = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(test::preset_faults(write_preset(preset)).empty());
}

/// The least, the greatest and an awkward value of a row.
std::vector<Value> extremes(const Parameter& row) {
    const double awkward = row.minimum + (row.maximum - row.minimum) / 3.0;
    switch (row.kind) {
        case Kind::number:
            return {row.minimum, row.maximum, awkward};
        case Kind::integer:
            return {static_cast<int>(row.minimum), static_cast<int>(row.maximum)};
        case Kind::choice:
            return {0, static_cast<int>(row.choices.size()) - 1};
        case Kind::boolean:
            return {false, true};
        case Kind::color:
        case Kind::vector:
            return {glm::dvec3(row.minimum), glm::dvec3(row.maximum), glm::dvec3(row.minimum, awkward, row.maximum)};
        case Kind::text:
        case Kind::path:
            return {std::string("ä \"b\" {}.mp4"), std::string(std::size_t(row.maximum), 'x')};
    }
    return {};
}

/// Sets every row of a document to its extremes, one after the other, and hands each document to
/// `expect_same`. Skips what a rule between values forbids and returns where that was.
template <class Document, class ExpectSame>
std::vector<std::string> visit_extremes(const Table& root, const Document& start, const ExpectSame& expect_same) {
    std::vector<std::string> skipped;
    Document document = start;
    for_each_row(root, &document, [&](const Parameter& row, void* owner, const std::string& pointer) {
        SCOPED_TRACE(pointer);
        const Value before = row.get(owner);
        for (const Value& value : extremes(row)) {
            ASSERT_EQ(row.check(value), "");
            row.set(owner, value);
            EXPECT_EQ(row.get(owner), value);
            if (check(root, &document).empty())
                expect_same(document, pointer, value);
            else
                skipped.push_back(pointer);
        }
        row.set(owner, before);
    });
    return skipped;
}

TEST(WritePreset, RoundTripsEveryRowAtItsExtremes) {
    const auto skipped = visit_extremes(preset_table(), full_preset(),
                                        [](const Preset& preset, const std::string& pointer, const Value& value) {
                                            const std::string text = write_preset(preset);
                                            Preset read = parse_preset(text, "p");
                                            EXPECT_EQ(write_preset(read), text);
                                            const FoundParameter place = find_parameter(preset_table(), &read, pointer);
                                            EXPECT_EQ(place.row->get(place.owner), value);
                                        });
    // vessel_low 3 and 1.5, vessel_high 0, fat_low 110, fat_high 0 and 55,
    // luma_low 255, luma_high 0, chroma_low above 0 twice, of the preset and of two clips, cut 37, coagulation above
    // cut twice, char 37
    EXPECT_EQ(skipped.size(), 22U);
}

TEST(WriteScene, RoundTripsEveryRowAtItsExtremes) {
    const auto skipped = visit_extremes(scene_table(), full_scene(),
                                        [](const Scene& scene, const std::string& pointer, const Value& value) {
                                            const std::string text = write_scene(scene);
                                            Scene read = parse_scene(text, "s");
                                            EXPECT_EQ(write_scene(read), text);
                                            const FoundParameter place = find_parameter(scene_table(), &read, pointer);
                                            EXPECT_EQ(place.row->get(place.owner), value);
                                        });
    EXPECT_EQ(skipped, (std::vector<std::string>{"/reference/loop/from", "/reference/loop/to", "/reference/loop/to"}));
}

}  // namespace

}  // namespace lapfx
