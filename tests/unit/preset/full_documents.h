// Documents in which every row of their tables is there, and what is wrong with others.
#pragma once

#include <string>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "unit/preset/support.h"

namespace lapfx::test {

inline std::vector<std::string> preset_faults(const std::string& json) {
    return faults_of([&] { parse_preset(json, "p.json"); });
}

inline std::vector<std::string> scene_faults(const std::string& json) {
    return faults_of([&] { parse_scene(json, "s.json"); });
}

/// Calls visit(row, owner, pointer) for every row of a document, lists with their elements.
template <class Visit>
void for_each_row(const Table& table, void* owner, const Visit& visit, const std::string& pointer = "") {
    for (const Parameter& row : table.rows) visit(row, owner, pointer + '/' + std::string(row.key));
    for (const Table& child : table.tables) {
        void* member = child.member(owner);
        const std::string inner = pointer + '/' + std::string(child.key);
        if (!child.list) {
            for_each_row(child, member, visit, inner);
            continue;
        }
        for (std::size_t i = 0; i < child.list->size(member); ++i)
            for_each_row(child, child.list->at(member, i), visit, inner + '/' + std::to_string(i));
    }
}

/// A preset with two clips, so that every row is there.
inline Preset full_preset() {
    Preset preset;
    preset.name = "Full";
    preset.smoke.clips = {{.file = "a.mp4", .own_keying = true}, {.file = "smoke/b.mp4", .own_keying = true}};
    return preset;
}

inline Scene full_scene() {
    Scene scene;
    scene.organ.file = "../organ.ply";
    scene.events = {{}, {.action = ToolAction::tear, .time = 2.0}};
    scene.curves = {.cautery_power = {{1.0, 0.5}}, .bleeding_strength = {{0.5, 2.0}}, .emission = {{3.0, 1.5}}};
    scene.reference.regions = {{.x = 0.1, .y = 0.2, .width = 0.3, .height = 0.4}};
    scene.reference.placement = {.right = 0.25, .up = -0.125, .scale = 1.5, .rotation = -30};
    scene.reference.measure.parts = {{.corners = {{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.3}}}};
    return scene;
}

}  // namespace lapfx::test
