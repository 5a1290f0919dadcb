// The verbs of `lapfx`. Each has its own file here, says what it takes (command_line.h) and throws lapfx::Error on
// failure. program.cpp turns that into lines on stderr and an exit code.
#pragma once

#include "commands/command_line.h"

namespace lapfx::commands {

Verb render_verb();
Verb sheet_verb();
Verb picture_verb();
Verb edit_verb();
Verb check_verb();
Verb measure_verb();
Verb fit_verb();
Verb batch_verb();
Verb compare_verb();
Verb inspect_verb();
Verb migrate_verb();
Verb bench_verb();
Verb gallery_verb();
Verb help_verb();

/// `lapfx` with all of them.
Verb program();
/// The program has these verbs alone.
Verb program_of(std::vector<Verb> verbs);

/// What the help of the program says below its lists.
std::string overview_footer();

}  // namespace lapfx::commands
