// The values of the events that are selected, to be typed: action, times, place, power, strength.
//
//     panels::event_form(ui, editor, strokes, false);
#pragma once

#include <span>

#include "app/editor.h"
#include "app/events.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// `stays`: of the scene's events as they are. The first that is selected is shown; a hint where none is.
/// `narrow`: one below the other.
void event_form(ui::Ui& ui, app::Editor& editor, std::span<const app::Stroke> strokes, bool narrow);

/// Whether any contact of it is selected; editor.selected may name events that are gone.
bool is_selected(const app::Editor& editor, const app::Stroke& stroke);

}  // namespace lapfx::panels
