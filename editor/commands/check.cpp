#include "commands/command.h"
namespace lapfx::commands { void add_check(CLI::App&) {} }
