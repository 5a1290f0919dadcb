#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void preset_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "preset_panel");
}

void add_preset_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
