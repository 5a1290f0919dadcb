// A picture that the program renders at the size of its node, such as a 3D view. What a person does with it is reported
// to the program.
#pragma once

#include "ui/canvas/view.h"

namespace lapfx::ui {

struct ViewportKey {
    Key key = Key::none;
    Mods mods = Mods::none;
    bool repeat = false;
};

struct ViewportResult {
    glm::ivec2 size{0};  ///< px: what the picture is to be rendered at; known in the frame that lays it out
    bool hovered = false, focused = false;
    glm::vec2 pointer{0};  ///< px from the upper left
    bool pressed = false, released = false, cancelled = false;
    std::uint8_t clicks = 0;  ///< of `pressed`
    bool clicked = false;     ///< left, let go within a few px of where it went down
    bool context = false;     ///< the same of the right button, or the Menu key: a menu is wanted
    bool dragging = false;    ///< a button is down
    Button button = Button::left;
    glm::vec2 pressed_at{0};  ///< px from the upper left
    glm::vec2 drag{0};        ///< px since the last build, of `button`
    float wheel = 0;          ///< notches
    Mods mods = Mods::none;
    std::span<const ViewportKey> keys =
        {};  ///< that went down while it had the keyboard, Esc among them; of this build
};

/// Takes every plain key while it has the keyboard, but Tab and F6. `image` 0: nothing to show yet.
ViewportResult viewport(Ui& ui, std::string_view label, ImageHandle image, std::string_view tip = {},
                        Size width = grow(), Size height = grow());

}  // namespace lapfx::ui
