// lapfx bench: figures that compare within one run.
#include "commands/bench.h"

#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "commands/command.h"
#include "commands/options.h"
#include "lapfx/file.h"

namespace lapfx::commands {

namespace {

/// The processor's name, where Linux tells it.
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

struct Options {
    std::string json;
};

void run(BenchReport (*bench)(), const Options& options) {
    if (!options.json.empty()) check_folder(options.json);
    const BenchReport report = bench();
    print(report);
    if (!options.json.empty()) write_json(report, options.json);
}

}  // namespace

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void print(const BenchReport& report) {
    std::cout << report.bench << " on " << processor() << ", " << std::thread::hardware_concurrency() << " cores; "
              << report.renderer << "\n\n";
    for (const BenchRow& row : report.rows) {
        for (const auto& [key, value] : row.of) std::cout << key << ' ' << std::setw(9) << std::left << value << ' ';
        std::cout << " |";
        for (const auto& [key, value] : row.measured)
            std::cout << "  " << key << ' ' << std::setw(10) << std::right << std::setprecision(4) << value;
        std::cout << '\n';
    }
    std::cout << '\n';
    for (const auto& [name, value] : report.ratios) std::cout << name << ' ' << std::setprecision(3) << value << '\n';
}

void write_json(const BenchReport& report, const std::filesystem::path& path) {
    nlohmann::json results = nlohmann::json::array();
    for (const BenchRow& row : report.rows) {
        nlohmann::json entry(row.of);
        for (const auto& [key, value] : row.measured) entry[key] = value;
        results.push_back(std::move(entry));
    }
    const nlohmann::json whole{
        {"bench", report.bench},
        {"machine",
         {{"processor", processor()}, {"cores", std::thread::hardware_concurrency()}, {"renderer", report.renderer}}},
        {"results", std::move(results)},
        {"ratios", report.ratios}};
    write_file(path, whole.dump(2) + "\n");
}

void add_bench(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("bench", "Measure speed as ratios within one run");
    verb->require_subcommand(1);
    const auto add = [verb](const char* name, const char* help, BenchReport (*bench)()) {
        auto options = std::make_shared<Options>();
        CLI::App* part = verb->add_subcommand(name, help);
        part->add_option("--json", options->json, "Write the figures to this file too");
        part->callback([bench, options] { run(bench, *options); });
    };
    add("bleeding", "CPU time and bytes per frame of blood on small and large organs", bench_bleeding);
}

}  // namespace lapfx::commands
