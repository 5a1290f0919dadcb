// Pictures with names in a grid: presets, clips. Lines in sight are built; pictures may come later.
//
// A press or arrows select, Enter or a double click opens, space or the star in the corner marks an item. The item
// under the pointer is reported, so that a preset can be shown while the pointer is on it.
#pragma once

#include "ui/widgets/rows.h"

namespace lapfx::ui {

struct Thumbnail {
    std::string_view label;
    ImageHandle image = 0;  ///< 0: not here yet
    bool star = false;
    bool changed = false;        ///< differs from what is stored: a dot
    std::string_view tip = {};   ///< empty: the label where it is cut
    std::uint64_t key = no_key;  ///< no_key: its number
};

struct ThumbnailOptions {
    float cell = 8;            ///< em, width of a picture; what is left over is shared out
    float aspect = 16.0F / 9;  ///< of pictures
    Size width = grow(), height = grow();
};

/// `marked`: the star of this one is to change.
using ThumbnailEvents = RowEvents;

/// `item(number)` for those in sight; its texts are copied. `label` names the grid. Pictures fill their cells: make
/// them `aspect`.
ThumbnailEvents thumbnails(Ui& ui, std::string_view label, Selection& selection, std::size_t count,
                           const FunctionRef<Thumbnail(std::size_t)>& item, const ThumbnailOptions& options = {});

}  // namespace lapfx::ui
