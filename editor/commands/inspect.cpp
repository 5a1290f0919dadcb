#include "commands/command.h"
namespace lapfx::commands {
void add_inspect(CLI::App&) {}
}  // namespace lapfx::commands
