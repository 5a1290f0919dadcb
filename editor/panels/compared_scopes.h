// Scopes of the two pictures that are compared, of the same kind beside each other, and figures of their regions.
#pragma once

#include <glm/glm.hpp>

#include "panels/edited.h"

namespace lapfx::app {
class Reference;
}

namespace lapfx::panels {

/// Those of the reference alone where it is shown alone. `room`: px; 0: not known yet.
void compared_scopes(ui::Ui& ui, app::Reference& reference, const Edited& edited, glm::vec2 room);

}  // namespace lapfx::panels
