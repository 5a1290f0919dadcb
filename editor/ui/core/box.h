// Arrangements: rows, columns, panels and the room between what is in them.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

/// Children side by side or below each other.
struct BoxOptions {
    Size width = fit(), height = fit();
    float gap = -1;     ///< em; negative: the theme's
    float padding = 0;  ///< em
    ChildAlign cross = ChildAlign::stretch, main = ChildAlign::start;
};
class Box {
  public:
    Box(Ui& ui, Axis axis, const BoxOptions& options);
    ~Box() { ui_.close(); }
    Box(const Box&) = delete;
    Box& operator=(const Box&) = delete;

  private:
    Ui& ui_;
};
struct Row : Box {
    explicit Row(Ui& ui, const BoxOptions& options = {.cross = ChildAlign::center}) : Box(ui, Axis::x, options) {}
};
struct Column : Box {
    explicit Column(Ui& ui, const BoxOptions& options = {}) : Box(ui, Axis::y, options) {}
};
/// A ground with a name: F6 goes from one to the next.
class Panel {
  public:
    Panel(Ui& ui, std::string_view label,
          const BoxOptions& options = {.width = grow(), .height = grow(), .padding = 0.6F});
    ~Panel() { ui_.close(); }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

  private:
    Ui& ui_;
};
/// What is left over goes here.
void spacer(Ui& ui, float weight = 1);
/// Nothing, of so many em along the parent's axis.
void space(Ui& ui, float ems);

}  // namespace lapfx::ui
