// Rows of the UI from a parameter table, over the document: one field for each parameter, every gesture one undo step.
//
//     const auto light = [](document::Content& c) -> void* { return &c.scene.light; };
//     panels::table_rows(ui, editor, *scene_table().find("light"), light);
//     panels::table_row(ui, editor, *scene_table().find_row("seed"), scene, {.name = "Seed"});
//
// A row is called as the parameter is; its tooltip has the help and what is allowed. Where it starts a step of the history, that is
// called after it, too, or "Camera: Eye" with a prefix.
#pragma once

#include <functional>
#include <initializer_list>
#include <string_view>

#include "app/editor.h"
#include "ui/core/ui.h"

namespace lapfx::panels {

/// Where the struct that has the rows lies in a content; null: nowhere now, and nothing is built or changed.
using OwnerOf = std::function<void*(document::Content&)>;

struct TableRowOptions {
    std::string_view name = {};       ///< in place of the parameter's own
    std::string_view prefix = {};     ///< of the undo step's name
    const void* standard = nullptr;   ///< a struct like the owner, with the values to go back to
    double maximum = 0;               ///< above 0: a soft maximum nearer than the parameter's
    double minimum = 0;               ///< and minimum, when there is a soft maximum
    std::string_view file_kind = {};  ///< of paths: "Meshes", with `extensions`
    std::initializer_list<const char*> extensions = {};
};

/// One parameter. Gives what came of it; the document has it already.
ui::Edit table_row(ui::Ui& ui, app::Editor& editor, const Parameter& row, const OwnerOf& owner,
                   const TableRowOptions& options = {});

/// All rows of a table, but not of the tables inside it.
ui::Edit table_rows(ui::Ui& ui, app::Editor& editor, const Table& table, const OwnerOf& owner,
                    const TableRowOptions& options = {});

}  // namespace lapfx::panels
