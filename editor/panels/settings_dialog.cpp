#include <array>

#include "app/base/settings.h"
#include "panels/panels.h"
#include "panels/titles.h"
#include "ui/shell/dialog.h"
#include "ui/shell/key_editor.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/tabs.h"

namespace lapfx::panels {

namespace {

struct Size {
    std::string_view title;
    float scale;  ///< 0: as the screen says
};
constexpr Size sizes[] = {{"Screen", 0},   {"75 %", 0.75F},  {"100 %", 1}, {"125 %", 1.25F},
                          {"150 %", 1.5F}, {"175 %", 1.75F}, {"200 %", 2}, {"300 %", 3}};
constexpr auto size_names = titles_of(sizes);

void looks(ui::Ui& ui, app::Settings& settings) {
    const ui::Column column(ui, {.width = ui::grow(), .gap = 0.6F});
    constexpr std::array<std::string_view, 2> themes = {"Dark", "Light"};
    int theme = settings.light ? 1 : 0;
    ui::label(ui, "Theme", {.tone = ui::Tone::dim});
    if (ui::segmented(ui, "Theme##choice", theme, themes).changed) settings.light = theme == 1;
    int chosen = 0;
    for (std::size_t i = 0; i < std::size(sizes); ++i)
        if (sizes[i].scale == settings.scale) chosen = static_cast<int>(i);
    ui::label(ui, "Size of text and controls (Ctrl+= and Ctrl+- change it for this window)",
              {.tone = ui::Tone::dim, .wrap = true});
    if (ui::segmented(ui, "Size", chosen, size_names).changed)
        settings.scale = sizes[static_cast<std::size_t>(chosen)].scale;
    ui::checkbox(ui, "Reduced motion", settings.reduced_motion, "Nothing blinks or moves by itself");
}

}  // namespace

void settings_dialog(ui::Ui& ui, app::Settings& settings, ui::CommandTable& commands) {
    ui::Dialog dialog(ui, "settings", "Settings", {.width = 44, .height = 34, .icon = ui::Icon::gear});
    if (!dialog) return;
    constexpr std::array<std::string_view, 2> pages = {"Appearance", "Keys"};
    {
        int& page = ui.memory<int>(ui.id_of("page"));
        const ui::Tabs tabs(ui, "Pages", page, pages);
        if (page == 0)
            looks(ui, settings);
        else
            ui::key_editor(ui, commands);
    }
    dialog.buttons({{.label = "Close", .standard = true, .cancel = true}});
}

}  // namespace lapfx::panels
