// Parameters of clips and keying as rows, from the table.
//
//     for (const Parameter& row : clip_table().rows)
//         clip_row(ui, editor, row, clip, [=](Content& c) -> void* { return &c.preset.smoke.clips[number]; });
#pragma once

#include "app/editor.h"
#include "ui/core/ui.h"
#include "ui/widgets/rows.h"

namespace lapfx::panels {

/// The tables of SmokeClip and of KeyingParameters.
const Table& clip_table();
const Table& keying_table();

/// A row for a number, a choice or a colour of `owner`; what is edited goes into the document, one undo step a gesture.
/// `standard`: the same struct with the values that it is compared with. `in`: the struct in a content.
void clip_row(ui::Ui& ui, app::Editor& editor, const Parameter& row, const void* owner, const void* standard,
              const ui::FunctionRef<void*(document::Content&)>& in);

/// "Help. 0 to 255 code values"; good for ever.
std::string_view tip_of(const Parameter& row);

/// The question for a smoke video.
ui::FileRequest clip_request(std::string title, bool many);

}  // namespace lapfx::panels
