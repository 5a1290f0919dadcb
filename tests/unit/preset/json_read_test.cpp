// The strict reader: every fault at once, each with its pointer, the value found and the allowed ones.
#include <gmock/gmock.h>

#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::preset_faults;
using test::preset_text;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ReadPreset, EmptyDocumentTakesAllDefaults) {
    const Preset preset = parse_preset(preset_text(), "p.json", "some/folder");
    EXPECT_EQ(write_preset(preset), write_preset(Preset{}));
    EXPECT_EQ(preset.bleeding.speed, 4.0);
    EXPECT_EQ(preset.folder, "some/folder");
}

TEST(ReadPreset, ReadsValuesOfEveryKind) {
    const Preset preset = parse_preset(preset_text(R"(, "name": "\u00d6l", "vessels": {},
        "bleeding": {"speed": 6, "noise_octaves": 2.0, "color_thin": "#FF8000", "color_deep": [0, 0.5, 1]},
        "smoke": {"clips": [{"file": "a.mp4", "role": "haze", "polarity": "dark", "weight": 0.5}]})"),
                                       "p.json");
    EXPECT_EQ(preset.name, "Öl");
    EXPECT_EQ(preset.bleeding.speed, 6.0);
    EXPECT_EQ(preset.bleeding.noise_octaves, 2);
    EXPECT_EQ(preset.bleeding.color_thin, glm::dvec3(1, 128 / 255.0, 0));
    EXPECT_EQ(preset.bleeding.color_deep, glm::dvec3(0, 0.5, 1));
    ASSERT_EQ(preset.smoke.clips.size(), 1u);
    EXPECT_EQ(preset.smoke.clips[0].role, ClipRole::haze);
    EXPECT_EQ(preset.smoke.clips[0].polarity, ClipPolarity::dark);
    EXPECT_EQ(preset.smoke.clips[0].weight, 0.5);
    EXPECT_EQ(preset.smoke.clips[0].speed, 1.0);
}

struct Bad {
    const char* members;
    const char* fault;
};

