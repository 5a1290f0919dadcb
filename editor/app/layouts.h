// How panels are arranged: named layouts, the standard ones and the user's own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/dock_layout.h"

namespace lapfx::app {

/// Names of all panels; also their paths in the semantic tree, below "Workspace".
inline constexpr std::array<std::string_view, 12> panel_names = {"View",      "Preset",    "Clips",   "Keying",
                                                                 "Reference", "Timeline",  "Curves",  "Amounts",
                                                                 "Presets",   "Snapshots", "History", "Scene"};

class Layouts {
  public:
    Layouts();

    ui::DockLayout shown;  ///< what is on the screen, and is changed by what the user does
    /// The window's size, in em. A small one has no room for panels beside each other: they are tabs of one group then,
    /// the layout's main one in front, until the window is larger again.
    void fit_window(glm::vec2 ems);
    bool stacked() const { return stacked_; }
    /// As it is, or will be again, in a window with room, with what has been closed and opened in a small one.
    const ui::DockLayout& arranged() const;
    const std::string& name() const { return name_; }
    /// Whether the panel is in front of its tabs.
    bool seen(std::string_view panel) const;
    /// Of the standard ones ("Tune", "Key", "Compare", "Stage") and the user's own.
    std::vector<std::string> names() const;
    /// False: there is none of this name; case does not matter.
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

    mutable ui::DockLayout wide_;  ///< while it is stacked; arranged() brings it up to date
    bool stacked_ = false;
    std::uint32_t version_ = 0;
    std::string name_;
    std::vector<ui::NamedLayout> own_;
};

}  // namespace lapfx::app
