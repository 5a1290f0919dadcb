// Locks, favourites, randomising within locks, and copied groups of parameters.
#pragma once

namespace lapfx::app {

class Editor;

class Tuning {
  public:
    explicit Tuning(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
