// A tree of named things: parts of a mesh, folders. Rows in sight are built.
//
//     const ui::TreeItem items[] = {{"Liver", 0}, {"Left lobe", 1}, {"Right lobe", 1}};  // in order, each below its
//     parent if (ui::tree_view(u, "Parts", state, items).selected) show(state.selection);
//
// Press selects, the triangle or a double click opens and closes; Right opens or goes to the first below, Left closes
// or goes to the one above.
#pragma once

#include "ui/widgets/rows.h"

namespace lapfx::ui {

struct TreeItem {
    std::string_view label;
    int depth = 0;  ///< at most one more than that of the item before
    Icon icon = Icon::none;
    Icon mark = Icon::none;  ///< at the right, can be clicked: an eye, a lock
    std::string_view mark_tip = {};
    bool dim = false;            ///< hidden, not used
    std::uint64_t key = no_key;  ///< for selection and what is open; no_key: its place among `items`
};

struct TreeState {
    Selection selection;
    std::vector<std::uint64_t> closed;  ///< keys, ascending; all others are open
};

struct TreeOptions {
    bool multiple = false;
    Size width = grow(), height = grow();
};

/// Rows are numbers into `items`.
struct TreeEvents : RowEvents {
    std::size_t marked_item = no_row;  ///< its mark was clicked, or space pressed on it
    std::size_t toggled = no_row;      ///< was opened or closed
};

TreeEvents tree_view(Ui& ui, std::string_view label, TreeState& state, std::span<const TreeItem> items,
                     const TreeOptions& options = {});

}  // namespace lapfx::ui
