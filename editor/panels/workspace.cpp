#include <algorithm>
#include <array>

#include "app/layouts.h"
#include "app/settings.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/widgets/dock.h"

namespace lapfx::panels {

namespace {

using Build = void (*)(ui::Ui&, app::Editor&);
constexpr std::array<Build, app::panel_names.size()> panel_functions = {
    view_panel,   preset_panel,  clips_panel,   keying_panel,    reference_panel, timeline_panel,
    curves_panel, amounts_panel, presets_panel, snapshots_panel, history_panel,   scene_panel,
};

/// Files that were dropped where no panel takes them.
void bring_dropped(const ui::Ui& ui, app::Editor& editor) {
    if (const std::vector<std::string> files = dropped_files(ui.dropped()); !files.empty()) editor.bring(files);
}

}  // namespace

std::vector<std::string> dropped_files(std::string_view paths) {
    std::vector<std::string> files;
    for (std::size_t from = 0; from < paths.size();) {
        const std::size_t end = std::min(paths.find('\n', from), paths.size());
        if (end > from) files.emplace_back(paths.substr(from, end - from));
        from = end + 1;
    }
    return files;
}

void workspace(ui::Ui& ui, app::Editor& editor) {
    editor.set_ui(ui);
    app::Layouts& layouts = editor.layouts();
    layouts.fit_window(ui.window() / ui.em(1));
    bring_dropped(ui, editor);
    follow_eyedropper(ui, editor);
    ui.set_theme(editor.settings().light ? ui::light_theme() : ui::dark_theme());
    ui.set_reduced_motion(editor.settings().reduced_motion);
    {
        const ui::Column window(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0});
        menu_bar(ui, editor);
        if (!layouts.stacked()) first_hint(ui, editor);
        ui::dock(ui, "Workspace", layouts.shown, app::panel_names,
                 [&](std::size_t panel) { panel_functions[panel](ui, editor); });
        status_bar(ui, editor);
    }
    organ_dialog(ui, editor);
    export_dialog(ui, editor);
    closing_dialog(ui, editor);
    recovery_dialog(ui, editor);
    settings_dialog(ui, editor);
    layout_dialog(ui, editor);
    about_dialog(ui, editor);
    editor.build_file_dialog();
    command_palette(ui, editor);
    keys_sheet(ui, editor);
    editor.toasts.build(ui);
    if (editor.wants_frame()) ui.wake_at(ui.time(), "the preview plays");
    if (const double at = editor.whole_at(); at < ui::never) ui.wake_at(at, "the scene as a whole");
}

}  // namespace lapfx::panels
