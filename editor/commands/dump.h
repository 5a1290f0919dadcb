// The tree of widgets as a file, for tests and scripts.
#pragma once

#include <span>
#include <string>

#include "ui/core/node_parts.h"

namespace lapfx::commands {

/// As JSON where the name ends so, else a line for each node. Throws Error (runtime).
void write_dump(const std::string& file, std::span<const ui::Node> tree);

}  // namespace lapfx::commands
