#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void timeline_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "timeline_panel");
}

void add_play_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
