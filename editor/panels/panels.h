// The editor's window, put together from panels. Each panel is a function in a file of its own; what panels share is
// the app::Editor.
//
//     panels::add_commands(editor);  // once
//     ui.frame(input, [&](ui::Ui& u) { panels::workspace(u, editor); });
#pragma once

#include "app/editor.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// Every command of the program, with its standard keys.
void add_commands(app::Editor& editor);

/// The whole window: menus, panels as the user arranged them, status bar, dialogs, notices.
void workspace(ui::Ui& ui, app::Editor& editor);

// --- panels, by the names of app::panel_names
// -------------------------------------------------------------------------
void view_panel(ui::Ui& ui, app::Editor& editor);
void preset_panel(ui::Ui& ui, app::Editor& editor);
void clips_panel(ui::Ui& ui, app::Editor& editor);
void keying_panel(ui::Ui& ui, app::Editor& editor);
void reference_panel(ui::Ui& ui, app::Editor& editor);
void timeline_panel(ui::Ui& ui, app::Editor& editor);
void curves_panel(ui::Ui& ui, app::Editor& editor);
void amounts_panel(ui::Ui& ui, app::Editor& editor);
void presets_panel(ui::Ui& ui, app::Editor& editor);
void snapshots_panel(ui::Ui& ui, app::Editor& editor);
void history_panel(ui::Ui& ui, app::Editor& editor);
void scene_panel(ui::Ui& ui, app::Editor& editor);

// --- dialogs: nothing while they are closed
// -----------------------------------------------------------------------------
void organ_dialog(ui::Ui& ui, app::Editor& editor);
void export_dialog(ui::Ui& ui, app::Editor& editor);
void export_status(ui::Ui& ui, app::Editor& editor);  ///< in the status bar, while one runs
void closing_dialog(ui::Ui& ui, app::Editor& editor);
void recovery_dialog(ui::Ui& ui, app::Editor& editor);
void settings_dialog(ui::Ui& ui, app::Editor& editor);

// --- commands
// ------------------------------------------------------------------------------------------------------------
void add_file_commands(app::Editor& editor);
/// In the File menu: the files opened last.
void recent_files_menu(ui::Ui& ui, app::Editor& editor);
void add_edit_commands(app::Editor& editor);
void add_view_commands(app::Editor& editor);
void add_play_commands(app::Editor& editor);
void add_tool_commands(app::Editor& editor);
void add_preset_commands(app::Editor& editor);
void add_clip_commands(app::Editor& editor);
void add_reference_commands(app::Editor& editor);
void add_snapshot_commands(app::Editor& editor);
void add_export_commands(app::Editor& editor);
void add_window_commands(app::Editor& editor);

}  // namespace lapfx::panels
