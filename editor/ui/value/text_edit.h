// Editing text as a pure thing: a string, a caret, a selection, a history. No drawing, no fonts, no events of a widget.
//
//     TextEdit edit("speed");
//     edit.apply(TextCommand::select_all);
//     edit.insert("4.5");
//
// Text is UTF-8. What comes in with bytes that are no UTF-8 has each shown as U+FFFD but kept as it is. Places are byte
// offsets that never fall inside a code point, nor between a letter and the combining marks after it.
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
    line_start,
    line_end,
    text_start,
    text_end,
    up,
    down,
    page_up,
    page_down,
    select_left,
    select_right,
    select_word_left,
    select_word_right,
    select_line_start,
    select_line_end,
    select_text_start,
    select_text_end,
    select_up,
    select_down,
    select_all,
    select_word,
    select_line,
    select_none,
    erase_left,
    erase_right,
    erase_word_left,
    erase_word_right,
    erase_line,
    undo,
    redo,
};

struct TextLimits {
    std::size_t bytes = 1 << 20;  ///< what would go beyond is cut, at a whole character
    bool lines = false;           ///< false: line breaks that come in become spaces
};

class TextEdit {
  public:
    explicit TextEdit(std::string text = {}, const TextLimits& limits = {});

    const std::string& text() const { return text_; }
    std::size_t caret() const { return caret_; }
    std::size_t anchor() const { return anchor_; }  ///< the other end of the selection
    std::size_t selection_begin() const;
    std::size_t selection_end() const;
    std::string_view selected() const;
    bool can_undo() const;
    bool can_redo() const;

    /// Gives whether anything changed, the caret and the selection among it.
    bool apply(TextCommand command);
    /// In place of the selection. Control characters but tab and line break are left out. Typing goes on in one undo
    /// step until the caret is moved, a word ends, or something else happens.
    bool insert(std::string_view text);
    bool insert(char32_t codepoint);
    void place(std::size_t byte, bool select);  ///< the nearest place that is allowed
    void replace(std::string text);             ///< all of it, as one undo step, caret at the end
    void reset(std::string text);               ///< a new text with no history
    int page_lines = 10;                        ///< what page_up and page_down go by

  private:
    struct Step {
        std::size_t at = 0;
        std::string removed, inserted;
        std::size_t caret = 0, anchor = 0;  ///< before
        bool open = false;                  ///< typing may go on in it
    };
    static constexpr std::size_t no_column = static_cast<std::size_t>(-1);

    std::string cleaned(std::string_view text, std::size_t room) const;
    bool apply_select_word();
    bool apply_erase_line();
    std::size_t target(TextCommand command) const;
    std::size_t vertical_target(TextCommand command);
    bool move(std::size_t to, bool selecting);
    bool set_selection(std::size_t anchor, std::size_t caret);
    bool edit(std::size_t begin, std::size_t end, std::string inserted, bool typing);
    bool step_back();
    bool step_forward();
    void close_step();

    std::string text_;
    std::size_t caret_ = 0, anchor_ = 0;
    std::size_t column_ = no_column;  ///< that up and down keep to, in characters
    TextLimits limits_;
    std::deque<Step> undo_, redo_;
    std::size_t history_bytes_ = 0;  ///< of the strings of both
};

}  // namespace lapfx::ui
