// The status bar at the bottom of the window.
//
//     ui::StatusBar bar(u);
//     ui::status_text(u, "Document", "plate_0012.exr, 2048 x 1152");
//     ui::spacer(u);
//     ui::status_text(u, "Frame time", "8.1 ms", {.number = true});
#pragma once

#include "ui/widgets/basic.h"

namespace lapfx::ui {

class StatusBar {
  public:
    explicit StatusBar(Ui& ui);
    ~StatusBar() { ui_.close(); }
    StatusBar(const StatusBar&) = delete;
    StatusBar& operator=(const StatusBar&) = delete;

  private:
    Ui& ui_;
};

struct StatusOptions {
    Tone tone = Tone::dim;
    Icon icon = Icon::none;
    bool number = false;        ///< digits of one width; never cut, since a number without its end is another one
    float width = 0;            ///< em at least: what follows does not dance
    std::string_view tip = {};  ///< the text itself where it is cut
};
/// A live text: `label` is what it is called, `text` what is shown. One too long for the window is cut.
void status_text(Ui& ui, std::string_view label, std::string_view text, const StatusOptions& options = {});

}  // namespace lapfx::ui
