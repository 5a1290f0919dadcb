// Events: what a person does with mouse and keyboard. The window makes them from its callbacks; tests and scripts make
// their own.
#pragma once

#include <cstdint>
#include <string>

#include "ui/value/geometry.h"

namespace lapfx::ui {

enum class Button : std::uint8_t { left, right, middle };

/// Bits. `command` is the key of shortcuts (Ctrl).
enum class Mods : std::uint8_t { none = 0, shift = 1, command = 2, alt = 4 };
constexpr Mods operator|(Mods a, Mods b) {
    return static_cast<Mods>(static_cast<int>(a) | static_cast<int>(b));
}
constexpr bool has(Mods all, Mods one) {
    return (static_cast<int>(all) & static_cast<int>(one)) != 0;
}

/// Keys by what is written on them; letters and digits are their upper-case ASCII, so key_of('S') is Ctrl+S's.
enum class Key : std::uint16_t {
    none = 0,
    space = ' ',
    // '0' to '9', 'A' to 'Z', and ' , - . / ; = [ ] ` as themselves
    escape = 256,
    enter,
    tab,
    backspace,
    insert,
    del,
    left,
    right,
    up,
    down,
    page_up,
    page_down,
    home,
    end,
    menu,
    f1 = 300,
    f2,
    f3,
    f4,
    f5,
    f6,
    f7,
    f8,
    f9,
    f10,
    f11,
    f12,
};
constexpr Key key_of(char c) {
    return static_cast<Key>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
}
/// Whether it writes a character.
constexpr bool printable(Key key) {
    return key >= Key::space && static_cast<int>(key) < 256;
}

enum class EventKind : std::uint8_t {
    none,
    pointer,  ///< moved to `at`
    press,    ///< `button` at `at`; `clicks` is filled in by the Ui
    release,
    wheel,  ///< `delta`: notches, y up and away from the user is positive
    key,    ///< went down, or repeats
    key_up,
    text,         ///< one code point committed by keyboard or input method
    drop,         ///< files dropped at `at`: `paths`, one a line
    pointer_out,  ///< left the window
    focus_lost,   ///< the window lost the focus: a drag is cancelled

    // Made by the Ui for the widget concerned, never from outside:
    focus_in,  ///< `key` is Key::tab after Tab (Mods::shift: backwards), else Key::none
    focus_out,
    cancel,  ///< a drag is undone: by Esc, by the other button, or because the window lost the focus
};

struct Event {
    EventKind kind = EventKind::none;
    Button button = Button::left;
    Mods mods = Mods::none;
    std::uint8_t clicks = 1;  ///< press: 2 for a double click, 3 for a triple
    Key key = Key::none;
    bool repeat = false;
    char32_t codepoint = 0;
    glm::vec2 at{0};
    glm::vec2 delta{0};
    std::string paths = {};
    double time = 0;  ///< s, never backwards
};

/// The system's clipboard; UTF-8.
class Clipboard {
  public:
    virtual ~Clipboard() = default;
    virtual std::string get() = 0;
    virtual void set(const std::string& text) = 0;
};

}  // namespace lapfx::ui
