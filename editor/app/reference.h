// The surgery video that is to be matched, and how it is compared with the preview.
#pragma once

namespace lapfx::app {

class Editor;

class Reference {
  public:
    explicit Reference(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
