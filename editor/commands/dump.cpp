#include "commands/dump.h"

#include "lapfx/authoring/file.h"
#include "ui/core/tree.h"

namespace lapfx::commands {

void write_dump(const std::string& file, std::span<const ui::Node> tree) {
    write_file(file, file.ends_with(".json") ? ui::dump_json(tree) + "\n" : ui::dump_text(tree));
}

}  // namespace lapfx::commands
