// A tool held on the organ: time runs while it works there, and what it did becomes events of the scene, in one undo
// step.
//
//     if (pressed && hit) editor.hold.begin(editor, hit->position);
//     if (editor.hold.on() && hit) editor.hold.move(editor, hit->position);
//     if (released) editor.hold.end(editor);   // or cancel(): as if nothing had been
//
// UI thread. The editor calls update() once a frame.
#pragma once

#include <glm/glm.hpp>

namespace lapfx::app {

class Editor;

class ToolHold {
  public:
    bool on() const { return on_; }
    /// By the tool in the hand. Nothing happens without one, or where events may not begin any more.
    void begin(Editor& editor, const glm::dvec3& place);
    /// The same, and it ends by itself after `seconds`.
    void begin_for(Editor& editor, const glm::dvec3& place, double seconds);
    void move(Editor& editor, const glm::dvec3& place);
    void end(Editor& editor);
    void cancel(Editor& editor);
    /// `held`: whether a button is still down.
    void update(Editor& editor, bool held);

  private:
    void stop(Editor& editor);

    bool on_ = false;
    double began_ = 0, speed_before_ = 0;
    double until_ = 0;  ///< s; 0: as long as the button is down
    glm::dvec3 place_{0.0};
};

}  // namespace lapfx::app
