// The schema files in presets/ are made from the tables; here they are compared, and looked at as JSON.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "lapfx/authoring/documents.h"
#include "support/folders.h"
#include "unit/preset/full_documents.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using nlohmann::json;

void expect_current(const std::string& kind, const std::string& schema) {
    const std::string file = "presets/" + kind + ".schema.json";
    EXPECT_TRUE(test::read_text(test::source_folder() / file) == schema)
        << file << " is out of date; renew it with: build/lapfx check --schema " << kind << " > " << file;
}

TEST(Schema, FilesAreCurrent) {
    expect_current("preset", preset_schema());
    expect_current("scene", scene_schema());
}

TEST(Schema, DescribesTheRowsOfAPreset) {
    const json schema = json::parse(preset_schema());
    EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#");
    EXPECT_EQ(schema["required"], json({"format", "version"}));
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_EQ(schema["properties"]["format"]["const"], "lapfx.preset");

    const json& speed = schema["properties"]["bleeding"]["properties"]["speed"];
    EXPECT_EQ(speed["type"], "number");
    EXPECT_EQ(speed["default"], 4);
    EXPECT_EQ(speed["minimum"], 0);
    EXPECT_EQ(speed["maximum"], 60);
    EXPECT_THAT(speed["description"].get<std::string>(), testing::StartsWith("Speed (mm/s). How fast"));

    const json& clips = schema["properties"]["smoke"]["properties"]["clips"];
    EXPECT_EQ(clips["maxItems"], 64);
    EXPECT_EQ(clips["items"]["required"], json({"file"}));
    EXPECT_EQ(clips["items"]["additionalProperties"], false);
    EXPECT_EQ(clips["items"]["properties"]["role"]["enum"], json({"plume", "haze"}));
    EXPECT_EQ(schema["properties"]["vessels"]["additionalProperties"], false);
}

TEST(Schema, SceneNeedsItsOrgan) {
    const json schema = json::parse(scene_schema());
    EXPECT_EQ(schema["required"], json({"format", "version", "organ"}));
    const json& event = schema["properties"]["events"]["items"];
    EXPECT_EQ(event["required"], json({"position"}));
    EXPECT_FALSE(event["properties"]["to"].contains("default"));
}

/// Every key of a written document is in the schema, and nothing else.
void expect_same_keys(const json& schema, const json& document, const std::string& pointer) {
    std::vector<std::string> described, written;
    for (const auto& [key, value] : schema["properties"].items()) described.push_back(key);
    for (const auto& [key, value] : document.items()) written.push_back(key);
    EXPECT_EQ(described, written) << pointer;
    for (const auto& [key, value] : document.items()) {
        const json& inner = schema["properties"][key];
        if (value.is_object()) expect_same_keys(inner, value, pointer + '/' + key);
        if (value.is_array() && !value.empty() && value[0].is_object())
            expect_same_keys(inner["items"], value[0], pointer + '/' + key + "/0");
    }
}

TEST(Schema, HasTheKeysOfTheDocuments) {
    expect_same_keys(json::parse(preset_schema()), json::parse(write_preset(test::full_preset())), "");
    expect_same_keys(json::parse(scene_schema()), json::parse(write_scene(test::full_scene())), "");
}

}  // namespace

}  // namespace lapfx
