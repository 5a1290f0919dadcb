// Parts of the window that are no panels, and small things that several panels are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/editor.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// What was dropped, as the UI has it: one a line.
std::vector<std::string> dropped_files(std::string_view paths);
/// Room along a row for something that takes all it gets, such as segmented(); ems: 0 is all that is left.
struct Room : ui::Row {
    Room(ui::Ui& ui, float ems)
        : ui::Row(ui, {.width = ems > 0 ? ui::px(ui.em(ems)) : ui::grow(), .cross = ui::ChildAlign::center}) {}
};

/// The keys of a command as they are bound now: "Ctrl+Z"; empty: it has none.
inline std::string_view chord_of(const app::Editor& editor, std::string_view command) {
    return editor.commands.chord_text(editor.commands.index_of(command));
}

/// While a colour is wanted from a picture: what to do, over those that give one; of the panel's node that it lies in.
void pick_hint(ui::Ui& ui, app::Editor& editor);
/// Esc leaves that; with no such picture in sight the view is shown. Once a frame.
void follow_eyedropper(ui::Ui& ui, app::Editor& editor);

void menu_bar(ui::Ui& ui, app::Editor& editor);
void status_bar(ui::Ui& ui, app::Editor& editor);
/// Three lines for those who see it for the first time; until they are closed.
void first_hint(ui::Ui& ui, app::Editor& editor);
/// Commands and parameters by name: a command runs, a parameter's row comes into sight and has the keyboard.
void command_palette(ui::Ui& ui, app::Editor& editor);
/// All keys, and what the pointer does.
void keys_sheet(ui::Ui& ui, app::Editor& editor);
/// Version, renderer, paper, licences.
void about_dialog(ui::Ui& ui, app::Editor& editor);
/// Name for the layout that is kept.
void layout_dialog(ui::Ui& ui, app::Editor& editor);

}  // namespace lapfx::panels
