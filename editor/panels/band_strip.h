// What makes the vessel and the fat overlay, to be tuned while looking at it: how often each contrast or hue occurs on
// the organ, the band over it, and the numbers beside it.
//
//     if (editor.looking.overlay == Overlay::vessels) panels::band_strip(ui, editor);
#pragma once

#include "app/editor.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// Nothing but for the overlays of vessels and of fat.
void band_strip(ui::Ui& ui, app::Editor& editor);

}  // namespace lapfx::panels
