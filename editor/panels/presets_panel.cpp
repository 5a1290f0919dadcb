#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void presets_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "presets_panel");
}

}  // namespace lapfx::panels
