// A text while it has the keyboard: keys, typed characters, clipboard, undo and the blinking of the caret.
#pragma once

#include "ui/core/ui.h"
#include "ui/value/text_edit.h"

namespace lapfx::ui {

struct EditingRules {
    std::size_t bytes = 1 << 20;  ///< what would go beyond is cut
    bool read_only = false;       ///< can be selected and copied
    bool keys_outside = false;    ///< Enter, Esc, up, down and the page keys are the caller's
    bool escape_empties = false;
};

/// Kept from frame to frame by the field that it belongs to.
struct Editing {
    TextEdit edit;

    /// The keyboard has come: all is selected, as is usual for Tab.
    void open(Ui& ui, const std::string& text, const EditingRules& rules);
    /// Takes over the program's text if the program has changed it.
    void follow(Ui& ui, const std::string& text);
    /// Handles a key or a typed character and updates `text` and `result`. Returns whether it was used.
    bool take(Ui& ui, const Event& event, std::string& text, Edit& result);
    /// The keyboard has gone: what was typed is committed.
    Edit close();
    /// Replaces the whole text, as one undo step.
    void replace(Ui& ui, std::string_view with, std::string& text, Edit& result);
    /// A press with the left button on `byte`: places the caret; with Shift selects; twice the word, three times all.
    void press(Ui& ui, const Event& event, std::size_t byte);
    /// The menu of a right click or the Menu key. The field `id` builds it last, and keeps its text open for editing
    /// while the menu is open.
    void menu(Ui& ui, Id id, std::string_view label, const Response& response, std::string& text, Edit& result);
    static bool menu_open(Ui& ui, Id id);
    /// Starts the blinking again, so that the caret is visible after every input.
    void touch(Ui& ui) { active_ = ui.time(); }
    /// Whether the caret is drawn now; asks for the frame in which that changes. After ten seconds without input the
    /// caret stays, and the program can sleep.
    bool caret_shown(Ui& ui) const;
    bool began() const { return began_; }

  private:
    void changed(Ui& ui, std::string& text, Edit& result);
    bool take_key(Ui& ui, const Event& event, std::string& text, Edit& result);
    bool take_shortcut(Ui& ui, const Event& event);
    void escape(Ui& ui, std::string& text, Edit& result);

    EditingRules rules_;
    std::string original_;     ///< what Esc goes back to
    std::string given_;        ///< the program's text as it was known last
    std::uint64_t known_ = 0;  ///< hash of the text under edit as the program knows it
    bool began_ = false;
    double active_ = 0;
};

/// px a second that a selection scrolls by when it is dragged so far beyond an edge.
float drag_scroll_speed(const Ui& ui, float beyond);

}  // namespace lapfx::ui
