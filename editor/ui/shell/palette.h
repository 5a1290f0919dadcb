// The palette: finds a command by a few letters and runs it.
//
//     commands.add({.id = "view.palette", .title = "Command palette", .chord = {key_of('P'), Mods::command},
//                   .run = [&] { ui::open_palette(ui); }});
//     ...
//     ui::palette(u, commands);  // once a frame
//
// Other things that one goes to by name may be listed with them:
//
//     ui::palette(u, commands, rows, [&](std::size_t row) { show(row); });
#pragma once

#include "ui/shell/commands.h"

namespace lapfx::ui {

/// Something that is found beside the commands, once a text is typed.
struct PaletteItem {
    std::string title{};  ///< "Bleeding: Speed"
    std::string note{};   ///< at the end of its line
    std::string words{};  ///< found when each word that was typed is somewhere in them; its title among them
    std::string tip{};
    Icon icon = Icon::none;
};

void open_palette(Ui& ui);

/// While it is open: a field and what matches it, the best first; with nothing typed, what was run from it before comes
/// first. The first that can run is chosen; Up and Down choose, Enter or a click runs, Esc or a press outside closes.
/// Commands that are disabled are seen, and stay. An item is chosen when all is closed and the keyboard is back where
/// it was. Returns whether a command ran or an item was chosen.
bool palette(Ui& ui, CommandTable& table, std::span<const PaletteItem> items = {},
             const std::function<void(std::size_t)>& choose = {});

}  // namespace lapfx::ui
