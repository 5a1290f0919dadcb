// One of many: shows what is chosen and drops down a list.
//
// Closed: up and down, or Ctrl+wheel, choose the one before or after; letters choose the next that begins with them; a
// press, Enter or space opens the list. Open: arrows, page keys, Home and End move; Enter or a click chooses; Esc
// closes without a change. A long list has a field above it and shows only choices that contain all words typed there.
// Ten thousand choices cost no more than those in sight.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct ComboOptions {
    std::string_view tip = {};
    std::string_view placeholder = {};  ///< dim, while nothing is chosen
    Size width = {SizeKind::grow, 1};
    bool caption = false;  ///< the label is seen, at the left
};

/// `chosen`: -1 is none; others are clamped. The list recognises new `choices` by their number and address, so do not
/// change them in place while it is open.
Edit combo(Ui& ui, std::string_view label, int& chosen, std::span<const std::string_view> choices,
           const ComboOptions& options = {});

/// Whether `text` has every word of `words` (at spaces) in it; letters of ASCII in either case.
bool contains_words(std::string_view text, std::string_view words);

}  // namespace lapfx::ui
