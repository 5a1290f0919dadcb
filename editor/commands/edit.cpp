#include "commands/command.h"
namespace lapfx::commands {
void add_edit(CLI::App&) {}
}  // namespace lapfx::commands
