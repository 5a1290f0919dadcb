// lapfx bench bleeding: what blood costs per frame on sheets of 10 thousand to a million vertices of equal spacing, for
// 1, 10 and 100 wounds, while they grow and when they have settled.
//
// Method: each figure is the CPU time of the calling thread in Effects::seek(), at 60 frames per second. Every case has
// several fresh runs, of which the best counts; the sizes take turns, so that a temporary load of the machine does not
// affect only one of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/benches.h"
#include "commands/progress.h"
#include "lapfx/effects.h"

namespace lapfx::bench {

namespace {

constexpr double spacing = 0.5;                                     // mm between vertices
constexpr double frame = 1.0 / 60.0, growth = 3.5, settled = 60.0;  // s
constexpr int wound_counts[] = {1, 10, 100};
constexpr std::size_t sizes = 3;

/// Vertices along the side of each sheet, and how often each case is run.
struct Extent {
    int sides[sizes];
    int runs;
};
constexpr Extent whole{{100, 316, 1000}, 5}, least{{20, 30, 40}, 1};

/// Tissue with gentle waves, `side` vertices square, centred on the origin.
Organ sheet(int side) {
    Organ organ;
    const auto n = static_cast<std::uint32_t>(side);
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t x = 0; x < n; ++x) {
            const glm::dvec2 p = (glm::dvec2(x, z) - 0.5 * (side - 1)) * spacing;
            organ.positions.emplace_back(p.x, 1.5 * std::sin(0.25 * p.x) * std::cos(0.2 * p.y), p.y);
        }
    for (std::uint32_t z = 0; z + 1 < n; ++z)
        for (std::uint32_t x = 0; x + 1 < n; ++x) {
            const std::uint32_t a = z * n + x, b = a + 1, c = a + n, d = c + 1;
            organ.indices.insert(organ.indices.end(), {a, c, d, a, d, b});
        }
    organ.normals.assign(organ.positions.size(), glm::vec3(0, 1, 0));
    organ.tangents.assign(organ.positions.size(), glm::vec4(1, 0, 0, 1));
    organ.uvs.assign(organ.positions.size(), glm::vec2(0));
    organ.colors.assign(organ.positions.size(), glm::vec4(1));
    organ.materials = {Material{}};
    organ.parts = {
        {.name = "sheet", .first_index = 0, .index_count = static_cast<std::uint32_t>(organ.indices.size())}};
    return organ;
}

/// `count` cuts at time 0, spread over the middle 20 mm.
std::vector<ToolContact> cuts(int count) {
    std::vector<ToolContact> all;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.39996323 * i, radius = 10.0 * std::sqrt(static_cast<double>(i) / count);
        const glm::dvec3 place(radius * std::cos(angle) + 0.13, 0.0, radius * std::sin(angle) + 0.21);
        all.push_back({.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = place, .to = place});
    }
    return all;
}

struct Figures {
    double growing_us = std::numeric_limits<double>::infinity(), worst_us = growing_us, settled_us = growing_us;
    double growing_bytes = 0.0, settled_bytes = 0.0;
};

/// One run of one case, its best figures kept.
void measure(const Organ& organ, int wounds, Figures& best) {
    Effects effects(organ, Preset{});
    effects.seek(0.0);  // sends all once
    const std::vector<ToolContact> contacts = cuts(wounds);
    effects.set_contacts(contacts);
    double bytes = 0.0, worst = 0.0, total = 0.0;
    int frames = 0;
    for (double time = frame; time < growth; time += frame, ++frames) {
        const double start = thread_seconds();
        effects.seek(time);
        const double cost = thread_seconds() - start;
        total += cost;
        worst = std::max(worst, cost);
        bytes += static_cast<double>(effects.uploaded());
    }
    best.growing_us = std::min(best.growing_us, 1e6 * total / frames);
    best.worst_us = std::min(best.worst_us, 1e6 * worst);
    best.growing_bytes = bytes / frames;
    effects.seek(settled);
    bytes = 0.0;
    const double start = thread_seconds();
    for (int i = 1; i <= 1000; ++i) {
        effects.seek(settled + i * frame);
        bytes += static_cast<double>(effects.uploaded());
    }
    best.settled_us = std::min(best.settled_us, 1e6 * (thread_seconds() - start) / 1000.0);
    best.settled_bytes = bytes / 1000.0;
}

/// Cost of the paper's way, us of CPU time: every frame computes the value of every vertex from known distances.
double sweep_us(std::size_t vertices) {
    std::vector<float> distances(vertices, 3.0f), values(vertices);
    volatile float source = 5.0f;
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 20; ++run) {
        const double start = thread_seconds();
        for (std::size_t v = 0; v < vertices; ++v) values[v] = source - distances[v];
        best = std::min(best, 1e6 * (thread_seconds() - start));
    }
    return best;
}

BenchRow row_of(int side, int wounds, const Figures& figures) {
    return {.of = {{"vertices", std::to_string(side * side)}, {"wounds", std::to_string(wounds)}},
            .measured = {{"growing_cpu_us", figures.growing_us},
                         {"growing_worst_us", figures.worst_us},
                         {"growing_bytes", figures.growing_bytes},
                         {"settled_cpu_us", figures.settled_us},
                         {"settled_bytes", figures.settled_bytes}}};
}

}  // namespace

BenchReport bench_bleeding(const BenchOptions& options) {
    const auto& [sides, runs] = options.short_form ? least : whole;
    const Context context = Context::create(Backend::automatic);
    BenchReport report{.bench = "bleeding", .renderer = context.renderer(), .rows = {}, .ratios = {}, .table = {}};
    std::vector<Organ> organs;
    for (const int side : sides) organs.push_back(sheet(side));
    commands::Progress progress("measuring", runs * static_cast<int>(std::size(wound_counts) * sizes));
    for (const int wounds : wound_counts) {
        Figures figures[sizes];
        for (int run = 0; run < runs; ++run)
            for (std::size_t i = 0; i < sizes; ++i) {
                measure(organs[i], wounds, figures[i]);
                progress.step();
            }
        for (std::size_t i = 0; i < sizes; ++i) report.rows.push_back(row_of(sides[i], wounds, figures[i]));
        const std::string suffix = wounds == 1 ? "" : "_" + std::to_string(wounds) + "_wounds";
        report.ratios["bleeding_1m_over_10k" + suffix] = figures[2].growing_us / figures[0].growing_us;
        report.ratios["bleeding_bytes_1m_over_10k" + suffix] = figures[2].growing_bytes / figures[0].growing_bytes;
        report.ratios["bleeding_settled_over_growing" + suffix] = figures[2].settled_us / figures[2].growing_us;
        if (wounds > 1) continue;
        const double sweep = sweep_us(organs.back().positions.size());
        report.rows.push_back(
            {.of = {{"vertices", std::to_string(organs.back().positions.size())}, {"wounds", "sweep"}},
             .measured = {{"growing_cpu_us", sweep},
                          {"growing_bytes", 8.0 * static_cast<double>(organs.back().positions.size())}}});
        report.ratios["bleeding_1m_over_sweep"] = figures[2].growing_us / sweep;
    }
    return report;
}

}  // namespace lapfx::bench
