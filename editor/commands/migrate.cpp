// lapfx migrate: an older preset or scene becomes today's version, in today's form.
#include <iostream>

#include "commands/command.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/printable.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

constexpr std::size_t longest = std::size_t{1} << 30;  // bytes; check_document() has refused longer ones

/// Loading reads every version that was ever released, and writing gives the newest: every key, in the table's order.
void migrate(const std::string& file) {
    const CheckedDocument found = check_document(file);
    const std::string now = found.kind == "preset" ? write_preset(load_preset(file)) : write_scene(load_scene(file));
    const bool same = read_file(file, longest) == now;
    allow_rewriting(file);
    if (!same) write_file(file, now);
    std::cout << printable(file) << ": " << found.kind << " \"" << printable(found.name)
              << (same ? "\" is already as this version writes it\n" : "\" rewritten in the current version\n");
}

}  // namespace

Verb migrate_verb() {
    const auto files = std::make_shared<std::vector<std::string>>();
    Verb verb{.name = "migrate",
              .help = "Update presets and scenes to the current version, with every key written out",
              .footer = "Example:\n  lapfx migrate presets/slow_ooze.json",
              .run = [files] {
                  for (const std::string& file : *files) check_document(file);  // all or none
                  for (const std::string& file : *files) migrate(file);
              }};
    verb.argument("FILE.json", "Presets and scenes; rewritten in place", files.get(), {.required = true});
    return verb;
}

}  // namespace lapfx::commands
