// Method: CPU time of the calling thread, the best of five runs of each, in turns.
//
// Samples: on the organ of the sample scene, with its preset but without clips. The history is one stroke of 0.6 s each
// second, cautery, cuts and suction in turns, whose blood has reached its extent. Then a tool is held for 2 s
// 60 mm beside the strokes, with 1000 samples and 60 frames a second, and nothing is drawn. A cut is also measured
// after strokes with clips instead of suction. The ratio is that of the tool with the largest one. Suction is also
// measured 20 mm away, where it removes the blood of the history, which wounds that still flow fill again. Scene:
// AmountsModel with the organ prepared, from setting preset and events to the last of 1800 amounts.
#include "bench/simulation/simulation.h"

#include <algorithm>
#include <limits>

#include "commands/session.h"
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/effects.h"
#include "lapfx/scene.h"

namespace lapfx::bench {

namespace {

constexpr double amounts_per_second = 30.0;
constexpr double rest = 300.0;  // s after the last stroke, when its blood has stopped
constexpr double aside_mm = 60.0, over_mm = 20.0;
constexpr int samples_per_frame = 17;

struct Extent {
    int runs, history, held_frames;  // history: s of the longer one
    double scene_seconds;
};
constexpr Extent whole_extent{5, 600, 120, 60.0}, least_extent{1, 20, 12, 4.0};

/// Where strokes go: a spiral around a place of the organ, on its surface.
glm::dvec3 place_of(const Effects& effects, const glm::dvec3& centre, const glm::dvec3& outside, double turn) {
    const glm::dvec3 aim =
        centre + (2.0 + 0.01 * turn) * glm::dvec3(std::cos(turn), std::sin(turn), std::sin(0.7 * turn));
    const auto hit = effects.pick(outside, aim - outside);
    return hit ? hit->position : centre;
}

std::vector<ToolContact> strokes(const Effects& effects, const glm::dvec3& centre, const glm::dvec3& outside, int count,
                                 ToolAction third) {
    const ToolAction actions[] = {ToolAction::cauterise, ToolAction::cut, third};
    std::vector<ToolContact> all;
    for (int i = 0; i < count; ++i)
        for (int part = 0; part < 6; ++part) {
            const double turn = i + 0.1 * part;
            all.push_back({.action = actions[i % 3],
                           .time = turn,
                           .duration = 0.1,
                           .position = part > 0 ? all.back().to : place_of(effects, centre, outside, turn),
                           .to = place_of(effects, centre, outside, turn + 0.1)});
        }
    return all;
}

struct Cost {
    double us = std::numeric_limits<double>::infinity();  // CPU time of each sample
    Amounts before;                                       // blood and burns that the history left
};

struct Held {
    ToolAction action;
    const char* name;
    double mm;  // to the strokes before
    ToolAction third = ToolAction::suction;
};

Cost sample_cost(Effects& effects, const Scene& scene, int seconds, int held_frames, const Held& held) {
    // They are apart, so that the held stroke has the same effect on the organ with any history.
    const glm::dvec3 centre = scene.events.front().position, aside = centre + glm::dvec3(held.mm, 0, 0);
    effects.set_contacts(strokes(effects, aside, scene.camera.eye, seconds, held.third));
    double time = seconds + rest;
    effects.seek(time);
    const Amounts before = effects.amounts();
    const double begin = thread_seconds();
    for (int frame = 0; frame < held_frames; ++frame) {
        for (int i = 0; i < samples_per_frame; ++i) {
            time += 0.001;
            effects.tool_queue().push({.time = time,
                                       .position = centre + glm::dvec3(0.002 * frame, 0, 0),
                                       .touching = true,
                                       .action = held.action});
        }
        effects.seek(time);
    }
    return {.us = 1e6 * (thread_seconds() - begin) / (held_frames * samples_per_frame), .before = before};
}

double scene_cost(const std::shared_ptr<const PreparedOrgan>& organ, const Scene& scene, const Preset& preset,
                  double seconds) {
    AmountsModel model(organ, {.gravity = scene.gravity});
    const double begin = thread_seconds();
    model.set(preset, scene.events, scene.curves);
    for (int i = 0; i < static_cast<int>(seconds * amounts_per_second); ++i) model.at(i / amounts_per_second);
    return thread_seconds() - begin;
}

}  // namespace

void measure_simulation(BenchReport& report, bool short_form) {
    const Extent& extent = short_form ? least_extent : whole_extent;
    const std::filesystem::path data = commands::data_folder();
    const Scene scene = load_scene(data / "samples/lagb.scene.json");
    const Preset preset = load_preset(data / "presets/gastric_banding.json");
    Preset without_clips = preset;
    without_clips.smoke.clips.clear();
    const auto organ = prepare_organ(scene, preset.vessels);
    EffectsOptions options;
    options.gravity = scene.gravity;
    Effects effects(organ, without_clips, options);
    const int histories[] = {10, extent.history};
    constexpr Held held[] = {{ToolAction::coagulate, "coagulation", aside_mm},
                             {ToolAction::cauterise, "cautery", aside_mm},
                             {ToolAction::cut, "cut", aside_mm},
                             {ToolAction::cut, "cut beside clips", aside_mm, ToolAction::clip},
                             {ToolAction::suction, "suction", aside_mm},
                             {ToolAction::suction, "suction of their blood", over_mm}};
    constexpr std::size_t over_blood = std::size(held) - 1;
    Cost cost[std::size(held)][2];
    double whole = std::numeric_limits<double>::infinity(), worst = 0.0;
    for (int run = 0; run < extent.runs; ++run) {
        for (std::size_t tool = 0; tool < std::size(held); ++tool)
            for (int i = 0; i < 2; ++i) {
                const Cost one = sample_cost(effects, scene, histories[i], extent.held_frames, held[tool]);
                if (one.us < cost[tool][i].us) cost[tool][i] = one;
            }
        whole = std::min(whole, scene_cost(organ, scene, preset, extent.scene_seconds));
    }
    for (std::size_t tool = 0; tool < std::size(held); ++tool) {
        for (int i = 0; i < 2; ++i)
            report.rows.push_back({.of = {{"what", std::string("sample of ") + held[tool].name + " after " +
                                                       std::to_string(histories[i]) + " s"}},
                                   .measured = {{"cpu_us", cost[tool][i].us},
                                                {"wounds_before", static_cast<double>(cost[tool][i].before.wounds)},
                                                {"burnt_mm2_before", cost[tool][i].before.burnt_area}}});
        if (tool != over_blood) worst = std::max(worst, cost[tool][1].us / cost[tool][0].us);
    }
    report.ratios["suction_of_old_blood_10min_over_10s"] = cost[over_blood][1].us / cost[over_blood][0].us;
    const std::string seconds = std::to_string(static_cast<int>(extent.scene_seconds));
    report.rows.push_back({.of = {{"what", seconds + " s of amounts"}}, .measured = {{"cpu_s", whole}}});
    report.ratios["sample_cost_10min_over_10s"] = worst;
    report.ratios["simulation_over_real_time"] = whole / extent.scene_seconds;
}

}  // namespace lapfx::bench
