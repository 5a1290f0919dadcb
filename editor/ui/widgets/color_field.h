// A colour, and the picker that opens from it: a square of saturation and value, bars of hue and alpha, what it was
// before, and its numbers to type.
#pragma once

#include <functional>
#include <optional>

#include "ui/core/ui.h"

namespace lapfx::ui {

/// hue in degrees, 0 to below 360; the others 0..1.
struct Hsv {
    float hue = 0, saturation = 0, value = 0;
};
/// Grey has no hue, black no saturation: they are taken from `before`, so that a drag through them does not lose them.
Hsv to_hsv(Color color, const Hsv& before = {});
Color to_color(const Hsv& hsv, std::uint8_t alpha = 255);

/// "#rgb", "#rgba", "#rrggbb" or "#rrggbbaa", with or without the mark, spaces around. Nothing: not a colour.
std::optional<Color> parse_hex(std::string_view text);
/// "#rrggbb", with `alpha` "#rrggbbaa"; `buffer` has 9 bytes at least.
std::string_view format_hex(std::span<char> buffer, Color color, bool alpha);

/// Between a picker that wants a colour from a picture and the program that can give one. The program looks at
/// `wanted_by` after the frame; while it is not 0 it shows a cross over its pictures, and puts what is clicked into
/// `picked`, or gives up with wanted_by = 0.
struct Eyedropper {
    Id wanted_by = 0;
    std::optional<Color> picked;
};

struct ColorOptions {
    bool alpha = false;    ///< can be edited; else it stays as it is
    bool caption = false;  ///< the label is seen, at the left
    std::string_view tip = {};
    Size width = {SizeKind::grow, 1};
    Eyedropper* eyedropper = nullptr;  ///< null: nothing to pick from
    /// What a colour that was picked becomes; none: it is taken as it is.
    const std::function<Color(Color)>* picked_as = nullptr;
};

/// Ctrl+C and Ctrl+V copy and paste it as text. Each drag, typed text, click or paste is an edit of its own; Esc during
/// a drag takes it back.
Edit color_field(Ui& ui, std::string_view label, Color& color, const ColorOptions& options = {});

/// For widgets that have colours of their own: the picker of `owner` (a node, below which it opens), built while it is
/// open.
void open_color_picker(Ui& ui, Id owner, Color color, glm::vec2 offset = {0, 0});
Edit color_picker(Ui& ui, Id owner, std::string_view label, Color& color, const ColorOptions& options = {});

/// The colour over a checkerboard where it is not opaque.
void draw_swatch(Painter& painter, const Rect& rect, Color color);

}  // namespace lapfx::ui
