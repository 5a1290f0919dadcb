// How panels are arranged: named layouts, the standard ones and the user's own. Which panels and which standard layouts
// there are is said by whoever has the panels (panels/workspace.cpp).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/dock_layout.h"

namespace lapfx::app {

/// One that comes with the program.
struct StandardLayout {
    std::string_view name;
    ui::DockLayout (*make)();
};

class Layouts {
  public:
    /// Once, before all else: what there is. The first layout is shown. A panel that a layout does not name comes into
    /// its first group. `renamed`: for layouts that an earlier version kept. Throws std::logic_error where one names a
    /// panel that is none: a mistake of the program.
    void set_panels(std::vector<std::string_view> names, std::vector<StandardLayout> standard,
                    std::vector<ui::RenamedPanel> renamed = {});
    /// Names of all panels; also their paths in the semantic tree, below "Workspace".
    std::span<const std::string_view> panels() const { return panels_; }
    std::span<const ui::RenamedPanel> renamed() const { return renamed_; }

    ui::DockLayout shown;  ///< what is on the screen, and is changed by what the user does
    /// The window's size, in em. A small one has no room for panels beside each other: they are tabs of one group then,
    /// the layout's main one in front, until the window is larger again.
    void fit_window(glm::vec2 ems);
    bool stacked() const { return stacked_; }
    /// How panels are arranged, or will be again, in a window with room; panels that were closed or opened in a small
    /// window are so here, too.
    const ui::DockLayout& arranged() const;
    const std::string& name() const { return name_; }
    /// Whether the panel is in front of its tabs.
    bool seen(std::string_view panel) const;
    /// Brings it there, also if it was closed.
    void bring_to_front(std::string_view panel);
    /// The names of the standard layouts ("Tune", "Key", "Compare", "Stage") and of the user's own.
    std::vector<std::string> names() const;
    /// Returns false if there is no layout of this name; case does not matter.
    bool choose(std::string_view name);
    void reset() { choose(name_); }
    /// Keeps what is shown under this name; a standard name is refused (false).
    bool keep(const std::string& name);
    bool remove(const std::string& name);
    bool standard(std::string_view name) const;
    const std::vector<ui::NamedLayout>& own() const { return own_; }
    void set_own(std::vector<ui::NamedLayout> own) { own_ = std::move(own), ++version_; }
    /// Grows with every change of own().
    std::uint32_t version() const { return version_; }

  private:
    void show(ui::DockLayout layout);
    void check(const ui::DockLayout& layout, std::string_view name) const;

    std::vector<std::string_view> panels_;
    std::vector<StandardLayout> standard_;
    std::vector<ui::RenamedPanel> renamed_;
    mutable ui::DockLayout wide_;  ///< while it is stacked; arranged() brings it up to date
    bool stacked_ = false;
    std::uint32_t version_ = 0;
    std::string name_;
    std::vector<ui::NamedLayout> own_;
};

}  // namespace lapfx::app
