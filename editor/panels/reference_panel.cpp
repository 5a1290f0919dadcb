#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void reference_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "reference_panel");
}

void add_reference_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
