// The menu bar: every command by its group, in the order in which they were added.
#include <algorithm>
#include <array>

#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/widgets/menu.h"

namespace lapfx::panels {

namespace {

constexpr std::array<std::string_view, 10> groups = {"File", "Edit", "Preset",    "Smoke",  "Tool",
                                                     "Play", "View", "Reference", "Window", "Help"};
/// Commands that begin another part of their menu.
constexpr std::array<std::string_view, 17> parts = {
    "file.save",        "export.open",        "file.quit",        "edit.history",       "snapshot.show_a",
    "file.load_organ",  "view.endoscope",     "view.vessels",     "view.reload",        "window.palette",
    "measure.run",      "measure.export_csv", "window.show_view", "window.layout_tune", "window.settings",
    "help.first_steps", "help.about",
};

bool begins_part(std::string_view id) {
    return std::find(parts.begin(), parts.end(), id) != parts.end();
}

void items(ui::Ui& ui, ui::CommandTable& commands, app::Settings& settings, app::Files& files, std::string_view group) {
    bool any = false;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (commands[i].group != group) continue;
        if (any && begins_part(commands[i].id)) ui::menu_separator(ui);
        any = true;
        ui::command_item(ui, commands, commands[i].id);
        if (commands[i].id == "file.open") recent_files_menu(ui, settings, files);
    }
}

}  // namespace

void menu_bar(ui::Ui& ui, ui::CommandTable& commands, app::Settings& settings, app::Files& files) {
    const ui::MenuBar bar(ui);
    for (const std::string_view group : groups) {
        bool any = false;
        for (std::size_t i = 0; i < commands.size() && !any; ++i) any = commands[i].group == group;
        if (!any) continue;
        if (const ui::BarMenu menu(ui, group); menu) items(ui, commands, settings, files, group);
    }
}

}  // namespace lapfx::panels
