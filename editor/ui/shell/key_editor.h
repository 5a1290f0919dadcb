// Keys of commands: the table to change them in, and the sheet that tells them.
#pragma once

#include "ui/shell/commands.h"

namespace lapfx::ui {

/// Every command with its keys, to be placed in a panel; takes the room it is given. A click on the keys, or Enter,
/// waits for a chord: the next one pressed is bound, Esc gives up. A chord that another command has is told, and taken
/// only when asked for. Returns whether a binding changed.
bool key_editor(Ui& ui, CommandTable& table);

/// A part of the sheet that no command has: "Mouse", {"Zoom", "wheel"}.
struct SheetLine {
    std::string_view what, keys;
};
struct SheetPart {
    std::string_view title;
    std::span<const SheetLine> lines;
};

/// Opens the sheet, or closes it when it is open; for a command on F1.
void toggle_cheat_sheet(Ui& ui);
/// While it is open: all commands that have keys, by group, the keys of the UI itself, then `more`. As many columns as
/// the window has room for; it scrolls when they are longer than that. Esc or a press outside closes.
void cheat_sheet(Ui& ui, const CommandTable& table, std::span<const SheetPart> more = {});

}  // namespace lapfx::ui
