// Colours along a line: a bar that shows them and handles below it.
//
// A double press on the bar, or Enter, adds a stop; handles are dragged between their neighbours (Shift: ten times as
// fine) or moved with the arrows; Delete takes one away; a double press on a handle, or Enter, opens its colour.
#pragma once

#include <vector>

#include "ui/widgets/color_field.h"

namespace lapfx::ui {

struct GradientStop {
    float place = 0;  ///< 0..1
    Color color;
};

/// Linear in sRGB between stops in the order of their places; beyond the ends as at the ends. Nothing when there is
/// none.
Color gradient_at(std::span<const GradientStop> stops, float place);

struct GradientOptions {
    bool alpha = false;
    std::string_view tip = {};
    std::size_t least = 2, most = 16;  ///< stops
    Eyedropper* eyedropper = nullptr;
};

/// `stops` are sorted by their places, and those brought into 0..1.
Edit gradient_bar(Ui& ui, std::string_view label, std::vector<GradientStop>& stops,
                  const GradientOptions& options = {});

}  // namespace lapfx::ui
