#include "bench/report.h"

#include <algorithm>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "lapfx/authoring/file.h"

namespace lapfx::bench {

namespace {

/// The processor's name from Linux.
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
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
    if (report.short_form) std::cout << "short form: these figures show that the bench works, and nothing else\n\n";
    std::cout << report.table;
    for (const BenchRow& row : report.rows) {
        if (!report.table.empty()) break;
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
        {"short", report.short_form},
        {"machine",
         {{"processor", processor()}, {"cores", std::thread::hardware_concurrency()}, {"renderer", report.renderer}}},
        {"results", std::move(results)},
        {"ratios", report.ratios}};
    write_file(path, whole.dump(2) + "\n");
}

}  // namespace lapfx::bench
