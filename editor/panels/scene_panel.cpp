#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void scene_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "scene_panel");
}

}  // namespace lapfx::panels
