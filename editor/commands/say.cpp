#include "commands/say.h"

#include <iostream>

#include "lapfx/authoring/printable.h"

namespace lapfx::commands {

void say(const std::string& text) {
    std::cerr << "lapfx: " << printable(text) << '\n';
}

void note(const std::string& text) {
    say("note: " + text);
}

void warn(const std::string& text) {
    say("warning: " + text);
}

}  // namespace lapfx::commands
