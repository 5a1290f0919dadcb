// Pointer and keyboard beyond what a Response says: which node has them, the focus, the cursor, the clipboard, and when
// the next frame is due.
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
    /// Whether a key is down now.
    bool key_down(Key key) const;
    void set_cursor(Cursor cursor) { output_.cursor = cursor; }
    void lock_pointer() { output_.pointer_locked = true; }
    void set_caret(const Rect& caret) { output_.caret = caret; }
    Clipboard* clipboard() const { return options_.clipboard; }
    /// Scrolls every area around the node so that it is seen, from the next build on.
    void reveal(Id id);
    /// Runs the command of the chord, unless a dialog is open. Returns whether there was one.
    bool press_shortcut(Key key, Mods mods);
    /// Asks for another build before this frame is drawn, because nodes built earlier depend on what has just changed.
    void build_again() { again_ = true; }
    /// Files dropped where no node wanted them, one a line; empty: none in this build.
    std::string_view dropped() const { return dropped_; }
    /// The next frame is due then, although nothing may happen. `reason`: a text that lasts, for people who ask why
    /// the program is awake.
    void wake_at(double time, const char* reason);
    /// Shows a text below the node at once, without the pointer's resting there, in place of any tooltip: why what was
    /// done has no effect, or another one. For `seconds`, or 0 for as long as each build says it again.
    void explain(Id of, std::string_view text, double seconds = 0);
    static constexpr double explained_for = 6;  ///< s: what became of an entry that has been left

  protected:
    using Building::Building;
    void send(Id target, const Event& event);
};

}  // namespace lapfx::ui
