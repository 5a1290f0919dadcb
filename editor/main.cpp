// lapfx: the editor and its headless commands.
#include "commands/command.h"
#include "commands/program.h"

int main(int argc, char** argv) {
    return lapfx::commands::run_program(argc, argv, lapfx::commands::program);
}
