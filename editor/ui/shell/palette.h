// The palette: a few letters of any command, Enter, done.
//
//     commands.add({.id = "view.palette", .title = "Command palette", .chord = {key_of('P'), Mods::command},
//                   .run = [&] { ui::open_palette(ui); }});
//     ...
//     ui::palette(u, commands);  // once a frame
#pragma once

#include "ui/shell/commands.h"

namespace lapfx::ui {

void open_palette(Ui& ui);

/// While it is open: a field and what matches it, the best first; with nothing typed, what was run from it before comes first. Up
/// and Down choose, Enter or a click runs, Esc or a press outside closes. Commands that are disabled are seen, and stay. Gives
/// whether a command ran.
bool palette(Ui& ui, CommandTable& table);

}  // namespace lapfx::ui
