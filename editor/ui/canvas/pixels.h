// Single pixels of a picture under the pointer: exact values, averages, and the box beside the pointer that shows them.
#pragma once

#include "ui/canvas/view.h"

namespace lapfx::ui {

/// The program's own pixels, of which the shown picture may be a display version. Called only for pixels inside.
class PickSource {
  public:
    virtual ~PickSource() = default;
    /// Red, green, blue and alpha in the program's units; code values 0..255 as a rule.
    virtual glm::vec4 pixel(glm::ivec2 at) const = 0;
};

struct Picture {
    ImageHandle image = 0;
    glm::ivec2 size{0};
    const PickSource* pixels = nullptr;  ///< null: no readout
    bool transparent = false;            ///< has an alpha worth a checkerboard
};

/// The mean of the box of `side` (odd) around `at`, of as much of it as is inside. Zero where nothing is.
glm::vec4 mean_of(const PickSource& source, glm::ivec2 size, glm::ivec2 at, int side);

/// The same of code values, worked out in linear light: what an eyedropper takes.
Color picked_color(const PickSource& source, glm::ivec2 size, glm::ivec2 at, int side);

/// The pixel that is looked at: under the pointer, or moved on by the arrow keys until the pointer moves again.
struct Pick {
    bool on = false;
    bool by_keys = false;
    glm::ivec2 at{0};
};
/// `views`: the picture's, one or more side by side. Arrows move it by a pixel, with Shift by ten, and `state` so that
/// it is seen.
void move_pick(Ui& ui, const Node& node, const Response& response, Pick& pick, std::span<const View> views,
               ViewState& state);

/// Whether the node was clicked, or Enter pressed, to take the colour of the pick.
bool eyedropper_clicked(Ui& ui, Id id);

/// "R 12  G 8.5  B 0  A 255" in the frame's arena; whole numbers without decimals, else `decimals`.
std::string_view pixel_text(Ui& ui, const glm::vec4& value, int decimals = 1);
/// "412, 310".
std::string_view place_text(Ui& ui, glm::ivec2 at);

/// The box beside the pointer.
struct Readout {
    static constexpr int most_lines = 4;
    std::string_view lines[most_lines] = {};
    int line_count = 0;
    ImageHandle image = 0;  ///< magnified above the lines; 0: no magnifier
    glm::ivec2 size{0};
    glm::ivec2 at{0};
    int side = 1;                 ///< of the sample box
    Color swatch = {0, 0, 0, 0};  ///< alpha 0: none
    Rect keep_off = {};           ///< that it never covers, px of the window; empty: nothing
};
/// The part of `area` where a box of `size` covers nothing of `keep_off`: beside it, where there is most room. Empty
/// where there is none for it.
Rect room_beside(const Rect& area, const Rect& keep_off, glm::vec2 size);
/// Where such a box lies: in `area`, beside what is measured, right of and below it if there is room. It covers the
/// least of it where there is none.
glm::vec2 beside(const Rect& area, const Rect& measured, glm::vec2 size);
/// Not drawn where it would cover what it keeps off.
void draw_readout(Painter& painter, const View& view, const Readout& readout);
/// The colour that code values are shown as.
Color color_of(const glm::vec4& code_value);
/// The line of an eyedropper: "#5f1c20   412, 310", with the colour's swatch beside all lines.
std::string_view picked_text(Ui& ui, Color picked, glm::ivec2 at);

/// A picture with what lies behind it, its pixels' grid from grid_zoom on, and the sample box around the pick; clipped
/// to the area. With `second`: both, compared.
struct PictureLook {
    Picture picture;
    ImageHandle second = 0;
    CompareLook compare = {};
    bool grid = true;
    Pick pick = {};
    int side = 1;
};
void draw_picture(Painter& painter, const View& view, const PictureLook& look);

}  // namespace lapfx::ui
