#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void history_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "history_panel");
}

}  // namespace lapfx::panels
