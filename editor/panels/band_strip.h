// Tunes the overlays of vessels and fat while one looks at them: how often each contrast or hue occurs on the organ,
// the band that is taken from it, and the numbers beside it.
//
//     panels::band_strip(ui, looking.overlay, edited, preview, jobs);
#pragma once

#include "app/preview/preview_host.h"
#include "panels/edited.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// Builds nothing for other overlays than those of vessels and of fat.
void band_strip(ui::Ui& ui, Overlay overlay, const Edited& edited, const app::PreviewHost& preview, app::Jobs& jobs);

}  // namespace lapfx::panels
