// Presets and scenes.
#include <iostream>

#include "commands/inspect.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

void row(const char* name, const std::string& value) {
    std::cout << "  " << name << std::string(20 - std::min<std::size_t>(std::string_view(name).size(), 19), ' ')
              << value << '\n';
}

void show_preset(const Preset& preset) {
    row("format", "lapfx.preset");
    row("name", preset.name);
    row("description", preset.description);
    for (const SmokeClip& clip : preset.smoke.clips)
        row("clip", clip.file + (clip.role == ClipRole::plume ? ", plume" : ", haze"));
}

void show_scene(const Scene& scene) {
    row("format", "lapfx.scene");
    row("name", scene.name);
    row("preset", scene.preset.empty() ? "none" : scene.preset);
    row("organ", scene.organ.file);
    row("tool", scene.tool.file.empty() ? "none" : scene.tool.file);
    row("events", std::to_string(scene.events.size()));
}

}  // namespace

void inspect_document(const std::filesystem::path& file) {
    const CheckedDocument found = check_document(file);  // every fault, before anything is shown
    std::cout << file.string() << ": " << found.kind << '\n';
    if (found.kind == "preset")
        show_preset(load_preset(file));
    else
        show_scene(load_scene(file));
}

}  // namespace lapfx::commands
