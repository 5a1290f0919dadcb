// What commands say on stderr, a line each. Names from files are shown so that they cannot drive a terminal.
#pragma once

#include <string>

namespace lapfx::commands {

/// "lapfx: TEXT".
void say(const std::string& text);
/// "lapfx: note: TEXT".
void note(const std::string& text);
/// "lapfx: warning: TEXT".
void warn(const std::string& text);

}  // namespace lapfx::commands
