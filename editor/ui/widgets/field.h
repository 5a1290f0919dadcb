// What fields of all kinds have in common: the ground, the caption to its left, the thumb that shows where one has
// scrolled to.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

inline constexpr float caption_share = 0.45F;  ///< a row with a caption gives it this part
inline constexpr float caption_inset = 0.35F;  ///< em before it: clear of the focus ring
/// The field of a row: what is right of the caption, or all of it when there is none.
Rect field_part(const Rect& row, bool caption);
void draw_caption(Painter& painter, const Node& node, bool caption);
/// `is`: of the node; an invalid field has a red edge, one that has the keyboard a bright one.
void draw_field(Painter& painter, const Rect& rect, Is is);

/// Behind selected text.
Color selection_color(const Theme& theme);

/// The ground of what drops down from a field. Nothing is asked of `look`.
void draw_popup(Painter& painter, const Node& node, const bool& look);
/// The name of an overlay that belongs to one widget.
std::string_view overlay_name(Ui& ui, std::string_view kind, Id owner);

/// The thumb of a scrolled view on its track, px; empty when everything is visible.
Rect scroll_thumb(const Rect& track, const ScrollState& scroll, float least);
/// The offset that moves the thumb by `px` along the track.
float scrolled_by_thumb(const Rect& track, const ScrollState& scroll, float px, float least);

}  // namespace lapfx::ui
