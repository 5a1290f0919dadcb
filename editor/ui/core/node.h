// One box of the UI: its place, its id, its drawing and its meaning. A frame is an array of nodes in the order in which
// they were built (parents before children). Layout, hit test, keyboard, tests and dumps all read this array.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "ui/core/node_parts.h"

namespace lapfx::ui {

class Ui;

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
    TypedKeys typed = TypedKeys::all;
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
