// What is not saved yet, kept in the user's state folder, and offered again after a crash.
#pragma once

namespace lapfx::app {

class Editor;

class Autosave {
  public:
    explicit Autosave(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
