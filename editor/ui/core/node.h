// One box of the UI: its place, its id, its drawing and its meaning. A frame is an array of nodes in the order in which
// they were built (parents before children). Layout, hit test, keyboard, tests and dumps all read this array.
#pragma once

#include <cstdint>
#include <string_view>

#include "ui/value/geometry.h"
#include "ui/value/id.h"

namespace lapfx::ui {

class Painter;
class Ui;

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
bool arrows_move_focus(Role role);  ///< from one of its children to the next

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
    typing = 1 << 14,    ///< what is typed, Enter
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
struct Node;

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

/// 256 bytes, so that an index is computed by a shift.
struct alignas(64) Node {
    using Draw = void (*)(Painter&, const Node&, const void* arg);
    using HeightForWidth = float (*)(Ui&, const Node&, float width);

    Id id = 0;
    std::uint32_t parent = no_node, first = no_node, last = no_node, next = no_node;
    std::uint32_t end = 0;  ///< one past the last of its descendants

    Size size[2] = {};
    float minimum[2] = {0, 0};  ///< px: never smaller, if it can be helped
    float gap = 0;
    std::uint8_t padding[4] = {};  ///< px: left, top, right, bottom
    Axis axis = Axis::y;
    ChildAlign cross = ChildAlign::stretch, main = ChildAlign::start;
    bool rigid = true;  ///< does not shrink below the size that it asks for
    bool clips = false;
    bool scrolls[2] = {false, false};
    bool placed = false;     ///< out of the flow, by `placement`
    bool overlay = false;    ///< the root of an overlay
    std::uint8_t layer = 0;  ///< 0: the window, then the overlays, in their order
    bool moved = false;      ///< in the last build: its widget is at another index in the present one
    const Placement* placement = nullptr;
    ScrollState* scroll = nullptr;
    HeightForWidth height_for_width = nullptr;

    // made by layout
    std::uint32_t in_flow = 0;  ///< children that are not placed by hand
    bool has_placed = false;
    bool flexible[2] = {false, false};  ///< some of its children grow or are fractions
    bool has_events = false;            ///< events of this build are for it
    float at[2] = {0, 0}, extent[2] = {0, 0}, content[2] = {0, 0};
    Rect clip;

    // meaning, for tests and screen readers
    Role role = Role::none;
    Is is = Is::nothing;
    Sense sense = Sense::none;
    std::string_view label, shown, text, tip;
    const Number* number = nullptr;

    const Drawer* drawer = nullptr;
    Draw draw_over = nullptr;  ///< after its children
    const void* arg = nullptr;
    std::uint32_t first_instance = 0, instances = not_kept;  ///< what it drew, if that can be used again
    static constexpr std::uint32_t not_kept = 0xffffffffU;

    Rect rect() const { return {at[0], at[1], extent[0], extent[1]}; }
    Rect inside() const {
        return {at[0] + padding[0], at[1] + padding[1], std::max(0.0F, extent[0] - padding[0] - padding[2]),
                std::max(0.0F, extent[1] - padding[1] - padding[3])};
    }
    Rect seen() const { return intersect(rect(), clip); }
};
static_assert(sizeof(Node) == 256);

}  // namespace lapfx::ui
