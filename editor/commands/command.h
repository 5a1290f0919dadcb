// The verbs of `lapfx`. Each has its own file here and adds itself to the command line; its callback does the work and
// throws lapfx::Error on failure. program.cpp turns that into lines on stderr and an exit code.
#pragma once

namespace CLI {
class App;
}

namespace lapfx::commands {

void add_render(CLI::App& app);
void add_sheet(CLI::App& app);
void add_picture(CLI::App& app);
void add_edit(CLI::App& app);
void add_check(CLI::App& app);
void add_measure(CLI::App& app);
void add_fit(CLI::App& app);
void add_batch(CLI::App& app);
void add_compare(CLI::App& app);
void add_inspect(CLI::App& app);
void add_migrate(CLI::App& app);
void add_bench(CLI::App& app);
void add_gallery(CLI::App& app);
/// Last: it lists the others.
void add_help(CLI::App& app);

}  // namespace lapfx::commands
