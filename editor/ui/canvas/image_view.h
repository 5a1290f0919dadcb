// A picture to look at closely: pan, zoom, exact values of pixels, an eyedropper.
#pragma once

#include "ui/canvas/pixels.h"
#include "ui/canvas/view.h"

namespace lapfx::ui {

struct ImageViewOptions {
    bool grid = true;         ///< between pixels from grid_zoom on
    bool readout = true;      ///< the box beside the pointer
    bool magnifier = false;   ///< the readout has a magnifier
    bool eyedropper = false;  ///< a click, or Enter, takes a colour instead of panning
    int sample_box = 1;       ///< 1, 3, 5 or 11 pixels a side are averaged
    int decimals = 1;         ///< of values that are not whole
    /// Replaces pixel_text(): says what a value means here.
    std::string_view (*text_of)(Ui& ui, const glm::vec4& value) = nullptr;
    /// Builds what lies over the picture, handles for one, as children of the view; `with` is `over_with`.
    void (*over)(Ui& ui, const View& view, void* with) = nullptr;
    void* over_with = nullptr;
    Rect keep_off = {};  ///< that the box beside the pointer never covers, px of the window
    std::string_view tip = {};
    Size width = grow(), height = grow();
};

struct ImageViewResult {
    bool view_changed = false;
    bool has_pick = false;  ///< the pixel below: under the pointer or chosen by keys
    glm::ivec2 pick{0};
    glm::vec4 value{0};   ///< mean of the sample box
    bool picked = false;  ///< the eyedropper took `value` at `pick`
};

ImageViewResult image_view(Ui& ui, std::string_view label, const Picture& picture, ViewState& state,
                           const ImageViewOptions& options = {});

}  // namespace lapfx::ui
