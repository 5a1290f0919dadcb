// The uniform block LapfxView of shaders/view.glsl: camera and lamp. Render thread, context current.
#pragma once

#include "gl/objects.h"
#include "lapfx/view.h"

namespace lapfx::render {

class ViewBlock {
  public:
    ViewBlock();
    void bind(const View& view) const noexcept;  ///< sends it and binds it at 0

  private:
    gl::Buffer buffer_;
};

}  // namespace lapfx::render
