// Blood and veil of the reference and of the preview, measured alike, over each other on the scene's time: a part of
// the Amounts panel.
#pragma once

#include "panels/panels.h"

namespace lapfx::panels {

/// What starts and ends the measuring, and the switch of the truth: px of each, 0 where it is not needed now.
inline constexpr std::size_t measured_tools = 4;
float measured_tool_width(ui::Ui& ui, const AmountsParts& parts, std::size_t tool);
void measured_tool(ui::Ui& ui, const AmountsParts& parts, std::size_t tool);
/// What is known and what is on its way. `height`: px, of the panel; in a low one the plots matter more than colours.
void measured_state(ui::Ui& ui, const AmountsParts& parts, float height);
/// Below them, in a room of that size, px. A click goes to that time.
void measured_plots(ui::Ui& ui, const AmountsParts& parts, glm::vec2 room);

}  // namespace lapfx::panels
