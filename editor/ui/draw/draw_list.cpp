#include "ui/draw/draw_list.h"

namespace lapfx::ui {

void DrawList::reset(glm::ivec2 frame_size) {
    size = frame_size;
    clears.clear(), instances.clear(), clips.clear(), batches.clear();
    hash = 0;
}

}  // namespace lapfx::ui
