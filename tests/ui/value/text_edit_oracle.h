// A second, slow and simple version of TextEdit: a vector of characters, each with its code points, and a history of
// whole snapshots.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "ui/value/text_edit.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

class TextEditOracle {
  public:
    explicit TextEditOracle(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    std::string text() const { return encoded(now_.text); }
    std::size_t caret() const { return encoded(now_.text.substr(0, now_.caret)).size(); }
    std::size_t anchor() const { return encoded(now_.text.substr(0, now_.anchor)).size(); }
    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ < history_.size(); }

    void insert(const std::u32string& raw) {
        std::u32string in;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            char32_t c = raw[i];
            if (c == '\r' && i + 1 < raw.size() && raw[i + 1] == '\n') continue;
            if (c == '\r' || c == '\n') c = ' ';
            if ((c < 0x20 && c != '\t') || (c >= 0x7F && c < 0xA0)) continue;
            in += c;
        }
        const auto [begin, end] = selection();
        const std::size_t kept = encoded(now_.text).size() - encoded(now_.text.substr(begin, end - begin)).size();
        const std::u32string whole = in;
        while (!in.empty() && (encoded(in).size() + kept > most_bytes_ || !boundary(whole, in.size()))) in.pop_back();
        if (in.empty()) return;
        change(begin, end, in, in.size() == 1);
    }

    void place(std::size_t codepoint, bool select) {
        open_ = false;
        move(codepoint, select);
    }

    void apply(TextCommand command) {
        using enum TextCommand;
        open_ = false;
        const auto [begin, end] = selection();
        const std::size_t size = now_.text.size(), caret = now_.caret;
        switch (command) {
            case left:
                return move(begin < end ? begin : before(caret), false);
            case right:
                return move(begin < end ? end : after(caret), false);
            case select_left:
                return move(before(caret), true);
            case select_right:
                return move(after(caret), true);
            case word_left:
                return move(word_before(caret), false);
            case word_right:
                return move(word_after(caret), false);
            case select_word_left:
                return move(word_before(caret), true);
            case select_word_right:
                return move(word_after(caret), true);
            case text_start:
                return move(0, false);
            case text_end:
                return move(size, false);
            case select_text_start:
                return move(0, true);
            case select_text_end:
                return move(size, true);
            case select_all:
                now_.anchor = 0, now_.caret = size;
                return;
            case select_none:
                now_.anchor = caret;
                return;
            case select_word:
                return word();
            case erase_left:
                return erase(begin < end ? begin : before(caret), end);
            case erase_right:
                return erase(begin, begin < end ? end : after(caret));
            case erase_word_left:
                return erase(begin < end ? begin : word_before(caret), end);
            case erase_word_right:
                return erase(begin, begin < end ? end : word_after(caret));
            case undo:
                if (at_ > 0) now_ = history_[--at_].first;
                return;
            case redo:
                if (at_ < history_.size()) now_ = history_[at_++].second;
                return;
        }
    }

  private:
    struct Snapshot {
        std::u32string text;
        std::size_t caret = 0, anchor = 0;
    };

    static std::string encoded(const std::u32string& text) {
        std::string out;
        for (const char32_t c : text) append(out, c);
        return out;
    }
    /// Whether a character begins at `at`. Handles only the code points that the tests use.
    static bool boundary(const std::u32string& text, std::size_t at) {
        if (at == 0 || at >= text.size() || text[at - 1] == '\t') return true;
        const char32_t c = text[at];
        if (c == 0x301 || c == 0xFE0F || c == 0x200D) return false;
        if (text[at - 1] != 0x200D || c != 0x1F469) return true;
        std::size_t tied = at - 1;  // a picture with marks, a joiner and a picture are one character
        while (tied > 0 && (text[tied - 1] == 0x301 || text[tied - 1] == 0xFE0F)) --tied;
        return tied == 0 || text[tied - 1] != 0x1F469;
    }
    static int kind(char32_t c) {
        if (c == ' ' || c == '\t' || c == 0xA0) return 1;
        return std::u32string(U".-+(«").find(c) != std::u32string::npos ? 2 : 3;
    }

    std::pair<std::size_t, std::size_t> selection() const { return std::minmax({now_.caret, now_.anchor}); }
    std::size_t before(std::size_t at) const {
        if (at == 0) return 0;
        do --at;
        while (!boundary(now_.text, at));
        return at;
    }
    std::size_t after(std::size_t at) const {
        if (at == now_.text.size()) return at;
        do ++at;
        while (!boundary(now_.text, at));
        return at;
    }
    int kind_before(std::size_t at) const { return at == 0 ? -1 : kind(now_.text[before(at)]); }
    int kind_after(std::size_t at) const { return at == now_.text.size() ? -1 : kind(now_.text[at]); }
    std::size_t word_before(std::size_t from) const {
        std::size_t at = from;
        while (kind_before(at) == 1) at = before(at);
        const int k = kind_before(at);
        while (k > 0 && kind_before(at) == k) at = before(at);
        return at;
    }
    std::size_t word_after(std::size_t from) const {
        std::size_t at = from;
        while (kind_after(at) == 1) at = after(at);
        const int k = kind_after(at);
        while (k > 0 && kind_after(at) == k) at = after(at);
        return at;
    }
    void word() {
        int k = kind_after(now_.caret);
        if (k <= 0 || (k != 3 && kind_before(now_.caret) == 3)) k = std::max(k, kind_before(now_.caret));
        std::size_t first = now_.caret, last = now_.caret;
        while (k > 0 && kind_before(first) == k) first = before(first);
        while (k > 0 && kind_after(last) == k) last = after(last);
        now_.anchor = first, now_.caret = last;
    }
    void move(std::size_t to, bool select) {
        now_.caret = to;
        if (!select) now_.anchor = to;
    }
    void erase(std::size_t begin, std::size_t end) {
        if (begin < end) change(begin, end, {}, false);
    }
    void change(std::size_t begin, std::size_t end, const std::u32string& in, bool typing) {
        const Snapshot old = now_;
        now_.text = old.text.substr(0, begin) + in + old.text.substr(end);
        now_.caret = begin + in.size();
        while (!boundary(now_.text, now_.caret)) ++now_.caret;
        now_.anchor = now_.caret;
        const bool blank = typing && kind(in[0]) <= 1;
        const bool joins = typing && open_ && begin == end && begin == typed_to_ && (blank || !typed_blank_);
        history_.resize(at_);
        if (joins) {
            history_.back().second = now_;
        } else {
            history_.push_back({old, now_});
            if (history_.size() > 1000) history_.erase(history_.begin());
            at_ = history_.size();
        }
        open_ = typing, typed_to_ = begin + in.size(), typed_blank_ = blank;
    }

    std::size_t most_bytes_;
    Snapshot now_;
    std::vector<std::pair<Snapshot, Snapshot>> history_;
    std::size_t at_ = 0, typed_to_ = 0;
    bool open_ = false, typed_blank_ = false;
};

}  // namespace lapfx::ui
