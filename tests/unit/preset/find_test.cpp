#include <gmock/gmock.h>

#include "lapfx/authoring/table_walk.h"
#include "lapfx/parameter.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using test::faults_of;
using test::full_preset;
using test::full_scene;
using testing::ElementsAre;

TEST(FindParameter, FollowsDotsAndSlashes) {
    Preset preset = full_preset();
    for (const char* key : {"bleeding.speed", "bleeding/speed", "/bleeding/speed", "/bleeding.speed"}) {
        const FoundParameter place = find_parameter(preset_table(), &preset, key);
        EXPECT_EQ(place.pointer, "/bleeding/speed");
        EXPECT_EQ(place.row->key, "speed");
        EXPECT_EQ(place.owner, &preset.bleeding);
    }
    EXPECT_EQ(find_parameter(preset_table(), &preset, "name").pointer, "/name");
    const FoundParameter clip = find_parameter(preset_table(), &preset, "smoke.clips.1.weight");
    EXPECT_EQ(clip.pointer, "/smoke/clips/1/weight");
    EXPECT_EQ(clip.owner, &preset.smoke.clips[1]);
}

TEST(FindParameter, GivesTheValueAtAKeyOfAnyDepth) {
    Preset preset = full_preset();
    preset.bleeding.speed = 4.5;
    preset.smoke.clips[1].weight = 0.25;
    EXPECT_EQ(value_at(preset_table(), &preset, "name"), Value(preset.name));
    EXPECT_EQ(value_at(preset_table(), &preset, "bleeding.speed"), Value(4.5));
    EXPECT_EQ(value_at(preset_table(), &preset, "smoke.clips.1.weight"), Value(0.25));
    EXPECT_THAT(faults_of([&] { (void)value_at(preset_table(), &preset, "speed"); }),
                ElementsAre("speed: no such parameter; nearest is bleeding.speed"));
}

TEST(FindParameter, AKeyIsTakenApartFromItsFront) {
    std::string_view key = "smoke.clips.1";
    EXPECT_EQ(take_part(key), "smoke");
    EXPECT_EQ(take_part(key), "clips");
    EXPECT_EQ(key, "1");
    EXPECT_EQ(take_part(key), "1");
    EXPECT_EQ(key, "");
    EXPECT_EQ(take_part(key), "");
}

TEST(SetParameter, SetsEveryKindFromText) {
    Preset preset = full_preset();
    const auto set = [&](const char* key, const char* value) { set_parameter(preset_table(), &preset, key, value); };
    set("bleeding.speed", "4.5");
    set("bleeding.noise_octaves", "6");
    set("bleeding.color_thin", "#ff0033");
    set("bleeding.color_deep", "0.25, 0,1");
    set("smoke.plume.extinction", "1,2,0.5");
    set("smoke/clips/1/role", "haze");
    set("/smoke/clips/1/file", "c.mp4");
    set("name", "A = b");
    EXPECT_EQ(preset.bleeding.speed, 4.5);
    EXPECT_EQ(preset.bleeding.noise_octaves, 6);
    EXPECT_EQ(preset.bleeding.color_thin, glm::dvec3(1.0, 0.0, 0.2));
    EXPECT_EQ(preset.bleeding.color_deep, glm::dvec3(0.25, 0.0, 1.0));
    EXPECT_EQ(preset.smoke.plume.extinction, glm::dvec3(1.0, 2.0, 0.5));
    EXPECT_EQ(preset.smoke.clips[1].role, ClipRole::haze);
    EXPECT_EQ(preset.smoke.clips[1].file, "c.mp4");
    EXPECT_EQ(preset.name, "A = b");
}

struct BadSet {
    const char* key;
    const char* value;
    const char* fault;
};

