// The preview: what the preset looks like on the organ.
#include "app/orbit.h"
#include "panels/panels.h"
#include "ui/canvas/viewport.h"

namespace lapfx::panels {

void view_panel(ui::Ui& ui, app::Editor& editor) {
    const ui::ViewportResult view = ui::viewport(ui, "Preview", editor.preview.picture());
    if (view.size != editor.preview.size()) {
        editor.preview.resize(view.size);
        ui.build_again();
    }
}

void add_view_commands([[maybe_unused]] app::Editor& editor) {}
void add_tool_commands([[maybe_unused]] app::Editor& editor) {}

}  // namespace lapfx::panels
