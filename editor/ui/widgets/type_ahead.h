// Type-ahead: letters typed on a list go to the next item that begins with them. For lists, tables and closed combos.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lapfx::ui {

/// Whether `text` begins with `start`; letters of ASCII in either case.
bool begins_with(std::string_view text, std::string_view start);

/// Kept from frame to frame by the list. Times in s, of the frame.
class TypeAhead {
  public:
    static constexpr double together = 1;  ///< s between letters that are searched as one word
    static constexpr std::size_t longest = 255;

    void add(char32_t letter, double now);
    void clear() { typed_.clear(); }
    /// Whether the next letter belongs to those before: a space is one, then, and selects nothing.
    bool open(double now) const { return !typed_.empty() && now - at_ <= together; }

    /// The next item after `from` that begins with what has been typed, `from` itself among them unless it is one
    /// letter over and over: that goes from one item of this letter to the next. `from` and what is given: `count` for
    /// none.
    template <typename NameOf>
    std::size_t find(std::size_t count, std::size_t from, const NameOf& name_of) const {
        if (typed_.empty()) return count;
        const std::size_t letter = repeated();
        const bool same = letter > 0;
        const std::string_view wanted = same ? std::string_view(typed_).substr(0, letter) : std::string_view(typed_);
        const std::size_t start = from >= count ? 0 : from + (same ? 1 : 0);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = (start + i) % count;
            if (begins_with(name_of(at), wanted)) return at;
        }
        return count;
    }

  private:
    std::size_t repeated() const;  ///< bytes of the letter that was typed over and over; 0: there are several

    std::string typed_;
    double at_ = -1e9;
};

}  // namespace lapfx::ui