TEST(SetParameter, NamesTheFaultAndLeavesTheDocument) {
    const BadSet cases[] = {
        {"bleeding.sped", "3", "bleeding.sped: no such parameter; nearest is bleeding.speed"},
        {"/bleeding/sped", "3", "/bleeding/sped: no such parameter; nearest is bleeding.speed"},
        {"speed", "3", "speed: no such parameter; nearest is bleeding.speed"},
        {"bleeding", "3", "bleeding: no such parameter; nearest is bleeding.speed"},
        {"smoke.clips.0.wieght", "1", "smoke.clips.0.wieght: no such parameter; nearest is smoke.clips.0.weight"},
        {"smoke.clips.2.weight", "1",
         "smoke.clips.2.weight: \"2\" is not the number of an element; clips has elements 0 to 1"},
        {"smoke.clips.-1.weight", "1",
         "smoke.clips.-1.weight: \"-1\" is not the number of an element; clips has elements 0 to 1"},
        {"smoke.clips.99999999999999999999.weight", "1",
         "smoke.clips.99999999999999999999.weight: \"99999999999999999999\" is not the number of an element; clips has "
         "elements 0 "
         "to 1"},
        {"bleeding.speed", "-3", "bleeding.speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)"},
        {"bleeding.speed", "fast", "bleeding.speed: \"fast\" is not a number from 0 to 60 mm/s"},
        {"bleeding.speed", "4 ", "bleeding.speed: \"4 \" is not a number from 0 to 60 mm/s"},
        {"bleeding.speed", "", "bleeding.speed: \"\" is not a number from 0 to 60 mm/s"},
        {"bleeding.speed", "1e999", "bleeding.speed: \"1e999\" is not a number from 0 to 60 mm/s"},
        {"bleeding.speed", "nan", "bleeding.speed: nan is not a finite number (allowed: 0 to 60 mm/s)"},
        {"bleeding.noise_octaves", "2.5", "bleeding.noise_octaves: \"2.5\" is not a whole number from 1 to 6"},
        {"bleeding.color_thin", "#12345g",
         "bleeding.color_thin: \"#12345g\" is not \"#rrggbb\" or [red, green, blue], each 0 to 1"},
        {"smoke.clips.0.role", "plum", "smoke.clips.0.role: \"plum\" is not one of \"plume\", \"haze\""},
        {"smoke.clips.0.file", "http://x/y",
         "smoke.clips.0.file: \"http://x/y\" is a URL or a protocol; expected the name of a file in the "
         "folder of "
         "the preset"},
    };
    for (const BadSet& bad : cases) {
        Preset preset = full_preset();
        const std::string before = write_preset(preset);
        EXPECT_THAT(faults_of([&] { set_parameter(preset_table(), &preset, bad.key, bad.value); }),
                    ElementsAre(bad.fault));
        EXPECT_EQ(write_preset(preset), before);
    }
}

TEST(SetParameter, StrangeKeysAreFaultsToo) {
    for (const std::string& key :
         {std::string(), std::string("."), std::string("/"), std::string("..."), std::string("smoke.clips"),
          std::string("smoke.clips."), std::string("smoke.clips.0"), std::string("name.x"), std::string("\xff\n"),
          std::string(100'000, '.'), std::string(100'000, 'x')}) {
        Preset preset = full_preset();
        EXPECT_EQ(faults_of([&] { set_parameter(preset_table(), &preset, key, "1"); }).size(), 1u) << key.substr(0, 20);
    }
}

TEST(SetParameter, EmptyListSaysSo) {
    Preset preset;
    EXPECT_THAT(faults_of([&] { set_parameter(preset_table(), &preset, "smoke.clips.0.weight", "1"); }),
                ElementsAre("smoke.clips.0.weight: \"0\" is not the number of an element; clips is empty"));
}

TEST(CheckDocumentValues, FindsRangesAndRulesThatSetLeftBroken) {
    Preset preset = full_preset();
    set_parameter(preset_table(), &preset, "smoke.keying.luma_low", "220");
    set_parameter(preset_table(), &preset, "smoke.keying.chroma_low", "10");
    preset.bleeding.speed = -3.0;
    preset.smoke.clips.resize(70, {.file = "a.mp4"});
    std::vector<std::string> lines;
    for (const Fault& fault : check(preset_table(), &preset)) lines.push_back(fault.text());
    EXPECT_THAT(lines, ElementsAre("/bleeding/speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)",
                                   "/smoke/clips: 70 elements; at most 64 are allowed",
                                   "/smoke/keying/luma_low: 220 is not below luma_high (200)",
                                   "/smoke/keying/chroma_low: 10 is above chroma_high (0)"));
    set_parameter(preset_table(), &preset, "smoke.keying.luma_high", "230");
    set_parameter(preset_table(), &preset, "smoke.keying.chroma_high", "10");
    EXPECT_EQ(check(preset_table(), &preset).size(), 2u);
}

TEST(SetParameter, WorksOnScenes) {
    Scene scene = full_scene();
    set_parameter(scene_table(), &scene, "camera.eye", "1,2,3");
    set_parameter(scene_table(), &scene, "events.1.action", "coagulate");
    EXPECT_EQ(scene.camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.events[1].action, ToolAction::coagulate);
}

}  // namespace

}  // namespace lapfx
