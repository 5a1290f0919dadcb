// Panels that a person arranges: tabs are dragged onto another group of tabs or to a side of it, edges between groups
// are dragged, panels are closed and, from the menu of any tab, shown again. They never overlap. The program owns the
// arrangement.
//
//     constexpr std::string_view panels[] = {"View", "Parameters", "Scopes"};
//     ui::dock(u, "Workspace", settings.layout, panels, [&](std::size_t panel) { build_panel(u, panel); });
//
// In the tree a tab is "Workspace/tabs/Scopes", a panel "Workspace/Scopes", an edge "Workspace/edge 0" (by the number
// of its node).
#pragma once

#include "ui/widgets/dock_layout.h"
#include "ui/widgets/rows.h"

namespace lapfx::ui {

struct DockOptions {
    bool closable = true;  ///< panels; the last one stays
    float minimum = 6;     ///< em, width and height of a panel, as far as there is room
    float padding = 0.6F;  ///< em inside panels
};

struct DockEvents {
    bool arranged = false;  ///< a panel was moved, closed or brought to the front
    Edit resized;           ///< an edge was dragged
};

/// Fits `layout` to `panels` (names, all different) when it holds others. `build(panel)`: called for those in front,
/// inside a Panel of that name; ids inside do not depend on where it is.
DockEvents dock(Ui& ui, std::string_view label, DockLayout& layout, std::span<const std::string_view> panels,
                const FunctionRef<void(std::size_t)>& build, const DockOptions& options = {});

}  // namespace lapfx::ui
