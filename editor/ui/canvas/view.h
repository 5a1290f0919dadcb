// How a picture is looked at: which part of it, and how large. Pure arithmetic, and how pointer and keys change it.
// Views of several pictures that share one ViewState move together.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

/// Kept by the program. A new one shows all of the picture.
struct ViewState {
    bool fitted = true;           ///< all of it, as large as it goes; `zoom` and `center` do not count
    double zoom = 1;              ///< px of the screen for one of the picture
    glm::dvec2 center{0.5, 0.5};  ///< fractions of the picture: what lies in the middle of the area
    friend bool operator==(const ViewState&, const ViewState&) = default;
};

inline constexpr double most_zoom = 64;  ///< smaller pictures may be fitted larger
inline constexpr double grid_zoom = 8;   ///< single pixels are shown as such from here on

/// A ViewState at work: a picture of `size` in `area`. The picture's corner lies on a whole px.
struct View {
    Rect area;
    glm::ivec2 size{0};
    double zoom = 1;
    glm::dvec2 corner{0};  ///< px of the screen, upper left of the picture

    Rect rect() const;  ///< of the whole picture, px of the screen
    glm::dvec2 to_screen(glm::dvec2 place) const { return corner + place * zoom; }
    /// Pixels of the picture from its upper left; the middle of the first is 0.5, 0.5.
    glm::dvec2 to_picture(glm::vec2 at) const { return (glm::dvec2(at) - corner) / zoom; }
    glm::ivec2 pixel_at(glm::vec2 at) const { return glm::ivec2(glm::floor(to_picture(at))); }
    bool has_pixel(glm::ivec2 p) const { return p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y; }
    Rect pixel_rect(glm::ivec2 low, glm::ivec2 count) const;  ///< px of the screen
};
/// Sizes below 1 count as 1.
View view_of(const ViewState& state, const Rect& area, glm::ivec2 size);

/// The zoom at which all of it is seen.
double fit_zoom(const Rect& area, glm::ivec2 size);
/// `about`, px of the screen, stays where it is. From a quarter of 1:1 or of fitted, whichever is smaller, to
/// most_zoom.
void set_zoom(ViewState& state, const Rect& area, glm::ivec2 size, double zoom, glm::vec2 about);
/// The next power of two up or down.
void step_zoom(ViewState& state, const Rect& area, glm::ivec2 size, int up, glm::vec2 about);
/// The picture goes along with a drag of so many px; its edges never beyond the middle of the area.
void pan(ViewState& state, const Rect& area, glm::ivec2 size, glm::dvec2 px);
/// Pans as little as is needed for the pixel to be inside `area`.
void show_pixel(ViewState& state, const Rect& area, glm::ivec2 size, glm::ivec2 pixel);

/// The way of a drag, also if several events came in one build. Kept with ui.memory().
struct DragWay {
    bool on = false;
    Button button = Button::left;
    glm::vec2 last{0};
    glm::vec2 take(const Event& event);  ///< px since the event before; also notes press, release and cancel
};

/// What a node that shows a picture must sense for steer(). Escape is left out: it leaves the view.
inline constexpr Sense view_sense = Sense::hover | Sense::press | Sense::middle | Sense::wheel | Sense::focus |
                                    Sense::activate | Sense::digits | Sense::arrows_x | Sense::arrows_y;
/// Wheel: zoom at the pointer, stopping at 1:1 on the way; drag with middle, or with left while the space bar is down
/// or when `left_pans`; double click or 0: fit; 1: 1:1; + and -: powers of two. Esc during a drag puts it back. Returns
/// whether it moved.
bool steer(Ui& ui, const Node& node, ViewState& state, const Rect& area, glm::ivec2 size, bool left_pans);

}  // namespace lapfx::ui
