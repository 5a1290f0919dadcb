// The semantic tree: what a screen reader, a test or a script sees of a frame.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ui/core/node.h"

namespace lapfx::ui {

/// The labels from the outermost node to this one, joined by "/"; nodes without a label are left out.
std::string path_of(std::span<const Node> tree, std::uint32_t index);

/// The node with this path. A path may begin with "**/": anywhere. Throws std::invalid_argument when there is none (it
/// names the nearest) or more than one.
std::uint32_t find(std::span<const Node> tree, std::string_view path);
bool exists(std::span<const Node> tree, std::string_view path);

/// One line a named node, indented: role "label" = value [states] (x y w h).
std::string dump_text(std::span<const Node> tree);
/// {"role", "label", "path", "text", "value", "minimum", "maximum", "step", "states": [...], "rect": [x, y, w, h],
/// "tip", "children": [...]}; keys that would be empty are left out.
std::string dump_json(std::span<const Node> tree);

/// Faults for people who cannot see the UI: nodes that take the keyboard but have no name, and labels that clash.
std::vector<std::string> faults_of(std::span<const Node> tree);

}  // namespace lapfx::ui
