#include "ui/value/text_edit.h"

#include <algorithm>
#include <utility>

#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

constexpr std::size_t most_steps = 1000;
constexpr std::size_t most_history_bytes = 4 << 20;

/// What motion by words goes along together.
enum class Class : std::uint8_t { space, word, punctuation };

Class class_of(char32_t c) {
    if (c == ' ' || c == '\t' || c == 0xA0 || (c >= 0x2000 && c <= 0x200A) || c == 0x202F || c == 0x3000)
        return Class::space;
    if (c < 0x80) {
        const bool word = (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z') || c == '_';
        return word ? Class::word : Class::punctuation;
    }
    const bool latin = c >= 0xA1 && c <= 0xBF && c != 0xAA && c != 0xB5 && c != 0xBA;
    const bool general = (c >= 0x2010 && c <= 0x206F) || (c >= 0x3001 && c <= 0x303F);
    return latin || general || c == 0xD7 || c == 0xF7 ? Class::punctuation : Class::word;
}

Class class_after(std::string_view text, std::size_t at) {
    return class_of(decode(text.substr(at)).codepoint);
}
Class class_before(std::string_view text, std::size_t at) {
    return class_after(text, at - previous_character(text, at));
}

/// A place at or before `at` where a character begins for certain: between two of ASCII, or the begin of the text.
std::size_t sure_begin(std::string_view text, std::size_t at) {
    const auto ascii = [&](std::size_t i) { return static_cast<unsigned char>(text[i]) < 0x80; };
    while (at > 0 && !(ascii(at - 1) && ascii(at))) --at;
    return at;
}

/// The ends of the run of characters of class `c` around `at`. Its begin is found forwards from a place before it: a
/// step back in a row of flags would have to count them all.
std::size_t run_begin(std::string_view text, std::size_t at, Class c) {
    constexpr std::size_t stride = 64;  // bytes
    for (std::size_t end = at;;) {
        const std::size_t start = end <= stride ? 0 : sure_begin(text, end - stride);
        std::size_t begin = start;
        for (std::size_t i = start; i < end;) {
            const bool other = class_after(text, i) != c;
            i += next_character(text, i);
            if (other) begin = i;
        }
        if (begin != start || start == 0) return begin;
        end = start;
    }
}
std::size_t run_end(std::string_view text, std::size_t at, Class c) {
    while (at < text.size() && class_after(text, at) == c) at += next_character(text, at);
    return at;
}

/// To the begin of the word, or the run of punctuation, before.
std::size_t word_before(std::string_view text, std::size_t from) {
    const std::size_t at = run_begin(text, from, Class::space);
    return at == 0 ? 0 : run_begin(text, at, class_before(text, at));
}
std::size_t word_after(std::string_view text, std::size_t from) {
    const std::size_t at = run_end(text, from, Class::space);
    return at == text.size() ? at : run_end(text, at, class_after(text, at));
}

std::size_t allowed_before(std::string_view text, std::size_t byte) {
    if (byte >= text.size()) return text.size();
    const std::size_t before = byte - previous_character(text, byte);
    return before + next_character(text, before) == byte ? byte : before;
}
std::size_t allowed_after(std::string_view text, std::size_t byte) {
    const std::size_t before = allowed_before(text, byte);
    return before < byte ? before + next_character(text, before) : before;
}

}  // namespace

TextEdit::TextEdit(std::string text, std::size_t most_bytes) : most_bytes_(most_bytes) {
    reset(std::move(text));
}

std::size_t TextEdit::selection_begin() const {
    return std::min(caret_, anchor_);
}
std::size_t TextEdit::selection_end() const {
    return std::max(caret_, anchor_);
}
std::string_view TextEdit::selected() const {
    return std::string_view(text_).substr(selection_begin(), selection_end() - selection_begin());
}
bool TextEdit::can_undo() const {
    return !undo_.empty();
}
bool TextEdit::can_redo() const {
    return !redo_.empty();
}

bool TextEdit::apply(TextCommand command) {
    using enum TextCommand;
    close_step();
    std::size_t caret = caret_;
    switch (command) {
        case left:
            return move(caret_ == anchor_ ? target(command) : selection_begin(), false);
        case right:
            return move(caret_ == anchor_ ? target(command) : selection_end(), false);
        case select_all:
            return set_selection(0, text_.size());
        case select_none:
            return set_selection(caret_, caret_);
        case select_word:
            return apply_select_word();
        case erase_left:
        case erase_right:
        case erase_word_left:
        case erase_word_right:
            if (caret_ == anchor_) caret = target(command);
            return edit(std::min(caret, anchor_), std::max(caret, anchor_), {}, false);
        case undo:
            return step_back();
        case redo:
            return step_forward();
        default:
            return move(target(command), command >= select_left && command <= select_text_end);
    }
}

/// Selects the word at the caret: of the two characters next to it, the one that belongs to a word, else the one after.
bool TextEdit::apply_select_word() {
    if (text_.empty()) return set_selection(0, 0);
    const bool at_end = caret_ == text_.size();
    Class c = at_end ? class_before(text_, caret_) : class_after(text_, caret_);
    if (caret_ > 0 && class_before(text_, caret_) == Class::word) c = Class::word;
    return set_selection(run_begin(text_, caret_, c), run_end(text_, caret_, c));
}

