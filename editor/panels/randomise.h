// Randomising the preset: at once, or by a small box with how far it goes and the seed.
//
//     randomise(tuning, document, toasts, nullptr);   // all that is not locked, one undo step
//     open_randomise_box(ui, nullptr, id_of_button);  // asks for strength and seed first
//     randomise_box(ui, tuning, document, toasts);    // once a build
//
// Groups are those of app::parameters(); null stands for all.
#pragma once

#include "app/tuning/tuning.h"
#include "ui/shell/toast.h"

namespace lapfx::panels {

/// Tells when there was nothing to change.
void randomise(app::Tuning& tuning, document::Document& document, ui::Toasts& toasts, const app::ParameterGroup* group);

void open_randomise_box(ui::Ui& ui, const app::ParameterGroup* group, ui::Id anchor);
void randomise_box(ui::Ui& ui, app::Tuning& tuning, document::Document& document, ui::Toasts& toasts);

}  // namespace lapfx::panels
