// Two panes and a handle between them.
//
//     ui::Splitter split(u, "Views", ui::Axis::x, settings.fraction);
//     ...first pane...
//     split.next();
//     ...second pane...
//
// The handle is dragged, Esc puts it back; a double click or Backspace brings the standard place back; arrows move it
// by an em, Home and End as far as it goes. In the tree it is "Views/handle".
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct SplitterOptions {
    float first_minimum = 6, second_minimum = 6;  ///< em; too little for both: shared out
    float standard = 0.5F;
    Size width = grow(), height = grow();
};

class Splitter {
  public:
    /// `axis`: x for panes side by side. `fraction` of the first, 0 to 1; the program keeps it.
    Splitter(Ui& ui, std::string_view label, Axis axis, float& fraction, const SplitterOptions& options = {});
    ~Splitter();
    Splitter(const Splitter&) = delete;
    Splitter& operator=(const Splitter&) = delete;

    void next();  ///< what follows is in the second pane
    const Edit& edit() const { return edit_; }

  private:
    void open_pane(float length);

    Ui& ui_;
    Axis axis_;
    Edit edit_;
    float first_ = 0, second_ = 0, fraction_;
};

/// A length of `room` px that is split: what the first gets, whole.
struct Split {
    float room = 0;                               ///< px, without the handle
    float first_minimum = 0, second_minimum = 0;  ///< px
    float standard = 0.5F;
    float first(float fraction) const;
};
/// px that handles take.
float splitter_gap(const Ui& ui);
/// What a person does to the handle `id` of this split; `fraction` follows. Before the panes are built.
Edit drag_splitter(Ui& ui, Id id, Axis axis, const Split& split, float& fraction);
/// The handle itself, after the panes, over the gap that begins at `at` px in its parent and is `length` px long.
void put_splitter(Ui& ui, std::string_view label, Axis axis, glm::vec2 at, float length, float fraction);

}  // namespace lapfx::ui
