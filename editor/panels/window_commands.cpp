// The window itself: panels, layouts, themes, settings, help.
#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/editor.h"
#include "lapfx/authoring/letters.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/shell/dialog.h"
#include "ui/shell/key_editor.h"
#include "ui/shell/palette.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

using ui::Key;
using ui::key_of;
using ui::Mods;

void add_layout_commands(app::Editor& editor) {
    char digit = '1';
    for (const std::string& name : editor.layouts().names())
        editor.commands.add({.id = "window.layout_" + lower(name),
                             .title = "Layout: " + name,
                             .group = "Window",
                             .chord = {key_of(digit++), Mods::command},
                             .run = [&editor, name] { editor.layouts().choose(name); },
                             .checked = [&editor, name] { return editor.layouts().name() == name; },
                             .tip = "Arranges the panels for this task"});
    editor.commands.add({.id = "window.reset_layout",
                         .title = "Reset layout",
                         .group = "Window",
                         .run = [&editor] { editor.layouts().reset(); },
                         .tip = "Puts the panels of this layout back to where they were"});
    editor.commands.add({.id = "window.layouts",
                         .title = "Own layouts...",
                         .group = "Window",
                         .run = [&editor] { ui::open_dialog(editor.ui(), "layouts"); },
                         .tip = "Keeps the arrangement of panels under a name, or shows a kept one"});
}

}  // namespace

void add_window_commands(app::Editor& editor) {
    add_panel_commands(editor);
    add_layout_commands(editor);
    editor.commands.add({.id = "window.settings",
                         .title = "Settings...",
                         .group = "Edit",
                         .chord = {key_of(','), Mods::command},
                         .icon = ui::Icon::gear,
                         .run = [&editor] { ui::open_dialog(editor.ui(), "settings"); },
                         .tip = "Theme, size, keys"});
    editor.commands.add({.id = "window.light",
                         .title = "Light theme",
                         .group = "Window",
                         .run = [&editor] { editor.settings().light = !editor.settings().light; },
                         .checked = [&editor] { return editor.settings().light; },
                         .tip = "Bright panels; otherwise dark ones"});
    editor.commands.add({.id = "window.notices",
                         .title = "Go to notices",
                         .group = "Window",
                         .chord = {key_of('N'), Mods::command | Mods::shift},
                         .run = [&editor] { editor.toasts.take_focus(); },
                         .enabled = [&editor] { return editor.toasts.size() > 0; },
                         .tip = "Moves the keyboard to the newest notice, and back when pressed again; Esc closes it",
                         .missing = "there is no notice"});
    editor.commands.add({.id = "window.notice_log",
                         .title = "All notices...",
                         .group = "Window",
                         .run = [&editor] { editor.toasts.open_log(editor.ui()); },
                         .tip = "All notices since the program started, newest first"});
    editor.commands.add({.id = "window.palette",
                         .title = "Command palette",
                         .group = "Window",
                         .chord = {key_of('P'), Mods::command},
                         .run = [&editor] { ui::open_palette(editor.ui()); },
                         .tip = "Finds commands and parameters by their names or everyday words"});
    editor.commands.add({.id = "help.keys",
                         .title = "Keys and mouse",
                         .group = "Help",
                         .chord = {Key::f1, Mods::none},
                         .run = [&editor] { ui::toggle_cheat_sheet(editor.ui()); },
                         .tip = "All commands that have keys, and what the mouse does"});
    editor.commands.add({.id = "help.first_steps",
                         .title = "First steps",
                         .group = "Help",
                         .run = [&editor] { editor.settings().hint_seen = false; },
                         .tip = "Shows the three lines for beginners again"});
    editor.commands.add({.id = "help.about",
                         .title = "About lapfx",
                         .group = "Help",
                         .run = [&editor] { ui::open_dialog(editor.ui(), "about"); },
                         .tip = "Version, graphics, the paper, licences"});
}

void layout_dialog(ui::Ui& ui, app::Layouts& layouts) {
    ui::Dialog dialog(ui, "layouts", "Own layouts", {.width = 26});
    if (!dialog) return;
    std::string& name = ui.memory<std::string>(ui.id_of("new name"));
    ui::text_field(ui, "Name", name,
                   {.placeholder = "Name for the current arrangement of panels",
                    .caption = true,
                    .invalid = layouts.standard(name)});
    if (layouts.standard(name))
        ui::label(ui, ui.join({"\"", name, "\" is a layout of lapfx; choose another name."}),
                  {.tone = ui::Tone::error, .wrap = true});
    for (const ui::NamedLayout& own : std::vector<ui::NamedLayout>(layouts.own())) {
        ui.push_seed(own.name);
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::label(ui, own.name, {.width = ui::grow()});
        if (ui::button(ui, ui.join({"Show##", own.name}))) layouts.choose(own.name), dialog.close();
        if (ui::button(ui, ui.join({"Remove##", own.name}))) layouts.remove(own.name);
        ui.pop_seed();
    }
    const auto pressed =
        dialog.buttons({{.label = "Close", .cancel = true},
                        {.label = "Keep", .standard = true, .enabled = !name.empty() && !layouts.standard(name)}});
    if (pressed == 1) layouts.keep(name), name.clear();
}

}  // namespace lapfx::panels
