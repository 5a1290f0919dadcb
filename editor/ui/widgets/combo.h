// One of many: shows what is chosen and drops down a list.
//
// Closed: up and down choose the one before or after, Ctrl+wheel as well, letters the next that begins so; a press,
// Enter or space opens. Open: arrows, pages, Home and End move, Enter or a click takes, Esc leaves all as it was. A
// long list has a field above it: only what contains all typed words is shown. Ten thousand choices cost no more than
// those that are seen.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct ComboOptions {
    std::string_view tip = {};
    std::string_view placeholder = {};  ///< dim, while nothing is chosen
    Size width = {SizeKind::grow, 1};
    bool caption = false;  ///< the label is seen, at the left
};

/// `chosen`: -1 is none; others are clamped. `choices` are told from a new list by their number and place, and must not
/// be changed where they are while the list is open.
Edit combo(Ui& ui, std::string_view label, int& chosen, std::span<const std::string_view> choices,
           const ComboOptions& options = {});

/// Whether `text` has every word of `words` (at spaces) in it; letters of ASCII in either case.
bool contains_words(std::string_view text, std::string_view words);

}  // namespace lapfx::ui
