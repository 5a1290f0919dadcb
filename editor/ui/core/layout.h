// Layout: turns the sizes that nodes ask for into rectangles, for the whole tree before anything is drawn. So no widget
// is ever drawn in a wrong place.
#pragma once

#include <span>

#include "ui/core/node.h"

namespace lapfx::ui {

/// Fills in at, extent, content and clip of every node, and the state of scroll areas. nodes[0] is the window. Linear
/// in the number of nodes. All rectangles are on whole px. Returns whether a scroll area had to be moved back to its
/// content.
bool lay_out(Ui& ui, std::span<Node> nodes, glm::vec2 window);

}  // namespace lapfx::ui
