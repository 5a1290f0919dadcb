// The place of the window, to open it there again. Independent of the window system: screen coordinates with the
// desktop's origin.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace lapfx::app {

/// A rectangle of the desktop.
struct ScreenArea {
    glm::ivec2 at{0}, size{0};
    friend bool operator==(const ScreenArea&, const ScreenArea&) = default;
};

struct WindowPlace {
    ScreenArea area;         ///< of its content when it is not maximised; no size: nothing is known
    bool maximized = false;  ///< on the monitor on which `area` is
    explicit operator bool() const { return area.size.x > 0 && area.size.y > 0; }
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

inline constexpr glm::ivec2 least_window{320, 240};

/// The place fitted to the present monitors: on the monitor with the largest part of it, or on the first one if its own
/// no longer exists; not larger than that monitor and fully on it. `monitors` are areas without the desktop's bars; if
/// there are none, the place stays as it is.
WindowPlace fitted(WindowPlace place, std::span<const ScreenArea> monitors);

}  // namespace lapfx::app
