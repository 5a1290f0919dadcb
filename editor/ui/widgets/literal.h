// Text that is shown as it is, where label() and button() leave out what follows ##. For names and paths of files, and
// for text read from them.
//
//     if (!fault.empty()) ui::literal(u, fault, ui::Tone::error);
#pragma once

#include "ui/widgets/basic.h"

namespace lapfx::ui {

/// A text with as many lines as its width makes necessary.
void literal(Ui& ui, std::string_view text, Tone tone = Tone::normal);
/// One line as wide as there is room, cut with an ellipsis and whole in its tooltip. One to a parent, or each with a
/// seed.
void literal_line(Ui& ui, std::string_view text);
/// A button that is called `text`.
bool literal_button(Ui& ui, std::string_view text, const ButtonOptions& options = {});

}  // namespace lapfx::ui
