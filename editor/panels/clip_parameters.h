// What the panels of clips share: the tables that their rows come from, and the question for a file.
//
//     for (const Parameter& row : keying_table().rows)
//         table_row(ui, edited, row, keying, {.standard = &standard, .saved = &edited.saved.keying(n)});
#pragma once

#include "lapfx/parameter.h"
#include "ui/shell/file_dialog.h"

namespace lapfx::panels {

/// The tables of SmokeClip and of KeyingParameters.
const Table& clip_table();
const Table& keying_table();

/// The question for a smoke video.
ui::FileRequest clip_request(std::string title, bool many);

}  // namespace lapfx::panels
