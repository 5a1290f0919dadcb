#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/widgets/dock.h"
#include "ui/widgets/param.h"
#include "ui/widgets/section.h"
#include "ui/widgets/splitter.h"
#include "ui/widgets/tabs.h"

namespace lapfx::gallery {

namespace {

void sections(ui::Ui& ui, PanelsState& s) {
    constexpr ui::SectionButton buttons[] = {{ui::Icon::reset, "Reset all"}, {ui::Icon::copy, "Copy"}};
    if (const ui::Section section(ui, "Bleeding", {.changed = 1, .buttons = buttons}); section)
        ui::param(ui, "Speed", s.speed, {.maximum = 60, .step = 0.5, .unit = "mm/s", .standard = 8});
    if (const ui::Section section(ui, "Haze", {.changed = 0}); section)
        ui::param(ui, "Density", s.haze, {.maximum = 1, .step = 0.01, .standard = 0.4});
    if (const ui::Section section(ui, "Folded", {.open = false}); section) ui::label(ui, "What is inside");
}

void tabs(ui::Ui& ui, PanelsState& s) {
    constexpr std::array<std::string_view, 3> names = {"Matte", "Scopes", "Log"};
    constexpr std::array<std::string_view, 12> many = {
        "plume_left.mov", "plume_right.mov", "haze.mov",   "specks.mov",  "fog.mov",     "burst.mov",
        "wisp.mov",       "curtain.mov",     "take 9.mov", "take 10.mov", "take 11.mov", "take 12.mov"};
    {
        const ui::Tabs views(ui, "Views", s.tab, names, {.height = ui::fit()});
        ui::label(ui, ui.join({"The page of ", names[static_cast<std::size_t>(s.tab)]}));
    }
    const ui::Tabs files(ui, "Files", s.many, many, {.height = ui::fit()});
    ui::label(ui, ui.join({"The page of ", many[static_cast<std::size_t>(s.many)]}));
}

void workspace(ui::Ui& ui, PanelsState& s) {
    constexpr std::array<std::string_view, 5> panels = {"View", "Compare", "Parameters", "Scopes", "Log"};
    const ui::Column frame(ui, {.width = ui::grow(), .height = ui::px(ui.em(18))});
    ui::dock(ui, "Workspace", s.layout, panels, [&](std::size_t panel) {
        if (panel == 2) {
            ui::param(ui, "Speed", s.speed, {.maximum = 60, .unit = "mm/s"});
            ui::param(ui, "Haze", s.haze, {.maximum = 1});
        } else {
            ui::label(ui, ui.join({"What ", panels[panel], " shows"}), {.tone = ui::Tone::dim});
        }
    });
}

}  // namespace

void panels_page(ui::Ui& ui, State& state) {
    PanelsState& s = state.panels;
    {
        const Part part(ui, "Splitter, sections, tabs");
        const ui::Column frame(ui, {.width = ui::grow(), .height = ui::px(ui.em(15))});
        ui::Splitter split(ui, "Panes", ui::Axis::x, s.fraction, {.first_minimum = 12, .second_minimum = 12});
        sections(ui, s);
        split.next();
        tabs(ui, s);
    }
    const Part part(ui, "Dock");
    workspace(ui, s);
}

}  // namespace lapfx::gallery
