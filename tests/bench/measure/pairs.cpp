// lapfx bench measure --pairs SMOKY CLEAR: real recordings with and without smoke, ranked by what is measured.
#include <cstdio>

#include "bench/benches.h"
#include "bench/measure/ranked_pairs.h"
#include "commands/progress.h"

namespace lapfx::bench {

BenchReport bench_measure_pairs(const BenchOptions& options) {
    commands::Progress shown("measuring", 100);
    int percent = 0;
    const auto pairs = rank_pairs(options.pairs[0], options.pairs[1], 4, [&](double share) {
        for (; percent < static_cast<int>(100 * share); ++percent) shown.step();
        return true;
    });
    BenchReport report{.bench = "measure", .renderer = "nothing is drawn", .rows = {}, .ratios = {}, .table = {}};
    report.table = "veil of each with the other as its baseline; every fourth frame of videos\n\n";
    double right = 0.0;
    for (const RankedPair& pair : pairs) {
        right += pair.right() ? 1.0 : 0.0;
        report.rows.push_back({.of = {{"smoky", pair.smoky}, {"clear", pair.clear}},
                               .measured = {{"frames", static_cast<double>(pair.frames)},
                                            {"frames_missing", static_cast<double>(pair.missing)},
                                            {"frames_not_measurable", static_cast<double>(pair.not_measurable)},
                                            {"veil_of_smoky", pair.of_smoky},
                                            {"veil_of_clear", pair.of_clear}}});
        char line[400];
        std::snprintf(line, sizeof line, "%-28.100s %6.3f   %-28.100s %6.3f   %s\n", pair.smoky.c_str(), pair.of_smoky,
                      pair.clear.c_str(), pair.of_clear, pair.right() ? "right" : "WRONG");
        report.table += line;
        for (const std::string& note : pair.notes()) report.table += "  " + note + "\n";
    }
    report.ratios["smoky_ranked_above_clear"] = right / static_cast<double>(pairs.size());
    return report;
}

}  // namespace lapfx::bench
