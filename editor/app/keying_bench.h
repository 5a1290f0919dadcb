// A frame of a clip on its way to smoke: source, matte, keyed, composite; and what of it is counted.
#pragma once

namespace lapfx::app {

class Editor;

class KeyingBench {
  public:
    explicit KeyingBench(Editor& editor) : editor_(editor) {}
    /// Once before each frame. `now`: s.
    void update([[maybe_unused]] double now) {}
    Editor& editor() { return editor_; }

  private:
    Editor& editor_;
};

}  // namespace lapfx::app
