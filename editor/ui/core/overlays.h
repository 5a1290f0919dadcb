// What lies over the window. Menus (widgets/menu.h), dialogs (shell/dialog.h) and the lists of fields are made with
// this.
#pragma once

#include "ui/core/input.h"

namespace lapfx::ui {

class Overlays : public Input {
  public:
    void open_overlay(std::string_view name, OverlayKind kind, const Placement& placement);
    void close_overlay(std::string_view name);
    void close_top_overlay();
    /// Closes all overlays above this one that can have the keyboard, the top one first. Returns whether there were
    /// any.
    bool close_overlays_over(std::string_view name);
    bool overlay_open(std::string_view name) const;
    /// Open, and no other that can have the keyboard lies over it.
    bool overlay_on_top(std::string_view name) const;
    /// If the overlay is open, opens its node; close_overlay_node() must follow. Else returns null. An overlay that is
    /// not built in a frame is closed. `label`: its name in the tree.
    Node* open_overlay_node(std::string_view name, Role role, std::string_view label, Axis axis);
    void close_overlay_node() { close(); }
    std::size_t overlay_count() const { return overlays_.size(); }

  protected:
    using Input::Input;
    void close_overlay_at(std::size_t index);
    void close_popups();
    void drop_overlays_not_built();
    void remember_anchors();
    void focus_new_overlay();
    std::uint8_t focus_layer() const;
};

}  // namespace lapfx::ui
