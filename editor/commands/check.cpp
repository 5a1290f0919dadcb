// lapfx check: validates presets, with their clips, and scenes, or prints their schema.
#include <iostream>

#include "commands/command.h"
#include "commands/session.h"
#include "lapfx/clip.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "lapfx/smoke_notes.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::vector<std::string> files;
    std::string schema;
};

/// Looks at every file before it throws, so that one run shows all there is to mend.
void check_files(const std::vector<std::string>& files) {
    std::vector<Fault> faults;
    for (const std::string& file : files) {
        try {
            const CheckedDocument found = check_document(file);
            if (found.kind == "preset") check_clips(load_preset(file), file, clip_folders());
            std::cout << file << ": " << found.kind << " \"" << found.name << "\", ok\n";
            if (found.kind != "preset") continue;
            for (const std::string& note : smoke_notes(load_preset(file).smoke))
                std::cerr << "lapfx: note: " << file << ": " << note << '\n';
        } catch (const Error& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    std::cout.flush();
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
}

void run(const Options& options) {
    if (options.schema.empty() && options.files.empty())
        throw CLI::RequiredError("check: a FILE, or --schema preset|scene,");
    if (!options.schema.empty()) std::cout << (options.schema == "preset" ? preset_schema() : scene_schema());
    check_files(options.files);
}

}  // namespace

void add_check(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* verb = app.add_subcommand("check", "Validate presets and scenes; every fault is printed");
    verb->add_option("FILE", options->files, "Presets and scenes (.json)");
    verb->add_option("--schema", options->schema, "Print the JSON Schema of this kind of document instead")
        ->check(CLI::IsMember({"preset", "scene"}))
        ->excludes("FILE");
    verb->callback([options] { run(*options); });
}

}  // namespace lapfx::commands
