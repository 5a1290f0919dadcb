// Presets and scenes as files that people keep: saved whole, checked, and described by a schema.
//
//     lapfx::save_preset(preset, "tuned.json");               // written beside, then renamed
//     std::cout << lapfx::check_document("some.json").kind;   // throws lapfx::Error: every fault
//
// Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lapfx/scene.h"

namespace lapfx {

struct Preset;

/// Writes a new file next to it, then renames that: there is never half a file, and the old one stays when writing
/// fails. Throws Error: bad_input for values that could not be loaded again, runtime when the file cannot be written (a
/// symbolic link is refused).
void save_preset(const Preset& preset, const std::filesystem::path& path);
void save_scene(const Scene& scene, const std::filesystem::path& path);

/// Draft-07 JSON Schema, from the table.
std::string preset_schema();
std::string scene_schema();

/// What check_document() found.
struct CheckedDocument {
    std::string_view kind;  ///< "preset" or "scene"
    std::string name;
};

/// Validates a preset or a scene, whichever its "format" says. Throws Error (bad_input) listing every fault.
CheckedDocument check_document(const std::filesystem::path& path);

}  // namespace lapfx
