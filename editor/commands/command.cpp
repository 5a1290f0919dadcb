#include "commands/command.h"

#include <utility>

namespace lapfx::commands {

Verb program_of(std::vector<Verb> verbs) {
    Verb all{.name = "lapfx",
             .help = "Bleeding and surgical smoke for laparoscopic simulators: editor and headless commands.",
             .footer = overview_footer(),
             .is_program = true};
    all.options.push_back({"--version", "", "Print the version"});
    all.parts = std::move(verbs);
    return all;
}

Verb program() {
    std::vector<Verb> verbs;
    for (Verb (*const verb)() :
         {edit_verb, render_verb, sheet_verb, picture_verb, measure_verb, fit_verb, batch_verb, compare_verb,
          inspect_verb, check_verb, migrate_verb, bench_verb, gallery_verb, help_verb})
        verbs.push_back(verb());
    return program_of(std::move(verbs));
}

}  // namespace lapfx::commands
