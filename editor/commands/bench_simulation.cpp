// Method: CPU time of the calling thread, the best of five runs of each, in turns.
//
// Samples: on the sample scene's organ, with its preset but without clips. Strokes of 0.6 s, one a second, have gone
// by, and the wounds that they opened have bled out; then coagulation is held for 2 s beside them, 1000 samples a
// second and 60 frames, and nothing is drawn. A history of suction is not among it: it costs more. Scene: AmountsModel
// with the organ prepared; from setting preset and events to the last of 1800 amounts.
#include "commands/bench_simulation.h"

#include <algorithm>
#include <limits>

#include "commands/session.h"
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/effects.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace {

constexpr double scene_seconds = 60.0, amounts_per_second = 30.0;
constexpr double rest = 300.0;  // s after the last stroke: its blood stands
constexpr double aside_mm = 20.0;
constexpr int held_frames = 120, samples_per_frame = 17;

/// Where strokes go: a spiral around a place of the organ, on its surface.
glm::dvec3 place_of(const Effects& effects, const glm::dvec3& centre, const glm::dvec3& outside, double turn) {
    const glm::dvec3 aim =
        centre + (2.0 + 0.01 * turn) * glm::dvec3(std::cos(turn), std::sin(turn), std::sin(0.7 * turn));
    const auto hit = effects.pick(outside, aim - outside);
    return hit ? hit->position : centre;
}

std::vector<ToolContact> strokes(const Effects& effects, const glm::dvec3& centre, const glm::dvec3& outside,
                                 int count) {
    std::vector<ToolContact> all;
    for (int i = 0; i < count; ++i)
        for (int part = 0; part < 6; ++part) {
            const double turn = i + 0.1 * part;
            all.push_back({.action = ToolAction::cauterise,
                           .time = turn,
                           .duration = 0.1,
                           .position = part > 0 ? all.back().to : place_of(effects, centre, outside, turn),
                           .to = place_of(effects, centre, outside, turn + 0.1)});
        }
    return all;
}

/// us of CPU for each sample.
double sample_cost(Effects& effects, const Scene& scene, int seconds) {
    // Apart from each other: what the held stroke does to the organ is the same, whatever has been before.
    const glm::dvec3 centre = scene.events.front().position,
                     aside = scene.events.back().to + glm::dvec3(aside_mm, 0, 0);
    effects.set_contacts(strokes(effects, aside, scene.camera.eye, seconds));
    double time = seconds + rest;
    effects.seek(time);
    const double begin = thread_seconds();
    for (int frame = 0; frame < held_frames; ++frame) {
        for (int i = 0; i < samples_per_frame; ++i) {
            time += 0.001;
            effects.tool_queue().push({.time = time,
                                       .position = centre + glm::dvec3(0.002 * frame, 0, 0),
                                       .touching = true,
                                       .action = ToolAction::coagulate});
        }
        effects.seek(time);
    }
    return 1e6 * (thread_seconds() - begin) / (held_frames * samples_per_frame);
}

double scene_cost(const std::shared_ptr<const PreparedOrgan>& organ, const Scene& scene, const Preset& preset) {
    AmountsModel model(organ, {.gravity = scene.gravity});
    const double begin = thread_seconds();
    model.set(preset, scene.events, scene.curves);
    for (int i = 0; i < static_cast<int>(scene_seconds * amounts_per_second); ++i) model.at(i / amounts_per_second);
    return thread_seconds() - begin;
}

}  // namespace

void measure_simulation(BenchReport& report, bool short_form) {
    const int runs = short_form ? 1 : 5;
    const std::filesystem::path data = data_folder();
    const Scene scene = load_scene(data / "samples/lagb.scene.json");
    const Preset preset = load_preset(data / "presets/gastric_banding.json");
    Preset without_clips = preset;
    without_clips.smoke.clips.clear();
    const auto organ = prepare_organ(scene, preset.vessels);
    EffectsOptions options;
    options.gravity = scene.gravity;
    Effects effects(organ, without_clips, options);
    const int histories[] = {10, short_form ? 20 : 600};
    double cost[2], whole = std::numeric_limits<double>::infinity();
    std::fill(cost, cost + 2, whole);
    for (int run = 0; run < runs; ++run) {
        for (int i = 0; i < 2; ++i) cost[i] = std::min(cost[i], sample_cost(effects, scene, histories[i]));
        whole = std::min(whole, scene_cost(organ, scene, preset));
    }
    for (int i = 0; i < 2; ++i)
        report.rows.push_back({.of = {{"what", "sample after " + std::to_string(histories[i]) + " s"}},
                               .measured = {{"cpu_us", cost[i]}}});
    report.rows.push_back({.of = {{"what", "60 s of amounts"}}, .measured = {{"cpu_s", whole}}});
    report.ratios["sample_cost_10min_over_10s"] = cost[1] / cost[0];
    report.ratios["simulation_over_real_time"] = whole / scene_seconds;
}

}  // namespace lapfx::commands
