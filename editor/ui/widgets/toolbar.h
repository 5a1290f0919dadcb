// Tools side by side. All of them can always be reached: those that do not fit go into a menu, "More...".
//
//     const std::array<ui::ToolItem, 2> items = {{{.width = u.em(8)}, {.width = ui::tool_width(u, "Fit"), .rank = 1}}};
//     ui::toolbar(u, "Tools", width, items, [&](std::size_t item) { item == 0 ? overlay_choice(u) : fit_button(u); });
#pragma once

#include "ui/widgets/rows.h"

namespace lapfx::ui {

struct ToolItem {
    float width = 0;   ///< px, as it is built; 0: it is left out
    int rank = 0;      ///< the highest go into the menu first; of equal ones the last
    bool end = false;  ///< this tool and those after it are at the end of the row
};

/// `room` is the width of the row, px; 0: it is not known yet, and all tools are built in the row. `build(item)` builds
/// a tool in the row, or in the menu while that is open, one below the other. Ids inside differ between the two.
void toolbar(Ui& ui, std::string_view label, float room, std::span<const ToolItem> items,
             const FunctionRef<void(std::size_t)>& build);

/// px of a button with this text.
float tool_width(Ui& ui, std::string_view text, bool icon = false);

}  // namespace lapfx::ui
