// Presets, bundles, pictures and videos that are written out, by the code of `lapfx render`.
#pragma once

namespace lapfx::app {

class Editor;

class Exports {
  public:
    explicit Exports(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
