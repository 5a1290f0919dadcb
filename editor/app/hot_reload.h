// What changes on disk while it is open: shaders, clips, textures, organs, presets.
#pragma once

namespace lapfx::app {

class Editor;

class HotReload {
  public:
    explicit HotReload(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
