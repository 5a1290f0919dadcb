// Presets and scenes.
#include <iostream>
#include <sstream>

#include "commands/inspect.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/error.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

void row(const char* name, const std::string& value) {
    std::cout << "  " << name << std::string(20 - std::min<std::size_t>(std::string_view(name).size(), 19), ' ')
              << printable(value) << '\n';
}

void show_preset(const Preset& preset) {
    row("format", "lapfx.preset");
    row("name", preset.name);
    row("description", preset.description);
    for (const SmokeClip& clip : preset.smoke.clips) row("clip", clip.file + ", " + std::string(row_of(clip.role).key));
}

/// The name in the scene, and a remark if its place is unusual.
std::string whereabouts(const Scene& scene, const std::string& file) {
    if (file.empty()) return "none";
    std::error_code error;
    const std::filesystem::path path = named_path(scene.folder, file, Reach::anywhere);
    if (!std::filesystem::exists(path, error) && file.find('%') == std::string::npos) return file + " (missing)";
    return lies_in(scene.folder, path) ? file : file + " (outside the scene's folder)";
}

std::string reference_of(const Scene& scene) {
    const SceneReference& reference = scene.reference;
    std::string text = whereabouts(scene, reference.file);
    if (reference.file.empty()) return text;
    std::ostringstream more;
    more << ", from " << reference.offset << " s";
    if (reference.aspect > 0) more << ", shown at " << reference.aspect << ":1";
    return text + more.str();
}

void show_scene(const Scene& scene) {
    row("format", "lapfx.scene");
    row("name", scene.name);
    row("preset", whereabouts(scene, scene.preset));
    row("organ", whereabouts(scene, scene.organ.file));
    if (!scene.organ.texture.empty()) row("texture", whereabouts(scene, scene.organ.texture));
    row("tool", whereabouts(scene, scene.tool.file));
    row("reference", reference_of(scene));
    row("events", std::to_string(scene.events.size()));
}

}  // namespace

void inspect_document(const std::filesystem::path& file) {
    const CheckedDocument found = check_document(file);  // every fault, before anything is shown
    std::cout << printable(file.string()) << ": " << found.kind << '\n';
    if (found.kind == "preset")
        show_preset(load_preset(file));
    else
        show_scene(load_scene(file));
}

}  // namespace lapfx::commands