TEST(ReadPreset, NamesEachFault) {
    const Bad cases[] = {
        {R"(, "bleeding": {"speed": -3})", "/bleeding/speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)"},
        {R"(, "bleeding": {"speed": 60.5})",
         "/bleeding/speed: 60.5 is above the maximum 60 mm/s (allowed: 0 to 60 mm/s)"},
        {R"(, "bleeding": {"speed": "fast"})", "/bleeding/speed: \"fast\" is not a number from 0 to 60 mm/s"},
        {R"(, "bleeding": {"speed": null})", "/bleeding/speed: null is not a number from 0 to 60 mm/s"},
        {R"(, "bleeding": {"speed": true})", "/bleeding/speed: true is not a number from 0 to 60 mm/s"},
        {R"(, "bleeding": {"speed": [1]})", "/bleeding/speed: an array of 1 is not a number from 0 to 60 mm/s"},
        {R"(, "bleeding": {"speed": {}})", "/bleeding/speed: an object is not a number from 0 to 60 mm/s"},
        {R"(, "bleeding": {"sped": 3})", "/bleeding/sped: unknown key; nearest is \"speed\""},
        {R"(, "bleeding": {"noise_octaves": 2.5})", "/bleeding/noise_octaves: 2.5 is not a whole number from 1 to 6"},
        {R"(, "bleeding": {"noise_octaves": 1e300})",
         "/bleeding/noise_octaves: 1e+300 is not a whole number from 1 to 6"},
        {R"(, "bleeding": {"noise_octaves": 7})",
         "/bleeding/noise_octaves: 7 is above the maximum 6 (allowed: 1 to 6)"},
        {R"(, "bleeding": {"color_thin": "red"})",
         "/bleeding/color_thin: \"red\" is not \"#rrggbb\" or [red, green, blue], each 0 to 1"},
        {R"(, "bleeding": {"color_thin": [0, 0]})",
         "/bleeding/color_thin: an array of 2 is not \"#rrggbb\" or [red, green, blue], each 0 to 1"},
        {R"(, "bleeding": {"color_thin": [0, 0, "1"]})",
         "/bleeding/color_thin: an array of 3 is not \"#rrggbb\" or [red, green, blue], each 0 to 1"},
        {R"(, "bleeding": {"color_thin": [0, 1.5, 0]})",
         "/bleeding/color_thin: green = 1.5 is above the maximum 1 (allowed: 0 to 1)"},
        {R"(, "bleeding": [])", "/bleeding: an array of 0 is not an object"},
        {R"(, "bleeding": null)", "/bleeding: null is not an object"},
        {R"(, "bleading": {})", "/bleading: unknown key; nearest is \"bleeding\""},
        {R"(, "vessels": {"x": 1})", "/vessels/x: unknown key; nearest is \"region\""},
        {R"(, "a/b~c": 1)", "/a~1b~0c: unknown key; nearest is \"name\""},
        {R"(, "name": 3)", "/name: 3 is not a string of at most 100 characters"},
        {R"(, "name": "two\nlines")", "/name: \"two\\x0alines\" contains a control character or a line break"},
        {R"(, "name": "a", "name": "b")", "/name: this key is there twice"},
        {R"(, "bleeding": {"speed": 1, "speed": 2})", "/bleeding/speed: this key is there twice"},
        {R"(, "smoke": {"clips": {}})", "/smoke/clips: an object is not an array"},
        {R"(, "smoke": {"clips": [3]})", "/smoke/clips/0: 3 is not an object"},
        {R"(, "smoke": {"clips": [{}]})",
         "/smoke/clips/0/file: missing; expected the name of a file in the folder of the preset"},
        {R"(, "smoke": {"clips": [{"file": ""}]})",
         "/smoke/clips/0/file: empty; expected the name of a file in the folder of the preset"},
        {R"(, "smoke": {"clips": [{"file": "../a.mp4"}]})",
         "/smoke/clips/0/file: \"../a.mp4\" is outside the folder; expected the name of a file in the folder of "
         "the "
         "preset"},
        {R"(, "smoke": {"clips": [{"file": "/a.mp4"}]})",
         "/smoke/clips/0/file: \"/a.mp4\" is an absolute path; expected the name of a file in the folder of "
         "the "
         "preset"},
        {R"(, "smoke": {"clips": [{"file": "concat:a|b"}]})",
         "/smoke/clips/0/file: \"concat:a|b\" is a URL or a protocol; expected the name of a file in the "
         "folder of "
         "the preset"},
        {R"(, "smoke": {"clips": [{"file": "a.mp4", "role": "plum"}]})",
         "/smoke/clips/0/role: \"plum\" is not one of \"plume\", \"haze\"; nearest is \"plume\""},
        {R"(, "smoke": {"clips": [{"file": "a.mp4", "role": 1}]})",
         "/smoke/clips/0/role: 1 is not one of \"plume\", \"haze\""},
        {R"(, "smoke": {"keying": {"luma_low": 210}})", "/smoke/keying/luma_low: 210 is not below luma_high (200)"},
        {R"(, "smoke": {"keying": {"luma_low": 20, "luma_high": 20}})",
         "/smoke/keying/luma_low: 20 is not below luma_high (20)"},
        {R"(, "smoke": {"keying": {"chroma_low": 9, "chroma_high": 8}})",
         "/smoke/keying/chroma_low: 9 is above chroma_high (8)"},
        {R"(, "smoke": {"keying": {"luma_low": 220, "luma_high": 999}})",
         "/smoke/keying/luma_high: 999 is above the maximum 255 levels (allowed: 0 to 255 levels)"},
        {R"(, "cautery": {"coagulation_temperature": 200, "char_temperature": 300})",
         "/cautery/coagulation_temperature: 200 is not below cut_temperature (180)"},
    };
    for (const Bad& bad : cases)
        EXPECT_THAT(preset_faults(preset_text(bad.members)), ElementsAre("p.json: " + std::string(bad.fault)))
            << bad.members;
}

TEST(ReadPreset, NamesFaultsOfFormatAndVersion) {
    EXPECT_THAT(preset_faults("{}"), ElementsAre("p.json: /format: missing; expected \"lapfx.preset\"",
                                                 "p.json: /version: missing; expected a whole number from 1 to 1"));
    EXPECT_THAT(preset_faults(R"({"format": "lapfx.scene", "version": 1, "x": 1})"),
                ElementsAre("p.json: /format: \"lapfx.scene\" is not \"lapfx.preset\""));
    EXPECT_THAT(preset_faults(R"({"format": 1, "version": 1})"),
                ElementsAre("p.json: /format: 1 is not \"lapfx.preset\""));
    EXPECT_THAT(preset_faults(R"({"format": "lapfx.preset", "version": 3, "x": 1})"),
                ElementsAre("p.json: /version: version 3 is newer than this program reads (1)"));
    for (const char* version : {"0", "-1", "1.5", "\"1\"", "null"})
        EXPECT_THAT(preset_faults(R"({"format": "lapfx.preset", "version": )" + std::string(version) + "}"),
                    ElementsAre("p.json: /version: " + std::string(version) + " is not a whole number from 1 to 1"));
    EXPECT_THAT(preset_faults("[]"),
                ElementsAre("p.json: an array of 0; expected an object with \"format\": \"lapfx.preset\""));
    EXPECT_THAT(preset_faults("3"), ElementsAre("p.json: 3; expected an object with \"format\": \"lapfx.preset\""));
}

