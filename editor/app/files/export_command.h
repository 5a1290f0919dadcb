// The command line that makes what an export makes: what the dialog copies.
#pragma once

#include <string>

#include "app/files/exports.h"

namespace lapfx::app {

/// Throws Error (bad_input) when there is none: scene or preset are not saved, or the form does not render. `overlay`:
/// that of the view. `reference`: the scene's, empty: none.
std::string render_command(const ExportForm& form, const document::Document& document, Overlay overlay,
                           const std::filesystem::path& reference);

}  // namespace lapfx::app
