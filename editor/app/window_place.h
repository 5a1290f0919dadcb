// Where the window was, to open it there again. No window system: screen coordinates, the origin is the desktop's.
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

/// How it fits on the monitors that are there now: on the monitor with most of it, or the first where its own is gone;
/// no larger than that one and wholly on it. `monitors`: without the desktop's bars; none: as it is.
WindowPlace fitted(WindowPlace place, std::span<const ScreenArea> monitors);

}  // namespace lapfx::app
