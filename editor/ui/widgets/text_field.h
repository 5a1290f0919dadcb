// Text of one line that can be edited.
//
// A press places the caret, a double press selects the word, a triple press selects all; a drag selects, and scrolls
// beyond the edges. Tab comes to the field with all selected. Enter commits and stays; leaving the field commits as
// well. Esc goes back to the text that was committed last or, if that is unchanged, leaves the field. Ctrl+Z undoes in
// the field as long as it has something to undo, then in the program.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct TextFieldOptions {
    std::string_view placeholder = {};  ///< dim, while the field is empty
    std::string_view tip = {};
    Size width = {SizeKind::grow, 1};
    std::size_t bytes = 1 << 20;  ///< what would go beyond is cut
    bool caption = false;         ///< the label is seen, at the left
    bool read_only = false;       ///< can be selected and copied
    bool invalid = false;         ///< red: what is typed cannot be taken; say why in `tip`
    bool monospace = false;
    bool path = false;   ///< where it is too long, its end is seen
    bool whole = false;  ///< the first press selects all, so that what is typed then replaces it
    /// For a field above a list: Enter, Esc, up, down and the page keys do nothing here; whoever builds it reads them
    /// with ui.events_of(id of the field).
    bool keys_outside = false;
};

/// `text` changes with every key. The edit is committed by Enter or when another widget gets the keyboard. Bytes that
/// are not UTF-8 are kept. The semantic tree has the first 64 KiB of the text.
Edit text_field(Ui& ui, std::string_view label, std::string& text, const TextFieldOptions& options = {});

/// A text field with a magnifying glass at the left and a cross at the right. The cross empties it, and so does Esc.
Edit search_field(Ui& ui, std::string_view label, std::string& text, const TextFieldOptions& options = {});

}  // namespace lapfx::ui
