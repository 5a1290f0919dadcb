#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void clips_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "clips_panel");
}

void add_clip_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
