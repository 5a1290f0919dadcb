// What the panels of clips share: the tables that their rows come from, and the question for a file.
//
//     for (const Parameter& row : keying_table().rows) table_row(ui, editor, row, keying, {.standard = &standard,
//                                                                                       .saved = &saved_keying(editor,
//                                                                                       n)});
#pragma once

#include "app/editor.h"

namespace lapfx::panels {

/// The tables of SmokeClip and of KeyingParameters.
const Table& clip_table();
const Table& keying_table();

/// What was saved of a clip, the default for one that is new; and of the keying that holds for it.
const SmokeClip& saved_clip(app::Editor& editor, std::size_t number);
const KeyingParameters& saved_keying(app::Editor& editor, std::size_t number);

/// The question for a smoke video.
ui::FileRequest clip_request(std::string title, bool many);

}  // namespace lapfx::panels
