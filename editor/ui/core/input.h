// Pointer and keyboard beyond what Response tells: which node has them, moving the focus, the cursor, the clipboard,
// and when the next frame is due.
#pragma once

#include "ui/core/building.h"

namespace lapfx::ui {

class Input : public Building {
  public:
    Id hot() const { return hot_; }
    Id held(Button button = Button::left) const { return active_[static_cast<int>(button)]; }
    Id focus() const { return focus_; }
    bool focus_ringed() const { return ringed_; }
    void set_focus(Id id, bool by_keyboard = false);
    glm::vec2 pointer() const { return pointer_; }
    bool pointer_inside() const { return pointer_inside_; }
    Mods mods() const { return mods_; }
    /// Whether a key is down now; for a flicker on a held key.
    bool key_down(Key key) const;
    void set_cursor(Cursor cursor) { output_.cursor = cursor; }
    void lock_pointer() { output_.pointer_locked = true; }
    void set_caret(const Rect& caret) { output_.caret = caret; }
    Clipboard* clipboard() const { return options_.clipboard; }
    /// Scrolls every area around it so that it can be seen; from the next build on.
    void reveal(Id id);
    /// Runs what belongs to the chord unless a dialog is in the way; gives whether there was anything.
    bool press_shortcut(Key key, Mods mods);
    /// The program is called once more before this frame is drawn: what was built earlier in it rests on what has
    /// changed since.
    void build_again() { again_ = true; }
    /// Files dropped where no node wanted them, one a line; empty: none in this build.
    std::string_view dropped() const { return dropped_; }
    /// The next frame is due then, although nothing may happen. `reason`: a text that lasts, for people who ask why
    /// the program is awake.
    void wake_at(double time, const char* reason);

  protected:
    using Building::Building;
    void send(Id target, const Event& event);
};

}  // namespace lapfx::ui
