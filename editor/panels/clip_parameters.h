// What the panels of clips share: the tables that their rows come from, and the question for a file.
//
//     for (const Parameter& row : keying_table().rows)
//         table_row(ui, edited, row, keying, {.standard = &standard, .saved = &edited.saved.keying(n)});
#pragma once

#include <string_view>

#include "app/clips/clip_shelf.h"
#include "lapfx/parameter.h"
#include "lapfx/preset.h"
#include "ui/shell/file_dialog.h"

namespace lapfx::panels {

/// The tables of SmokeClip and of KeyingParameters.
const Table& clip_table();
const Table& keying_table();

/// Why the selected clip does not take a parameter of the preset; empty: it takes it.
struct NotTaken {
    std::string_view why{};  ///< goes on after "Clip 2"
    std::string_view tip{};
};
NotTaken not_taken(const SmokeParameters& smoke, const app::ClipShelf& shelf, std::string_view key);

/// A threshold, which a clip with its own opacity does not use. `key`: "luma_low".
bool is_threshold(std::string_view key);

/// The question for a smoke video.
ui::FileRequest clip_request(std::string title, bool many);

}  // namespace lapfx::panels
