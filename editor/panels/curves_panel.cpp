#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void curves_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "curves_panel");
}

}  // namespace lapfx::panels
