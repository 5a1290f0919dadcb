// A table: a header, rows of text of which those in sight are built, a selection, an order.
//
//     const ui::TableColumn columns[] = {{"Name", 14}, {"Length", 6, ui::Align::end}};
//     const auto events = ui::table(u, "Clips", state, columns, clips.size(),
//                                  [&](std::size_t row, std::size_t column) {
//         return ui::TableCell{.text = column == 0 ? clips[row].name : clips[row].length};
//     });
//     if (events.sorted) sort(clips, state.sort_column, state.descending);
//
// A click on a header sorts by it, another click reverses the order. Dragging the right edge of a header makes the
// column wider; a double click on it makes the column as wide as the cells in sight need. With the keyboard: Tab to a
// header, arrows to the next, Enter sorts, Shift+Left and Shift+Right resize, Backspace brings the standard width back.
#pragma once

#include "ui/widgets/basic.h"
#include "ui/widgets/rows.h"

namespace lapfx::ui {

struct TableColumn {
    std::string_view title;
    float width = 8;  ///< em, to begin with
    Align align = Align::start;
    bool sortable = true;
    std::string_view tip = {};
};

struct TableCell {
    std::string_view text;
    Icon icon = Icon::none;
    Tone tone = Tone::normal;
    bool number = false;  ///< digits of one width
};

/// The state of a table. The program owns it and may keep it in its settings.
struct TableState {
    Selection selection;
    int sort_column = -1;  ///< -1: as the rows come
    bool descending = false;
    std::vector<float> widths;  ///< em, one a column; any other number of them: the standard ones
};

struct TableOptions {
    bool multiple = false;
    Size width = grow(), height = grow();
    /// The key of a row, for selection and ids; null: its number.
    const RowList::KeyOf* key_of = nullptr;
    std::size_t show = no_row;  ///< scrolls to this row
    bool letters = false;       ///< typed letters go to the next row whose first column begins with them
};

struct TableEvents : RowEvents {
    bool sorted = false;   ///< sort_column or descending has changed: the program sorts
    bool resized = false;  ///< widths have changed
    bool unseen = false;   ///< it could not scroll to TableOptions::show yet: ask again in the next build
};

/// `cell(row, column)`: its text is copied. The first column names the row in the semantic tree.
TableEvents table(Ui& ui, std::string_view label, TableState& state, std::span<const TableColumn> columns,
                  std::size_t count, const FunctionRef<TableCell(std::size_t, std::size_t)>& cell,
                  const TableOptions& options = {});

}  // namespace lapfx::ui
