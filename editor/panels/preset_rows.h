// Rows of the preset panel: one parameter each, made from its row of the parameter table.
//
//     parameter_row(ui, edited, tuning, app::parameters().find("bleeding.speed"), false);  // "Speed  4 mm/s"
//
// A lower and an upper bound share a row. What is wrong with a value is told below its row.
#pragma once

#include "app/tuning/tuning.h"
#include "panels/edited.h"

namespace lapfx::panels {

/// What a row is called: "Speed" in its section; elsewhere "Bleeding: Speed", or where there is no room for that in all
/// rows, "Speed" again.
enum class RowName : std::uint8_t { in_section, with_group, without_group };
/// Gives the id of its first widget.
ui::Id parameter_row(ui::Ui& ui, const Edited& edited, app::Tuning& tuning, std::size_t entry, RowName called);
/// "Bleeding: Speed", or that of both ends of a range.
std::string_view title_with_group(std::size_t entry);

}  // namespace lapfx::panels
