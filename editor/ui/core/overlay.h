// What lies over the window: popups, menus, dialogs, tooltips, toasts. One stack; each has a global name, so that it
// can be opened from anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/core/node_parts.h"

namespace lapfx::ui {

enum class OverlayKind : std::uint8_t {
    popup,    ///< a press outside, or Esc, closes it; takes the keyboard
    submenu,  ///< a popup that closes together with the one it was opened from
    modal,    ///< nothing below can be used; Esc closes it
    passive,  ///< tooltip, toast: never has the keyboard, blocks nothing below but its own place
};

struct Overlay {
    Id key = 0;
    OverlayKind kind = OverlayKind::popup;
    Placement placement;
    Id opener_focus = 0;  ///< gets the keyboard back
    std::uint32_t opened_build = 0, built = 0;
    bool wants_focus = false;  ///< its first node gets the keyboard when it is built
};

}  // namespace lapfx::ui
