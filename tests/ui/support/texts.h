// What becomes of texts in a frame, read from its draw list: which of them lie over each other, which are cut.
//
//     EXPECT_THAT(texts_over_texts(*ui.output().list), IsEmpty());
//
// A text that something opaque covers is not seen and does not count: what lies under a menu, a dialog or a tooltip.
#pragma once

#include <string>
#include <vector>

#include "ui/core/tree.h"
#include "ui/draw/draw_list.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

/// One line of text as it is seen.
struct TextSeen {
    Rect rect;                 ///< px, of its glyphs as far as they are not clipped away
    std::vector<Rect> glyphs;  ///< px, not clipped
    Rect clip;
    bool elided = false;  ///< it ends in an ellipsis
};
/// `em`: px, by which the ellipsis of every size of text is known. `letters`: the fonts that the frame was drawn with.
std::vector<TextSeen> texts_seen(const DrawList& list, Fonts& letters, float em);

/// The path of the innermost node whose text is in the middle of `text`; of those, the one that was built last.
std::uint32_t node_of(std::span<const Node> tree, const TextSeen& text);

/// Each a line: the paths of two texts that are drawn over each other, and where.
std::vector<std::string> texts_over_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em);
/// Each a line: controls whose label ends in an ellipsis, values of which it leaves at most a letter, and texts of
/// which a clip takes a part of a letter at the side or a part of their height, other than where one scrolls there.
std::vector<std::string> cut_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em);

}  // namespace lapfx::ui