/// The place at which a motion from the caret ends.
std::size_t TextEdit::target(TextCommand command) const {
    using enum TextCommand;
    switch (command) {
        case left:
        case select_left:
        case erase_left:
            return caret_ - previous_character(text_, caret_);
        case right:
        case select_right:
        case erase_right:
            return caret_ + next_character(text_, caret_);
        case word_left:
        case select_word_left:
        case erase_word_left:
            return word_before(text_, caret_);
        case word_right:
        case select_word_right:
        case erase_word_right:
            return word_after(text_, caret_);
        case text_start:
        case select_text_start:
            return 0;
        case text_end:
        case select_text_end:
            return text_.size();
        default:
            return caret_;
    }
}

bool TextEdit::move(std::size_t to, bool selecting) {
    return set_selection(selecting ? anchor_ : to, to);
}

bool TextEdit::set_selection(std::size_t anchor, std::size_t caret) {
    const bool changed = anchor_ != anchor || caret_ != caret;
    anchor_ = anchor, caret_ = caret;
    return changed;
}

bool TextEdit::insert(std::string_view text) {
    const std::size_t kept = text_.size() - (selection_end() - selection_begin());
    std::string inserted = cleaned(text, most_bytes_ - std::min(most_bytes_, kept));
    if (inserted.empty()) return false;
    const bool typing = decode(inserted).bytes == inserted.size();
    return edit(selection_begin(), selection_end(), std::move(inserted), typing);
}

bool TextEdit::insert(char32_t codepoint) {
    std::string text;
    append(text, codepoint);
    return insert(text);
}

void TextEdit::place(std::size_t byte, bool select) {
    close_step();
    byte = std::min(byte, text_.size());
    const std::size_t before = allowed_before(text_, byte), after = allowed_after(text_, byte);
    move(byte - before <= after - byte ? before : after, select);
}

void TextEdit::replace(std::string text) {
    close_step();
    std::string inserted = cleaned(text, most_bytes_);
    if (inserted == text_) {
        set_selection(text_.size(), text_.size());
    } else {
        edit(0, text_.size(), std::move(inserted), false);
    }
}

void TextEdit::reset(std::string text) {
    text_ = cleaned(text, most_bytes_);
    caret_ = anchor_ = text_.size();
    undo_.clear();
    redo_.clear();
    history_bytes_ = 0;
}

/// The text without control characters and with spaces for line breaks, cut to at most `room` bytes of whole
/// characters.
std::string TextEdit::cleaned(std::string_view text, std::size_t room) const {
    std::string out;
    out.reserve(std::min(text.size(), room + 8));
    for (std::size_t at = 0, bytes = 0; at < text.size() && out.size() <= room; at += bytes) {
        const Decoded d = decode(text.substr(at));
        bytes = d.bytes;
        if (d.codepoint == '\r' && text.substr(at + 1).starts_with('\n')) continue;
        if (d.codepoint == '\r' || d.codepoint == '\n' || d.codepoint == 0x2028 || d.codepoint == 0x2029) {
            out += ' ';
        } else if (d.codepoint == '\t' || (d.codepoint >= 0x20 && (d.codepoint < 0x7F || d.codepoint >= 0xA0))) {
            out.append(text, at, bytes);
        }
    }
    if (out.size() > room) out.resize(allowed_before(out, room));
    return out;
}

/// Every change of the text but undo and redo: `inserted` in place of begin..end, kept as a step.
bool TextEdit::edit(std::size_t begin, std::size_t end, std::string inserted, bool typing) {
    if (begin == end && inserted.empty()) return false;
    for (const Step& step : redo_) history_bytes_ -= step.removed.size() + step.inserted.size();
    redo_.clear();
    history_bytes_ += end - begin + inserted.size();

    const auto goes_on = [&] {
        if (!typing || begin != end || undo_.empty() || !undo_.back().open) return false;
        const Step& last = undo_.back();
        if (last.at + last.inserted.size() != begin) return false;
        return class_after(inserted, 0) == Class::space ||
               class_before(last.inserted, last.inserted.size()) != Class::space;
    };
    if (goes_on()) {
        undo_.back().inserted += inserted;
    } else {
        close_step();
        undo_.push_back({begin, text_.substr(begin, end - begin), inserted, caret_, anchor_, typing});
    }
    while (undo_.size() > 1 && (undo_.size() > most_steps || history_bytes_ > most_history_bytes)) {
        history_bytes_ -= undo_.front().removed.size() + undo_.front().inserted.size();
        undo_.pop_front();
    }
    text_.replace(begin, end - begin, inserted);
    caret_ = anchor_ = allowed_after(text_, begin + inserted.size());  // what met here may be one character now
    return true;
}

bool TextEdit::step_back() {
    if (undo_.empty()) return false;
    Step step = std::move(undo_.back());
    undo_.pop_back();
    text_.replace(step.at, step.inserted.size(), step.removed);
    caret_ = step.caret, anchor_ = step.anchor;
    redo_.push_back(std::move(step));
    return true;
}

bool TextEdit::step_forward() {
    if (redo_.empty()) return false;
    Step step = std::move(redo_.back());
    redo_.pop_back();
    text_.replace(step.at, step.removed.size(), step.inserted);
    caret_ = anchor_ = allowed_after(text_, step.at + step.inserted.size());
    undo_.push_back(std::move(step));
    return true;
}

void TextEdit::close_step() {
    if (!undo_.empty()) undo_.back().open = false;
}

}  // namespace lapfx::ui
