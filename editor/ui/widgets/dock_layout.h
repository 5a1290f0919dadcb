// How panels share a window: a tree of splits with tabs in its leaves. Plain values: the program owns it, copies it for
// undo, and writes it to its settings.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/core/node_parts.h"

namespace lapfx::ui {

struct DockNode {
    // a split: two nodes, `fraction` of the length to the first
    Axis axis = Axis::x;
    float fraction = 0.5F;
    int first = -1, second = -1;  ///< indices into DockLayout::nodes; -1: this is a leaf
    // a leaf: names of panels, one of them in front
    std::vector<std::string> tabs = {};
    int active = 0;

    bool leaf() const { return first < 0; }
    friend bool operator==(const DockNode&, const DockNode&) = default;
};

enum class DockSide : std::uint8_t { center, left, right, top, bottom };

/// Every panel is in one leaf, or closed.
struct DockLayout {
    std::vector<DockNode>
        nodes;  ///< [0] is the root, children come after their parent; never empty once it has been used
    std::vector<std::string> closed;
    friend bool operator==(const DockLayout&, const DockLayout&) = default;

    /// The index of the leaf that has this panel; -1: none has it.
    int find(std::string_view panel) const;
    /// Puts a panel, wherever it was, into `leaf`'s tabs at `position` (-1: the end), or beside that leaf. It comes to
    /// the front. Nothing happens when it is alone in that very leaf. `leaf` must be the index of a leaf (assert).
    void move(std::string_view panel, int leaf, DockSide side, int position = -1);
    /// Takes it off the screen. The last panel stays.
    void close(std::string_view panel);
    /// Brings it to the front; a closed one comes into the first leaf.
    void show(std::string_view panel);
    /// Makes it hold exactly `panels`: unknown names are dropped, missing ones (of a newer version of the program) go
    /// into the first leaf. Fractions and active tabs that are out of range are clamped.
    void fit(std::span<const std::string_view> panels);

  private:
    void take_out(std::string_view panel);
    void drop_leaf(int leaf);
    void compact();
};

/// For first layouts: dock_split(Axis::x, 0.7F, dock_tabs({"View"}), dock_tabs({"Parameters", "Scopes"})).
DockLayout dock_tabs(std::initializer_list<std::string_view> panels);
DockLayout dock_split(Axis axis, float fraction, const DockLayout& first, const DockLayout& second);

struct NamedLayout {
    std::string name;
    DockLayout layout;
};
/// As JSON text. {"version": 1, "layouts": [{"name", "root", "closed"}]}; a node is {"split": "x", "fraction", "first",
/// "second"} or
/// {"tabs": [...], "active"}.
std::string write_layouts(std::span<const NamedLayout> layouts);
/// A panel that had another name in an earlier version of the program.
struct RenamedPanel {
    std::string_view before, now;
};
/// Each with the names that panels have now, and fitted to `panels` (DockLayout::fit). Throws std::invalid_argument,
/// which says what is wrong, when it is not such a text.
std::vector<NamedLayout> read_layouts(std::string_view json, std::span<const std::string_view> panels,
                                      std::span<const RenamedPanel> renamed = {});

}  // namespace lapfx::ui
