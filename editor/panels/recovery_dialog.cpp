#include "panels/panels.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void recovery_dialog([[maybe_unused]] ui::Ui& ui, [[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
