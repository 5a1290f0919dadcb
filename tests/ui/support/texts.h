// Finds texts in a frame that are drawn over each other or cut. It reads them from the frame's draw list.
//
//     EXPECT_THAT(texts_over_texts(*ui.output().list), IsEmpty());
//
// A text that something opaque covers, such as a menu, a dialog or a tooltip, is not visible and does not count.
#pragma once

#include <string>
#include <vector>

#include "ui/core/tree.h"
#include "ui/draw/draw_list.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

/// One visible line of text.
struct TextSeen {
    Rect rect;                 ///< px, around the visible parts of its glyphs
    std::vector<Rect> glyphs;  ///< px, not clipped
    Rect clip;
    bool elided = false;  ///< an ellipsis stands for its end; one at its beginning, as of a path, counts
                          ///< only where nothing follows
};
/// `em`, px, is used to recognise the ellipses of all sizes of text. `letters` are the fonts that the frame was drawn
/// with.
std::vector<TextSeen> texts_seen(const DrawList& list, Fonts& letters, float em);

/// The innermost node with a label at the middle of `text`; if there are several, the one that was built last.
std::uint32_t node_of(std::span<const Node> tree, const TextSeen& text);

/// A line for each pair of texts that are drawn over each other: their paths and places.
std::vector<std::string> texts_over_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em);
/// A line for each text that is cut: labels of controls, numbers, paths and texts of the program's own that end in an
/// ellipsis, names of tabs of which a part is seen, values of which the ellipsis leaves at
/// most one letter, and texts of which a clip cuts off part of a letter at the side or part of their height. The last
/// do not count where a person can scroll there.
std::vector<std::string> cut_texts(std::span<const Node> tree, const std::vector<TextSeen>& texts, float em);

}  // namespace lapfx::ui
