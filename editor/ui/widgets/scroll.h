// Scrolling: an area whose content may be larger than itself, and lists of which only the rows in sight are built.
//
//     ui::ScrollArea area(u, "Parameters");
//     ...
//
//     ui::virtual_rows(u, "Frames", 10000, u.row_height(), [&](std::size_t row) { ui::label(u, names[row]); });
//
// The wheel scrolls (with Shift sideways), and so do PageUp, PageDown, Home and End when nothing that has the focus
// takes them. Bars are thin and there only when there is something to scroll; the upright one has room of its own, the
// other lies over the content.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct ScrollOptions {
    bool sideways = false;  ///< scrolls along x as well
    Size width = grow(), height = grow();
    float gap = 0, padding = 0;  ///< em
    float top = 0;  ///< px at the top that stay: a header, which the caller places over them (Node::placed)
    Role role = Role::scroll_area;
    Sense sense = Sense::none;  ///< besides what scrolling needs
    std::string_view tip = {};
};

/// The upright bar of a node that scrolls, its last child; nothing while all of it is in sight.
void scroll_bar(Ui& ui, ScrollState& state);

class ScrollArea {
  public:
    ScrollArea(Ui& ui, std::string_view label, const ScrollOptions& options = {});
    ~ScrollArea();
    ScrollArea(const ScrollArea&) = delete;
    ScrollArea& operator=(const ScrollArea&) = delete;

    Id id() const { return id_; }
    ScrollState& state() { return state_; }
    const Response& response() const { return response_; }
    Is is() const { return is_; }  ///< its states, as it was built

  private:
    ScrollArea(Ui& ui, Node& node, const ScrollOptions& options);

    Ui& ui_;
    Id id_;
    ScrollState& state_;
    Response response_;
    Is is_ = Is::nothing;
    float top_;
};

/// Which lines of equal height are in sight in an area; those above and below are empty room. In the very first frame,
/// before there is a layout, as many as the window can hold. Up to 16 million px (700,000 lines) positions are exact.
class LineWindow {
  public:
    /// `height`: px of a line, at least 1. The area's gap must be 0.
    LineWindow(Ui& ui, ScrollArea& area, std::size_t count, float height);
    ~LineWindow();
    LineWindow(const LineWindow&) = delete;
    LineWindow& operator=(const LineWindow&) = delete;

    std::size_t first() const { return first_; }
    std::size_t last() const { return last_; }  ///< one past
    /// Scrolls so that `line` is in sight. Before the window is made.
    static void show(ScrollArea& area, std::size_t line, float height);

  private:
    Ui& ui_;
    std::size_t first_ = 0, last_ = 0;
    float below_ = 0;  ///< px
};

/// A row of virtual_rows(): its children come until close().
void open_line(Ui& ui, float height);
/// `each(row)` builds one row, side by side in `row_height` px. Ids inside are those of the row's number.
template <typename Each>
void virtual_rows(Ui& ui, std::string_view label, std::size_t count, float row_height, Each&& each,
                  const ScrollOptions& options = {.role = Role::list}) {
    ScrollArea area(ui, label, options);
    const LineWindow window(ui, area, count, row_height);
    for (std::size_t row = window.first(); row < window.last(); ++row) {
        ui.push_seed(row);
        open_line(ui, row_height);
        each(row);
        ui.close();
        ui.pop_seed();
    }
}

}  // namespace lapfx::ui