TEST(ReadPreset, ListsAllFaultsAtOnce) {
    EXPECT_THAT(preset_faults(R"({"version": 1, "naem": "x", "bleeding": {"speed": -1, "gloss": 2, "glos": 1},
                                  "smoke": {"clips": [{"weight": 9}, {"file": "a"}], "haze": 3}})"),
                ElementsAre("p.json: /format: missing; expected \"lapfx.preset\"",
                            "p.json: /naem: unknown key; nearest is \"name\"",
                            "p.json: /bleeding/glos: unknown key; nearest is \"gloss\"",
                            "p.json: /bleeding/speed: -1 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)",
                            "p.json: /bleeding/gloss: 2 is above the maximum 1 (allowed: 0 to 1)",
                            "p.json: /smoke/clips/0/file: missing; expected the name of a file in the folder of "
                            "the preset",
                            "p.json: /smoke/clips/0/weight: 9 is above the maximum 4 (allowed: 0 to 4)",
                            "p.json: /smoke/haze: 3 is not an object"));
}

TEST(ReadPreset, StopsListingAtTwoHundredFaults) {
    std::string members;
    for (int i = 0; i < 90'000; ++i) members += ", \"k" + std::to_string(i) + "\": 0";
    const std::vector<std::string> faults = preset_faults(preset_text(members));
    ASSERT_EQ(faults.size(), 201u);
    EXPECT_EQ(faults.back(), "p.json: more than 200 faults; the rest is not listed");
}

TEST(ReadPreset, ListsHaveALimit) {
    const auto clips = [](int count) {
        std::string list;
        for (int i = 0; i < count; ++i) list += (i ? ", " : "") + std::string(R"({"file": "a.mp4"})");
        return preset_text(R"(, "smoke": {"clips": [)" + list + "]}");
    };
    EXPECT_EQ(parse_preset(clips(64), "p.json").smoke.clips.size(), 64u);
    EXPECT_THAT(preset_faults(clips(65)), ElementsAre("p.json: /smoke/clips: 65 elements; at most 64 are allowed"));
}

TEST(ReadPreset, AnObjectThatMayBeLeftOutIsThereOnlyWhenItIsWritten) {
    const auto clip = [](const std::string& more) {
        return preset_text(R"(, "smoke": {"clips": [{"file": "a.mp4")" + more + "}]}");
    };
    Preset without = parse_preset(clip(""), "p.json");
    EXPECT_FALSE(without.smoke.clips[0].own_keying);
    EXPECT_THAT(write_preset(without), testing::Not(testing::HasSubstr("        \"keying\"")));
    const Preset with = parse_preset(clip(R"(, "keying": {"luma_low": 40})"), "p.json");
    EXPECT_TRUE(with.smoke.clips[0].own_keying);
    EXPECT_EQ(with.smoke.clips[0].keying.luma_low, 40.0);
    EXPECT_EQ(with.smoke.clips[0].keying.luma_high, KeyingParameters{}.luma_high);
    EXPECT_TRUE(parse_preset(write_preset(with), "p.json").smoke.clips[0].own_keying);
    EXPECT_THAT(preset_faults(clip(R"(, "keying": {"luma_low": 300})")),
                ElementsAre(testing::StartsWith("p.json: /smoke/clips/0/keying/luma_low: 300 is above")));

    without.smoke.clips[0].keying.luma_low = -1.0;  // means nothing while the object does not exist
    EXPECT_TRUE(check(preset_table(), &without).empty());
    set_parameter(preset_table(), &without, "smoke.clips.0.keying.luma_low", "17");
    EXPECT_TRUE(without.smoke.clips[0].own_keying);
    EXPECT_EQ(without.smoke.clips[0].keying.luma_low, 17.0);
}

TEST(ReadPreset, HugeKeysAndStringsGiveShortFaults) {
    const std::string huge(1'000'000, 'x');
    const std::vector<std::string> faults =
        preset_faults(preset_text(", \"" + huge + "\": 1, \"name\": \"" + huge + "\", \"bleeding\": \"" + huge + '"'));
    ASSERT_EQ(faults.size(), 3u);
    for (const std::string& line : faults) EXPECT_LT(line.size(), 250u);
}

}  // namespace

}  // namespace lapfx
