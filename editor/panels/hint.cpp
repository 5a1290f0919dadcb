#include "app/base/settings.h"
#include "panels/parts.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

void first_hint(ui::Ui& ui, app::Settings& settings, bool playing) {
    if (settings.hint_seen) return;
    const ui::Panel panel(ui, "First steps", {.width = ui::grow(), .padding = 0.5F});
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    {
        const ui::Column lines(ui, {.width = ui::grow(), .gap = 0.1F});
        ui::label(ui,
                  ui.join({"1  Press Space to ", playing ? "stop" : "play",
                           ". Drag any value under Preset: the next frame shows it. Ctrl+Z undoes it."}),
                  {.width = ui::grow()});
        ui::label(ui,
                  "2  Drop an organ, a smoke clip or a surgery video into the window. Press 1 and burn the organ with "
                  "the cautery tool.",
                  {.width = ui::grow()});
        ui::label(
            ui,
            "3  Compare with the video under Reference (Ctrl+3), then export the preset for your simulator (Ctrl+E). "
            "F1 shows all keys.",
            {.width = ui::grow()});
    }
    if (ui::button(ui, "Got it", {.tip = "Hides these lines; Help > First steps shows them again"}))
        settings.hint_seen = true;
}

}  // namespace lapfx::panels
