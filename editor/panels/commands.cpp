// What the program can do that belongs to no single panel: files, undo, the window.
#include "app/editor.h"
#include "app/files/files.h"
#include "app/files/hot_reload.h"
#include "panels/panels.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/palette.h"

namespace lapfx::panels {

namespace {

using ui::Key;
using ui::key_of;
using ui::Mods;

}  // namespace

void add_commands(app::Editor& editor) {
    editor.commands.on_refused = [&editor](const ui::Command& command) {
        if (!command.missing.empty()) editor.toasts.add({.text = command.title + ": " + command.missing});
    };
    add_file_commands(editor);
    add_edit_commands(editor);
    add_play_commands(editor);
    add_tool_commands(editor);
    add_view_commands(editor);
    add_preset_commands(editor);
    add_clip_commands(editor);
    add_reference_commands(editor);
    add_measure_commands(editor);
    add_fit_commands(editor);
    add_snapshot_commands(editor);
    add_export_commands(editor);
    editor.commands.add({.id = "file.quit",
                         .title = "Quit",
                         .group = "File",
                         .chord = {key_of('Q'), Mods::command},
                         .run = [&editor] { editor.files().close(); },
                         .tip = "Asks first when something is not saved."});
    add_window_commands(editor);
    editor.commands.add({.id = "view.reload",
                         .title = "Reload from disk",
                         .group = "View",
                         .chord = {key_of('R'), Mods::command | Mods::shift},
                         .run =
                             [&editor] {
                                 editor.hot_reload().reload_all();
                                 editor.toasts.add({.text = "What is open was read again; unsaved changes stay"});
                             },
                         .tip = "Reads preset, scene, organ, clips and shaders again"});
}

void add_edit_commands(app::Editor& editor) {
    editor.commands.add({.id = "edit.undo",
                         .title = "Undo",
                         .group = "Edit",
                         .chord = {key_of('Z'), Mods::command},
                         .run = [&editor] { editor.document.undo(); },
                         .enabled = [&editor] { return editor.document.can_undo(); },
                         .tip = "Undoes the last step; during a drag it goes back to where the drag started",
                         .missing = "nothing was changed"});
    editor.commands.add({.id = "edit.redo",
                         .title = "Redo",
                         .group = "Edit",
                         .chord = {key_of('Z'), Mods::command | Mods::shift},
                         .other = {key_of('Y'), Mods::command},
                         .run = [&editor] { editor.document.redo(); },
                         .enabled = [&editor] { return editor.document.can_redo(); },
                         .tip = "Redoes what was undone last; Ctrl+Y as well",
                         .missing = "nothing was undone"});
}

}  // namespace lapfx::panels
