// A line of text that is edited: a string, a caret, a selection, a history. No drawing, no fonts, no events.
//
//     TextEdit edit("speed");
//     edit.apply(TextCommand::select_all);
//     edit.insert("4.5");
//
// Text is UTF-8. Bytes that are not UTF-8 are kept and shown as U+FFFD. Places are byte offsets that never fall inside
// a code point, nor between a letter and the combining marks after it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace lapfx::ui {

enum class TextCommand : std::uint8_t {
    left,
    right,
    word_left,
    word_right,
    text_start,
    text_end,
    select_left,
    select_right,
    select_word_left,
    select_word_right,
    select_text_start,
    select_text_end,
    select_all,
    select_word,
    select_none,
    erase_left,
    erase_right,
    erase_word_left,
    erase_word_right,
    undo,
    redo,
};

class TextEdit {
  public:
    /// What would go beyond `most_bytes` is cut, at a whole character.
    explicit TextEdit(std::string text = {}, std::size_t most_bytes = 1 << 20);

    const std::string& text() const { return text_; }
    std::size_t caret() const { return caret_; }
    std::size_t anchor() const { return anchor_; }  ///< the other end of the selection
    std::size_t selection_begin() const;
    std::size_t selection_end() const;
    std::string_view selected() const;
    bool can_undo() const;
    bool can_redo() const;

    /// Returns whether anything changed, the caret and the selection among it.
    bool apply(TextCommand command);
    /// Replaces the selection. Line breaks become spaces, other control characters except tab are left out. What is
    /// typed is one undo step until the caret is moved, a word ends, or something else happens.
    bool insert(std::string_view text);
    bool insert(char32_t codepoint);
    void place(std::size_t byte, bool select);  ///< the nearest place that is allowed
    void replace(std::string text);             ///< replaces the whole text, as one undo step, caret at the end
    void reset(std::string text);               ///< a new text with no history

  private:
    struct Step {
        std::size_t at = 0;
        std::string removed, inserted;
        std::size_t caret = 0, anchor = 0;  ///< before the step
        bool open = false;                  ///< further typing is added to it
    };

    std::string cleaned(std::string_view text, std::size_t room) const;
    bool apply_select_word();
    std::size_t target(TextCommand command) const;
    bool move(std::size_t to, bool selecting);
    bool set_selection(std::size_t anchor, std::size_t caret);
    bool edit(std::size_t begin, std::size_t end, std::string inserted, bool typing);
    bool step_back();
    bool step_forward();
    void close_step();

    std::string text_;
    std::size_t caret_ = 0, anchor_ = 0;
    std::size_t most_bytes_;
    std::deque<Step> undo_, redo_;
    std::size_t history_bytes_ = 0;  ///< of the strings of both
};

}  // namespace lapfx::ui
