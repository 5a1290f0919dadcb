// A colour that a picker wants is taken from the pictures of the view and of the reference panel.
#include "app/base/layouts.h"
#include "panels/parts.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void pick_hint(ui::Ui& ui, ui::Eyedropper& eyedropper) {
    if (eyedropper.wanted_by == 0) return;
    const ui::Panel panel(ui, "Pick a colour", {.width = ui::fit(), .height = ui::fit(), .padding = 0.5F});
    ui.parent().placed = true;
    ui.parent().placement =
        ui.arena().make(ui::Placement{.fraction = {0.5F, 1}, .offset = {0, -ui.em(0.8F)}, .pivot = {0.5F, 1}});
    const ui::Row row(ui, {.cross = ui::ChildAlign::center});
    ui::label(ui, "Click the colour that you want, here or in another picture");
    if (ui::button(ui, "Leave", {.tip = "Leave without picking a colour (Esc)", .quiet = true})) eyedropper = {};
}

void follow_eyedropper(ui::Ui& ui, ui::Eyedropper& eyedropper, app::Layouts& layouts) {
    if (eyedropper.wanted_by == 0) return;
    if (ui.key_down(ui::Key::escape)) {
        eyedropper = {};
        return;
    }
    if (!layouts.seen("View") && !layouts.seen("Reference")) layouts.bring_to_front("View");
}

}  // namespace lapfx::panels
