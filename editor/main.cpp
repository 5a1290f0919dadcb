// lapfx: the editor and its headless commands.
#include <algorithm>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/program.h"

int main(int argc, char** argv) {
    using namespace lapfx::commands;
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    return run_program(words, [](CLI::App& app) {
        add_edit(app);
        add_render(app);
        add_sheet(app);
        add_picture(app);
        add_measure(app);
        add_fit(app);
        add_batch(app);
        add_compare(app);
        add_inspect(app);
        add_check(app);
        add_migrate(app);
        add_bench(app);
        add_gallery(app);
        add_help(app);
    });
}
