#include "commands/command.h"
namespace lapfx::commands {
void add_render(CLI::App&) {}
}  // namespace lapfx::commands
