// Writes the sample organs: make_sample_organs FOLDER [--size PIXELS] [lagb] [liver_lobe] [hook_cautery]
//
// The same seeds give the same bytes. PIXELS is the side of the largest texture, 2048 by default.
#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

#include "models.h"

int main(int argc, char** argv) {
    CLI::App app("Writes the sample organs as binary glTF");
    std::filesystem::path folder;
    int size = 2048;
    std::vector<std::string> names;
    app.add_option("folder", folder, "where to write")->required()->check(CLI::ExistingDirectory);
    app.add_option("names", names, "lagb, liver_lobe, hook_cautery; all unless told");
    app.add_option("--size", size, "side of the largest texture, pixels")->check(CLI::Range(128, 4096));
    CLI11_PARSE(app, argc, argv);
    const auto wanted = [&](const std::string& name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    try {
        if (wanted("lagb")) organs::make_lagb(folder, size);
        if (wanted("liver_lobe")) organs::make_liver_lobe(folder, size);
        if (wanted("hook_cautery")) organs::make_hook_cautery(folder);
    } catch (const std::exception& error) {
        std::cerr << "make_sample_organs: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
