// What a node is described by: its role, what it senses, its states, its size. Apart from the node itself (node.h), so
// that what only calls widgets need not know how a node is laid out.
#pragma once

#include <cstdint>
#include <string_view>

#include "ui/value/geometry.h"
#include "ui/value/id.h"

namespace lapfx::ui {

class Painter;
struct Node;

enum class Role : std::uint8_t {
    none,
    window,
    panel,
    group,
    label,
    heading,
    button,
    toggle,
    checkbox,
    radio,
    combo,
    text_field,
    search_field,
    slider,
    range,
    color,
    section,
    tab_list,
    tab,
    splitter,
    scroll_area,
    scroll_bar,
    list,
    list_item,
    table,
    column_header,
    row,
    cell,
    grid,
    image,
    progress,
    status,
    tooltip,
    menu_bar,
    menu,
    menu_item,
    dialog,
    palette,
    plot,
    curve,
    timeline,
    canvas,
    handle,
    separator,
    link,
};
std::string_view name_of(Role role);
bool arrows_move_focus(Role role);  ///< arrow keys lead from one of its children to the next

/// Which events a node receives. Bits.
enum class Sense : std::uint32_t {
    none = 0,
    hover = 1 << 0,  ///< lights up, has a tooltip
    press = 1 << 1,  ///< left button: pressed, dragged, clicked
    middle = 1 << 2,
    context = 1 << 3,  ///< right button and the Menu key
    focus = 1 << 4,    ///< can have the keyboard
    wheel = 1 << 5,
    command_wheel = 1 << 6,  ///< only with Ctrl, so that scrolling never edits
    drop = 1 << 7,
    // Keys that it receives while it has the keyboard. All other keys run shortcuts or move the focus.
    activate = 1 << 8,  ///< Enter and space: a click
    arrows_x = 1 << 9,
    arrows_y = 1 << 10,
    pages = 1 << 11,
    extremes = 1 << 12,  ///< Home and End, with Ctrl or without
    erase = 1 << 13,     ///< Backspace and Delete
    typing = 1 << 14,    ///< what is typed, Enter; of letters and digits only Node::typed, if it is set
    editing = 1 << 15,   ///< a text is being edited: all keys of a text field, also Esc and Ctrl+Z
    escape = 1 << 16,
    digits = 1 << 17,       ///< typed characters that can begin a number; Enter
    copying = 1 << 18,      ///< Ctrl+C, Ctrl+V, Ctrl+X
    keys = 1 << 19,         ///< every key but Tab, F6 and shortcuts with Ctrl or Alt: a canvas with keys of its own
    focus_wheel = 1 << 20,  ///< the wheel while it has the keyboard, unless something else was scrolled just before
    hover_keys = 1 << 21,   ///< `erase` and `copying` under the pointer as well, unless the focus shows its ring
    tab_keys =
        1 << 22,  ///< Ctrl+PageUp and Ctrl+PageDown, if the node inside it that has the keyboard does not take them
    every_key = 1 << 23,  ///< all of them: a shortcut is being recorded
    completes = 1 << 24,  ///< Tab without Shift: it completes the text that is being typed
    /// Letters and arrows with Ctrl or Alt, and F1 to F12, if the node inside it that has the keyboard does not take
    /// them. For the keys of a dialog.
    chords = 1 << 25,
};
constexpr Sense operator|(Sense a, Sense b) {
    return static_cast<Sense>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Sense operator&(Sense a, Sense b) {
    return static_cast<Sense>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}
constexpr bool has(Sense all, Sense one) {
    return (all & one) != Sense::none;
}

/// The characters that are keys of a node with Sense::typing: all of them where a text is typed; a canvas has a few,
/// and the others stay shortcuts of the program. keys_of() lists them.
enum class TypedKeys : std::uint8_t { all, timeline, plot, curve_point, comparison };

/// The states of a node. Bits.
enum class Is : std::uint16_t {
    nothing = 0,
    disabled = 1 << 0,
    hovered = 1 << 1,
    held = 1 << 2,  ///< the pointer went down on it and is still down
    focused = 1 << 3,
    ringed = 1 << 4,  ///< focused, and the keyboard was used last: shows its ring
    checked = 1 << 5,
    selected = 1 << 6,
    expanded = 1 << 7,
    changed = 1 << 8,  ///< from its default
    locked = 1 << 9,
    invalid = 1 << 10,  ///< what is typed cannot be taken
    read_only = 1 << 11,
    duplicate = 1 << 12,  ///< another widget beside it has the same label: a mistake of the program
    busy = 1 << 13,
    modal = 1 << 14,
};
constexpr Is operator|(Is a, Is b) {
    return static_cast<Is>(static_cast<int>(a) | static_cast<int>(b));
}
constexpr Is& operator|=(Is& a, Is b) {
    return a = a | b;
}
constexpr bool has(Is all, Is one) {
    return (static_cast<int>(all) & static_cast<int>(one)) != 0;
}
constexpr Is when(bool condition, Is state) {
    return condition ? state : Is::nothing;
}

enum class SizeKind : std::uint8_t {
    px,
    fit,       ///< as large as its children need
    grow,      ///< a share of what its siblings leave
    fraction,  ///< of its parent's inside
};
struct Size {
    SizeKind kind = SizeKind::fit;
    float value = 0;  ///< px, weight or fraction
};
constexpr Size px(float v) {
    return {SizeKind::px, v};
}
constexpr Size fit() {
    return {SizeKind::fit, 0};
}
constexpr Size grow(float weight = 1) {
    return {SizeKind::grow, weight};
}
constexpr Size fraction(float f) {
    return {SizeKind::fraction, f};
}

enum class Axis : std::uint8_t { x, y };
/// How children stand across the axis of their parent, and along it where room is left.
enum class ChildAlign : std::uint8_t { start, center, end, stretch };

/// The place of an overlay, or of a child that is placed by hand.
struct Placement {
    enum class Side : std::uint8_t { inside, below, right_of, center, pointer, bottom_right, top } side = Side::inside;
    glm::vec2 fraction{0};  ///< inside: a point of the parent's rectangle; the node's own point `pivot` is put there
    glm::vec2 offset{0};    ///< px
    glm::vec2 pivot{0};     ///< inside: 0 its upper left, 1 its lower right
    Id anchor = 0;          ///< below, right_of: the node it belongs to
    Rect rect{};            ///< of the anchor when it cannot be found; pointer: where
};

/// A value that can be read, compared and set.
struct Number {
    double value = 0, minimum = 0, maximum = 0, step = 0;
};

/// How far an area is scrolled; kept from frame to frame.
struct ScrollState {
    glm::vec2 offset{0};   ///< px
    glm::vec2 content{0};  ///< px, as laid out last
    glm::vec2 view{0};
};

inline constexpr std::uint32_t no_node = 0xffffffffU;

/// How a kind of widget draws itself.
struct Drawer {
    void (*draw)(Painter&, const Node&, const void* look);
    /// Whether two looks give the same picture if their nodes do. Null: unknown, so the widget is drawn in each frame.
    bool (*same)(const void* look, const void* other);
};

}  // namespace lapfx::ui
