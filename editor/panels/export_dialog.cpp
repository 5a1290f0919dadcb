#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void export_dialog([[maybe_unused]] ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {}

void add_export_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
