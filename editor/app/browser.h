// Presets in the folders, with thumbnails that are rendered in the background.
#pragma once

namespace lapfx::app {

class Editor;

class Browser {
  public:
    explicit Browser(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
