// Parts of the window that are no panels, and small things that several panels are made of.
#pragma once

#include "app/editor.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

void menu_bar(ui::Ui& ui, app::Editor& editor);
void status_bar(ui::Ui& ui, app::Editor& editor);
/// Three lines for those who see it for the first time; until they are closed.
void first_hint(ui::Ui& ui, app::Editor& editor);
/// Name for the layout that is kept.
void layout_dialog(ui::Ui& ui, app::Editor& editor);

}  // namespace lapfx::panels
