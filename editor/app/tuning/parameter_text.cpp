#include "app/tuning/parameter_text.h"

#include <nlohmann/json.hpp>

#include "app/tuning/parameters.h"
#include "lapfx/authoring/table_walk.h"
#include "lapfx/preset.h"

namespace lapfx::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest = std::size_t{4} << 20;

[[noreturn]] void fail(std::string place, std::string reason) {
    throw Error(Failure::bad_input, Fault{.file = "clipboard", .place = std::move(place), .reason = std::move(reason)});
}

Json::json_pointer pointer_of(std::string_view group) {
    Json::json_pointer pointer;
    while (!group.empty()) pointer /= std::string(take_part(group));
    return pointer;
}

/// Checks how deep it is nested, before anything recurses over it.
Json parse(std::string_view text) {
    constexpr int deepest = 32;
    if (text.size() > longest) fail("", "more than 4 MiB of text");
    bool too_deep = false;
    const auto watch = [&](int depth, Json::parse_event_t, Json&) {
        too_deep |= depth > deepest;
        return depth <= deepest;
    };
    Json json;
    try {
        json = Json::parse(text, watch);
    } catch (const Json::exception&) {
        fail("", "this is not JSON: copy a group of parameters, or a preset, first");
    }
    if (too_deep) fail("", "more than 32 levels");
    if (!json.is_object()) fail("", "this is not a JSON object: {\"bleeding\": {...}} is allowed");
    return json;
}

/// Merges objects and replaces all other values.
void lay_over(Json& below, const Json& above) {
    for (const auto& [key, value] : above.items()) {
        Json& at = below[key];
        if (at.is_object() && value.is_object()) {
            lay_over(at, value);
        } else {
            at = value;
        }
    }
}

std::string holds(const Json& json) {
    std::string names;
    for (const ParameterGroup& group : parameters().groups()) {
        if (group.key.empty() || !json.contains(pointer_of(group.key))) continue;
        names += (names.empty() ? "" : ", ") + group.key;
    }
    return names.empty() ? "it contains no group of parameters" : "it contains " + names;
}

Json only(const Json& json, std::string_view group) {
    const Json::json_pointer pointer = pointer_of(group);
    if (!json.contains(pointer))
        fail(pointer.to_string(), "\"" + std::string(group) + "\" is not in the text; " + holds(json));
    Json part;
    part[pointer] = json.at(pointer);
    return part;
}

}  // namespace

std::string copy_parameters(const Preset& preset, std::span<const std::string_view> groups) {
    const Json all = Json::parse(write_preset(preset));
    if (groups.empty()) return all.dump(2) + '\n';
    Json part = Json::object();
    for (const std::string_view group : groups) {
        Json taken = all.at(pointer_of(group));
        part[pointer_of(group)] = std::move(taken);
    }
    return part.dump(2) + '\n';
}

Preset paste_parameters(const Preset& preset, std::string_view text, std::string_view group) {
    Json above = parse(text);
    if (!group.empty()) above = only(above, group);
    Json whole = Json::parse(write_preset(preset));
    lay_over(whole, above);
    return parse_preset(whole.dump(), "clipboard", preset.folder);
}

std::string_view meaning_of_zero(const Parameter& row) {
    if (row.unit == "mm per unit of the file") return "automatic";
    if (row.key == "aspect") return "as stored";
    if (row.key == "out") return "the clip's end";
    if (row.key == "baseline") return "suggested";
    if (row.key == "to" && row.kind == Kind::number) return "the end";
    return {};
}

}  // namespace lapfx::app
