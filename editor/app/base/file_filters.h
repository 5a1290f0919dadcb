// Filters of file dialogs, from the table of formats (lapfx/authoring/formats.h).
//
//     chooser.ask({.title = "Load an organ", .filters = {app::mesh_filter()}}, ...);
#pragma once

#include "lapfx/authoring/formats.h"
#include "ui/shell/file_dialog.h"

namespace lapfx::app {

ui::FileFilter mesh_filter();
ui::FileFilter document_filter();  ///< presets and scenes
ui::FileFilter picture_filter();
/// What is a clip or a reference: first the videos, called `videos`, then the pictures.
std::vector<ui::FileFilter> clip_filters(std::string videos);
/// What Open takes: first all of it, then by kind.
std::vector<ui::FileFilter> open_filters();
/// The filter for the files that an export writes.
ui::FileFilter written_filter(std::string name, Content content);

}  // namespace lapfx::app
