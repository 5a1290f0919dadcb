// Sentences of the fit name parameters by their keys, as files and commands do; the window calls them otherwise.
//
//     label(app::with_titles("smoke.haze.ventilation: not determined"));  // "Haze: Ventilation: not determined"
//
// Pure functions, any thread.
#pragma once

#include <string>
#include <string_view>

namespace lapfx::app {

/// "Haze: Ventilation" of "smoke.haze.ventilation", "Camera: Exposure" of "camera.exposure", "Event 3: Start" of
/// "events.2.time"; empty: neither presets nor scenes have that key.
std::string title_of(std::string_view key);

/// The text with the title of each key in it, and arrows between what was and what is to be as the window has them.
std::string with_titles(std::string_view text);

}  // namespace lapfx::app
