// The values of the events that are selected, to be typed: action, times, place, power, strength.
//
//     panels::event_form(ui, edited, selected, strokes, false);
#pragma once

#include <span>

#include "app/preview/events.h"
#include "panels/edited.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// `stays`: of the scene's events as they are. The first that is selected is shown; a hint where none is.
/// `narrow`: one below the other.
void event_form(ui::Ui& ui, const Edited& edited, std::span<const std::size_t> selected,
                std::span<const app::Stroke> strokes, bool narrow);

/// Whether any contact of it is selected; `selected`, ascending, may name events that are gone.
bool is_selected(std::span<const std::size_t> selected, const app::Stroke& stroke);

}  // namespace lapfx::panels
