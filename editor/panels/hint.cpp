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
        for (const std::string_view line :
             {playing
                  ? std::string_view("1  Space stops. Drag a value under Preset and see it at once; Ctrl+Z undoes it.")
                  : std::string_view("1  Space plays. Drag a value under Preset and see it at once; Ctrl+Z undoes it."),
              std::string_view("2  Drop in an organ, a smoke clip or a surgery video. Key 1: the cautery tool."),
              std::string_view("3  Ctrl+3 compares with the video, Ctrl+E exports the preset, F1 lists all keys.")})
            ui::label(ui, line, {.wrap = true, .width = ui::grow()});
    }
    if (ui::button(ui, "Got it", {.tip = "Hides these lines; Help > First steps shows them again"}))
        settings.hint_seen = true;
}

}  // namespace lapfx::panels
