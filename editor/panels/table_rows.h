// Rows of the UI from a parameter table, over the document: one field for each parameter, every gesture one undo step.
//
//     const auto light = [](document::Content& c) -> void* { return &c.scene.light; };
//     panels::table_rows(ui, edited, *scene_table().find("light"), light);
//     panels::table_row(ui, edited, *scene_table().find_row("seed"), scene, {.name = "Seed"});
//
// A row has the name of its parameter; its tooltip has the help and what is allowed. Its undo steps have that name,
// too, or "Camera: Eye" with a prefix. It has a dot while it differs from what was saved; Backspace or a double click
// on the name goes back to that, Shift+Backspace or the menu to the default. All panels make their rows here: those of
// the preset panel have locks and menus added (preset_rows.h).
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>

#include "panels/edited.h"
#include "ui/core/ui.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

/// Finds the struct with the rows in a content. Null: it is not there now, and nothing is built or changed.
using OwnerOf = std::function<void*(document::Content&)>;

struct TableRowOptions {
    std::string_view name = {};             ///< in place of the parameter's own
    std::string_view prefix = {};           ///< of the undo step's name
    std::string_view step = {};             ///< the undo step's whole name, in place of prefix and name
    std::string_view tip = {};              ///< in place of the parameter's own
    const void* standard = nullptr;         ///< a struct like the owner, with the defaults
    const void* saved = nullptr;            ///< the same, as saved; null: where the owner lies in what was saved
    double maximum = 0;                     ///< above `minimum`: a soft maximum nearer than the parameter's
    double minimum = 0;                     ///< and minimum, when there is a soft maximum
    bool locked = false;                    ///< shown with a lock
    bool favourite = false;                 ///< for the menu of a number
    ui::ParamActions* actions = nullptr;    ///< of the menu of a number
    const ui::FileFilter* files = nullptr;  ///< the dialog of a path shows these first
};

/// One parameter. Gives the edit, which the document has already taken.
ui::Edit table_row(ui::Ui& ui, const Edited& edited, const Parameter& row, const OwnerOf& owner,
                   const TableRowOptions& options = {});

/// "Help. A number from 0 to 255 levels"; valid as long as the program runs.
std::string_view tip_of(const Parameter& row);

/// The parameter whose row comes into sight and gets the keyboard when its panel is built next; null: none.
const Parameter*& wanted_row(ui::Ui& ui);

/// Whether it is a row of the table, or of a table inside it.
bool has_row(const Table& table, const Parameter* row);

/// Scrolls to what has been built since node `before` (counted from ui.parent()); the `nth` node of it that takes the
/// keyboard gets it.
void go_to_row(ui::Ui& ui, std::ptrdiff_t before, int nth = 0);

/// What a field takes from its parameter: limits, step, unit, scale, tooltip.
ui::ParamOptions param_options(const Parameter& row);

/// All rows of a table, but not of the tables inside it.
ui::Edit table_rows(ui::Ui& ui, const Edited& edited, const Table& table, const OwnerOf& owner,
                    const TableRowOptions& options = {});

}  // namespace lapfx::panels
