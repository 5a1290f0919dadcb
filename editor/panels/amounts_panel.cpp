#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void amounts_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "amounts_panel");
}

}  // namespace lapfx::panels
