// Commands of files, and the menu of those opened last.
#include <filesystem>

#include "app/base/settings.h"
#include "app/editor.h"
#include "app/files/files.h"
#include "panels/panels.h"
#include "ui/widgets/menu.h"

namespace lapfx::panels {

namespace {

using ui::key_of;
using ui::Mods;

}  // namespace

void add_file_commands(app::Editor& editor) {
    const auto add = [&](const char* id, const char* title, ui::Chord chord, const char* tip,
                         std::function<void(app::Files&)> run, ui::Icon icon = ui::Icon::none) {
        editor.commands.add({.id = id,
                             .title = title,
                             .group = "File",
                             .chord = chord,
                             .icon = icon,
                             .run = [&editor, run = std::move(run)] { run(editor.files()); },
                             .tip = tip});
    };
    add(
        "file.new", "New", {key_of('N'), Mods::command},
        "The sample organ with the default preset, without tool events.", [](app::Files& f) { f.make_new(); },
        ui::Icon::file);
    add(
        "file.open", "Open...", {key_of('O'), Mods::command}, "A scene, a preset, an organ or smoke videos.",
        [](app::Files& f) { f.open_dialog(); }, ui::Icon::folder);
    add("file.save", "Save preset", {key_of('S'), Mods::command}, "Writes the preset to its file.",
        [](app::Files& f) { f.save_preset(); });
    add("file.save_as", "Save preset as...", {key_of('S'), Mods::command | Mods::shift},
        "Writes the preset under another name.", [](app::Files& f) { f.save_preset_as(); });
    add("file.save_scene", "Save scene", {key_of('S'), Mods::command | Mods::alt},
        "Writes the scene to its file: organ, camera, light, tool events, reference.",
        [](app::Files& f) { f.save_scene(); });
    add("file.save_scene_as", "Save scene as...", {}, "Writes the scene under another name.",
        [](app::Files& f) { f.save_scene_as(); });
}

void recent_files_menu(ui::Ui& ui, app::Settings& settings, app::Files& files) {
    const ui::Submenu menu(ui, "Open recent", ui::Icon::folder);
    if (!menu) return;
    const std::vector<std::string>& recent = settings.recent;
    if (recent.empty()) ui::menu_item(ui, "Nothing opened yet", {.enabled = false});
    std::string chosen;
    for (std::size_t i = 0; i < recent.size(); ++i) {
        const std::filesystem::path file = recent[i];
        const std::string name = file.filename().string();
        ui.push_seed(i);  // two folders may hold the same name
        if (ui::menu_item(ui, name, {.shortcut = file.parent_path().filename().native(), .tip = recent[i]}))
            chosen = recent[i];
        ui.pop_seed();
    }
    ui::menu_separator(ui);
    if (ui::menu_item(ui, "Clear this list", {.tip = "The files stay.", .enabled = !recent.empty()}))
        settings.recent.clear();
    if (!chosen.empty()) files.bring({chosen});
}

}  // namespace lapfx::panels
