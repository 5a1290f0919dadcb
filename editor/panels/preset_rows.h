// Rows of the preset panel: one parameter each, made from its row of the parameter table.
//
//     parameter_row(ui, edited, tuning, app::parameters().find("bleeding.speed"), false);  // "Speed  4 mm/s"
//
// A lower and an upper bound share a row. What is wrong with a value is told below its row.
#pragma once

#include "app/tuning/tuning.h"
#include "panels/edited.h"

namespace lapfx::panels {

/// `with_group`: labelled "Bleeding: Speed", where no section says it.
void parameter_row(ui::Ui& ui, const Edited& edited, app::Tuning& tuning, std::size_t entry, bool with_group);

}  // namespace lapfx::panels
