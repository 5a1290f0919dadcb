// What a render writes of each frame where that is more than the frame: a page that the frame is on. Given to a
// RenderJob (render_job.h).
#pragma once

#include <glm/glm.hpp>

#include "lapfx/organ.h"

namespace lapfx::output {

/// Render thread, context current.
class FramePage {
  public:
    virtual ~FramePage() = default;
    /// px, the same for all pages of a render; even, as a video needs it.
    virtual glm::ivec2 size() const = 0;
    /// The page of the scene's time, s. It holds until the next call. Throws Error (runtime).
    virtual const Image& page(double time, const Image& frame) = 0;
};

}  // namespace lapfx::output
