// How close preview and reference are, in words: each part of the line is a link to what mends it.
#pragma once

#include "panels/panels.h"

namespace lapfx::panels {

/// Of the scene, and no row of the preset: "camera.exposure".
inline constexpr const char* exposure_key = "camera.exposure";
/// To the row of a parameter, or to an event on the timeline: "events.2.time".
void go_to_what_mends(ui::Ui& ui, const AmountsParts& on, const std::string& key);

/// Nothing before both are measured. `colors`: with the line of colours. Gives whether there were any.
bool measured_words(ui::Ui& ui, const AmountsParts& on, bool colors);

}  // namespace lapfx::panels
