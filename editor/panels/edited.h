// What rows and fields edit, and what they need for it. Panels with rows take it as one; it holds references alone.
//
//     panels::table_row(ui, {document, saved, eyedropper, chooser, seen_colors}, row, owner);
#pragma once

#include "app/base/file_chooser.h"
#include "app/base/saved.h"
#include "app/preview/seen_colors.h"
#include "document/document.h"
#include "ui/widgets/color_field.h"

namespace lapfx::panels {

struct Edited {
    document::Document& document;
    app::Saved& saved;           ///< what a row's dot compares with, and what Backspace goes back to
    ui::Eyedropper& eyedropper;  ///< of fields of colours
    app::FileChooser& chooser;   ///< of fields of paths
    app::SeenColors& seen;       ///< of colours that were picked
};

}  // namespace lapfx::panels
