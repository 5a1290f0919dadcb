// A texture that the organ names and that cannot be read: the organ then is of one colour.
#pragma once

#include "panels/edited.h"
#include "ui/core/ui.h"

namespace lapfx::app {
class PreviewHost;
struct MissingTexture;
}  // namespace lapfx::app

namespace lapfx::panels {

/// With the picture that may be meant, of which there must be one; true when it was pressed.
bool likely_texture_button(ui::Ui& ui, const app::MissingTexture& missing);

/// In the Scene panel: that it is missing, and a button with the picture that may be meant, if there is one.
void texture_notice(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview);
/// The same over the view, where one looks, and where there is no such picture a button to choose one; until it is
/// taken or left.
void texture_box(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview, ui::Size width);

}  // namespace lapfx::panels
