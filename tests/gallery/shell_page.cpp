#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"
#include "ui/shell/dialog.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/progress.h"
#include "ui/shell/status_bar.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/text_field.h"

namespace lapfx::gallery {

namespace {

void menus(ui::Ui& ui, State& state) {
    {
        const ui::MenuBar bar(ui);
        if (const ui::BarMenu menu(ui, "File"); menu) {
            ui::command_item(ui, state.commands, "file.new");
            ui::command_item(ui, state.commands, "file.save");
            if (const ui::Submenu more(ui, "Export", ui::Icon::image); more) {
                if (ui::menu_item(ui, "PNG sequence")) state.shell.answer = "PNG";
                if (ui::menu_item(ui, "Video")) state.shell.answer = "video";
            }
            ui::menu_separator(ui);
            ui::command_item(ui, state.commands, "file.close");
        }
        if (const ui::BarMenu menu(ui, "Edit"); menu) ui::command_item(ui, state.commands, "edit.undo");
        if (const ui::BarMenu menu(ui, "View"); menu) {
            ui::command_item(ui, state.commands, "view.light");
            ui::command_item(ui, state.commands, "view.grid");
        }
    }
    const Line line(ui, "from a button");
    const bool clicked = ui::button(ui, "More", {.icon = ui::Icon::menu});
    const ui::Id anchor = ui.last().id;
    if (clicked) ui::open_menu(ui, "more", {.side = ui::Placement::Side::below, .anchor = anchor});
    if (const ui::Menu menu(ui, "more", "More"); menu) {
        if (ui::menu_item(ui, "Duplicate", {.icon = ui::Icon::copy, .shortcut = "Ctrl+D"}))
            state.shell.answer = "twice";
        if (ui::menu_item(ui, "Checked", {.checked = true})) state.shell.answer = "checked";
        ui::menu_item(ui, "Not now", {.tip = "There is nothing to paste", .enabled = false});
    }
    ui::command_button(ui, state.commands, "file.new");
    ui::command_button(ui, state.commands, "edit.undo", true);
    ui::command_button(ui, state.commands, "view.grid");
}

void dialogs(ui::Ui& ui, ShellState& s) {
    const Line line(ui, "dialogs");
    if (ui::button(ui, "New preset")) ui::open_dialog(ui, "new preset");
    if (ui::button(ui, "Delete")) ui::open_dialog(ui, "delete");
    if (ui::button(ui, "Open a file"))
        s.files.open(ui, {.task = ui::FileTask::open_many,
                          .title = "Open clips",
                          .folder = "/clips",
                          .name = {},
                          .filters = {{"Videos", {".mov"}}}});
    if (ui::button(ui, "Palette", {.tip = "Ctrl+P"})) s.wants_palette = true;
    if (ui::button(ui, "Keys", {.tip = "F1"})) s.wants_keys = true;
    ui::label(ui, ui.join({"answered: ", s.answer}), {.tone = ui::Tone::dim});
    if (ui::Dialog dialog(ui, "new preset", "New preset"); dialog) {
        ui::text_field(ui, "Name", s.name, {.caption = true});
        if (dialog.buttons({{.label = "Cancel", .cancel = true},
                            {.label = "Create", .standard = true, .enabled = !s.name.empty()}}) == 1)
            s.answer = "created";
    }
    const auto answer =
        ui::ask(ui, "delete", "Delete the preset?", "brisk bleed is used by two scenes.",
                {{.label = "Delete"}, {.label = "Keep", .standard = true, .cancel = true}}, ui::Tone::warning);
    if (answer) s.answer = *answer == 0 ? "deleted" : "kept";
}

void news(ui::Ui& ui, ShellState& s) {
    const Line line(ui, "toasts");
    if (ui::button(ui, "Info")) s.toasts.add({.text = "240 frames are queued"});
    if (ui::button(ui, "Good")) s.toasts.add({.kind = ui::ToastKind::good, .text = "Exported", .action = "Show"});
    if (ui::button(ui, "Warning")) s.toasts.add({.kind = ui::ToastKind::warning, .text = "The clip has no alpha"});
    if (ui::button(ui, "Error"))
        s.toasts.add({.kind = ui::ToastKind::error, .text = "plume_left.mov: cannot be read: Permission denied"});
    if (ui::button(ui, "Go to them", {.tip = "The keyboard goes to the newest; Esc gives it back"}))
        s.toasts.take_focus();
}

void jobs(ui::Ui& ui, ShellState& s) {
    const Part part(ui, "Progress");
    if (ui::progress(ui, "Rendering", s.done, {.seconds_left = 80, .cancellable = true, .text = "101 of 240 frames"}))
        s.cancelled = true;
    ui::progress(ui, "Done", 1.0);
    ui::progress(ui, "Reading", -1);
    ui.push_disabled(true);
    ui::progress(ui, "Waiting", 0.2, {.cancellable = true});
    ui.pop_disabled();
}

}  // namespace

void shell_page(ui::Ui& ui, State& state) {
    {
        const Part part(ui, "Menus, dialogs, news");
        menus(ui, state);
        dialogs(ui, state.shell);
        news(ui, state.shell);
    }
    jobs(ui, state.shell);
    {
        const Part part(ui, "Key editor");
        const ui::Column room(ui, {.width = ui::grow(), .height = ui::px(ui.em(16))});
        ui::key_editor(ui, state.commands);
    }
    const Part part(ui, "Status bar");
    {
        const ui::StatusBar bar(ui);
        ui::status_text(ui, "Document", "plate_0012.exr, 2048 x 1152");
        ui::status_text(ui, "Warning", "no key colour", {.tone = ui::Tone::warning, .icon = ui::Icon::warning});
        ui::spacer(ui);
        ui::status_text(ui, "Frame time", "8.1 ms", {.number = true, .width = 5});
    }
}

}  // namespace lapfx::gallery
