#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void snapshots_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "snapshots_panel");
}

void add_snapshot_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
