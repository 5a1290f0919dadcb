// Four states of the preset, A to D, to go back to and to compare.
#pragma once

namespace lapfx::app {

class Editor;

class Snapshots {
  public:
    explicit Snapshots(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
