// The uniform block LapfxView of shaders/view.glsl: camera and lamp. Render thread, context current.
#pragma once

#include "gl/objects.h"
#include "lapfx/view.h"

namespace lapfx::render {

class ViewBlock {
  public:
    ViewBlock();
    /// Sends it and binds it at 0. `over_plate`: the organ of the frame is a plate.
    void bind(const View& view, bool over_plate = false) const noexcept;

  private:
    gl::Buffer buffer_;
};

}  // namespace lapfx::render
