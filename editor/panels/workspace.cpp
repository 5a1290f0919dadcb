#include <array>

#include "app/layouts.h"
#include "app/settings.h"
#include "panels/panels.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/menu.h"
#include "ui/shell/palette.h"
#include "ui/shell/status_bar.h"
#include "ui/widgets/dock.h"

namespace lapfx::panels {

namespace {

using Build = void (*)(ui::Ui&, app::Editor&);
constexpr std::array<Build, app::panel_names.size()> panel_functions = {
    view_panel,   preset_panel,  clips_panel,   keying_panel,    reference_panel, timeline_panel,
    curves_panel, amounts_panel, presets_panel, snapshots_panel, history_panel,   scene_panel,
};

void menus(ui::Ui& ui, app::Editor& editor) {
    const ui::MenuBar bar(ui);
    for (const std::string_view group :
         {"File", "Edit", "Play", "Tool", "View", "Preset", "Clip", "Reference", "Window", "Help"}) {
        bool any = false;
        for (std::size_t i = 0; i < editor.commands.size(); ++i) any |= editor.commands[i].group == group;
        if (!any) continue;
        const ui::BarMenu menu(ui, group);
        if (!menu) continue;
        for (std::size_t i = 0; i < editor.commands.size(); ++i)
            if (editor.commands[i].group == group) ui::command_item(ui, editor.commands, editor.commands[i].id);
    }
}

void status(ui::Ui& ui, app::Editor& editor) {
    const ui::StatusBar bar(ui);
    ui::status_text(ui, "Document", editor.document.scene().name);
    ui::spacer(ui);
    export_status(ui, editor);
    ui::status_text(ui, "Renderer", editor.options().renderer);
}

}  // namespace

void workspace(ui::Ui& ui, app::Editor& editor) {
    editor.set_ui(ui);
    ui.set_theme(editor.settings().light ? ui::light_theme() : ui::dark_theme());
    ui.set_reduced_motion(editor.settings().reduced_motion);
    {
        const ui::Column window(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0});
        menus(ui, editor);
        ui::dock(ui, "Workspace", editor.layouts().shown, app::panel_names,
                 [&](std::size_t panel) { panel_functions[panel](ui, editor); });
        status(ui, editor);
    }
    organ_dialog(ui, editor);
    export_dialog(ui, editor);
    closing_dialog(ui, editor);
    recovery_dialog(ui, editor);
    settings_dialog(ui, editor);
    editor.build_file_dialog();
    ui::palette(ui, editor.commands);
    ui::cheat_sheet(ui, editor.commands);
    editor.toasts.build(ui);
    if (editor.wants_frame()) ui.wake_at(ui.time(), "the preview plays");
}

}  // namespace lapfx::panels
