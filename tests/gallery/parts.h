// What pages are put together from.
#pragma once

#include "ui/core/ui.h"
#include "ui/value/number.h"

namespace lapfx::gallery {

/// Examples that belong together, under a title.
class Part {
  public:
    Part(ui::Ui& ui, std::string_view title);
    ~Part() { ui_.close(); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

  private:
    ui::Ui& ui_;
};

/// A row of examples behind a caption. In the tree they are children of the caption.
class Line {
  public:
    Line(ui::Ui& ui, std::string_view caption, bool disabled = false);
    ~Line();
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

  private:
    ui::Ui& ui_;
    bool disabled_;
};

/// `value` as text that lasts as long as the frame.
std::string_view text_of(ui::Ui& ui, double value, int decimals = 0);

}  // namespace lapfx::gallery
