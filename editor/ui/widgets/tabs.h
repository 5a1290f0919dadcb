// Pages of which one is shown.
//
//     constexpr std::string_view names[] = {"Matte", "Scopes"};
//     if (ui::Tabs tabs(u, "Views", active, names); active == 0) ...
//
// Press, Left, Right, Home and End choose; Ctrl+PageUp and Ctrl+PageDown from anywhere inside. Where they can be
// closed: the cross, the middle button, Delete. What does not fit scrolls (Shift and wheel), and a button at the end
// lists them all. In the tree a tab is "Views/tabs/Matte".
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct TabOptions {
    bool closable = false;
    bool draggable = false;  ///< `grabbed` is told
    Size width = grow();
};

/// Numbers of tabs; -1: none.
struct TabEvents {
    int chosen = -1;
    int pressed = -1;        ///< the pointer pressed it, whether or not it is in front already
    int closed = -1;         ///< is to be closed: the program takes it away
    int place = 0;           ///< so many have their middle left of the pointer: where a dropped one would stand
    int grabbed = -1;        ///< is being dragged now
    int context = -1;        ///< right button, or the Menu key: for a menu
    int dropped = -1;        ///< was let go after having been dragged
    bool cancelled = false;  ///< a drag was given up
};

/// The tabs alone. `active` is clamped.
TabEvents tab_strip(Ui& ui, std::string_view label, int active, std::span<const std::string_view> names,
                    const TabOptions& options = {});

struct TabsOptions {
    Size width = grow(), height = grow();
    float padding = 0.6F;  ///< em, around the page
};

/// Tabs and, until its end, the page that is shown.
class Tabs {
  public:
    /// `active` is clamped, and changes when another one is chosen.
    Tabs(Ui& ui, std::string_view label, int& active, std::span<const std::string_view> names,
         const TabsOptions& options = {});
    ~Tabs();
    Tabs(const Tabs&) = delete;
    Tabs& operator=(const Tabs&) = delete;

    bool changed() const { return changed_; }

  private:
    Ui& ui_;
    bool changed_ = false;
};

}  // namespace lapfx::ui
