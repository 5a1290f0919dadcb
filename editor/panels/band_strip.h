// What makes the vessel and the fat overlay, to be tuned while looking at it: how often each contrast or hue occurs on
// the organ, the band over it, and the numbers beside it.
//
//     panels::band_strip(ui, looking.overlay, edited, preview, jobs);
#pragma once

#include "app/preview_host.h"
#include "panels/edited.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// Nothing but for the overlays of vessels and of fat.
void band_strip(ui::Ui& ui, Overlay overlay, const Edited& edited, const app::PreviewHost& preview, app::Jobs& jobs);

}  // namespace lapfx::panels
