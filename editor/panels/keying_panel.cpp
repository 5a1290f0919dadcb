#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void keying_panel(ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {
    ui::label(ui, "keying_panel");
}

}  // namespace lapfx::panels
