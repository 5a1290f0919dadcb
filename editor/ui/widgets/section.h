// A part of a panel that folds away under its title.
//
//     if (ui::Section section(u, "Bleeding", {.changed = 3}); section) {
//         ui::param(u, "Speed", ...);
//     }
//
// Click, Enter and space fold it, Left closes, Right opens. Whether it is open is remembered as long as the Ui lives.
// In the tree it is "Bleeding", its title bar "Bleeding/header".
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct SectionButton {
    Icon icon = Icon::none;
    std::string_view label;  ///< its name and tooltip
};

struct SectionOptions {
    int changed = -1;     ///< how many values inside differ from what is stored: shown; -1: not known
    bool open = true;     ///< to begin with
    bool unfold = false;  ///< opens it now, whatever it was
    std::string_view tip = {};
    std::span<const SectionButton> buttons = {};  ///< at the right end of its title
};

class Section {
  public:
    Section(Ui& ui, std::string_view label, const SectionOptions& options = {});
    ~Section();
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

    /// Whether it is open: only then what is inside is built.
    explicit operator bool() const { return open_; }
    /// Which of its buttons was clicked; -1: none.
    int clicked() const { return clicked_; }

  private:
    Ui& ui_;
    bool open_ = false;
    int clicked_ = -1;
};

}  // namespace lapfx::ui
