// lapfx_bench PART [OPTION ...]: what `lapfx bench` starts; its parts and options are in editor/commands/bench.cpp.
#include <map>
#include <string_view>

#include "bench/benches.h"
#include "commands/options.h"
#include "commands/program.h"
#include "commands/start_beside.h"

namespace lapfx::bench {

namespace {

const std::map<std::string_view, BenchReport (*)(const BenchOptions&)> benches = {
    {"bleeding", bench_bleeding}, {"editor", bench_editor},   {"fit", bench_fit},
    {"frame", bench_frame},       {"measure", bench_measure}, {"streaming", bench_streaming},
};

/// The comparison with Dear ImGui is a program of its own, because nothing else links that.
[[noreturn]] void run_ui(const BenchOptions& options) {
    commands::check_output("--json", options.json);
    std::vector<std::string> arguments;
    if (options.short_form) arguments.emplace_back("--short");
    if (!options.json.empty()) arguments.insert(arguments.end(), {"--json", options.json});
    commands::start_beside("lapfx_bench_ui", arguments,
                           "not built: `bench ui` needs it; configure with LAPFX_TESTS=ON");
}

void run(const std::string& part, const BenchOptions& options) {
    if (part == "ui") run_ui(options);
    for (const auto& [option, file] :
         {std::pair{"--json", &options.json}, {"--plot", &options.plot}, {"--frames", &options.frames}})
        commands::check_output(option, *file);
    BenchReport report = benches.at(part)(options);
    report.short_form = options.short_form;
    print(report);
    if (!options.json.empty()) write_json(report, options.json);
}

}  // namespace

}  // namespace lapfx::bench

int main(int argc, char** argv) {
    return lapfx::commands::run_verb(argc, argv, [] { return lapfx::commands::bench_verb(lapfx::bench::run); });
}
