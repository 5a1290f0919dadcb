#include "bench/fit/cases.h"

#include <algorithm>
#include <cmath>

#include "commands/session.h"
#include "lapfx/amounts.h"
#include "lapfx/prepared_organ.h"
#include "match/scene/seen_places.h"
#include "match/scene/view_share.h"

namespace lapfx::bench {

namespace {

constexpr std::uint32_t part = 40;  // scenes take this part of the random numbers (random.h)
constexpr double apart = 22.0;      // mm between burn and cut: heat must not close the wound
constexpr double sampled = 0.01;    // s
constexpr int most_tries = 50;

/// A view with two places, in its middle, for a burn and a cut.
CaseScene draw_scene(Random& random, PreparedViews& prepared) {
    for (int tried = 0; tried < most_tries; ++tried) {
        DrawnView view = draw_view(random);
        CaseScene scene{.tuned = {view.scene, view.preset}, .label = view.labels["organ"], .organ = prepared.of(view)};
        const std::vector<match::SeenPlace> places =
            match::seen_places(scene.organ->organ(), view.scene.camera, case_aspect, apart, {}, 4);
        if (places.size() < 2) continue;
        Scene& s = scene.tuned.scene;
        s.duration = case_duration;
        const auto at = [&](std::size_t place, ToolAction action, double time, double duration) {
            s.events.push_back({.action = action,
                                .time = time,
                                .duration = duration,
                                .position = places[place].position,
                                .to = places[place].position});
        };
        const std::size_t cut = static_cast<std::size_t>(random.below(static_cast<int>(places.size())));
        at((cut + 1) % places.size(), ToolAction::coagulate, random.in(0.6, 3.0), random.in(1.5, 4.0));
        at(cut, ToolAction::cut, random.in(0.6, 4.0), 0.0);
        scene.tuned.preset.bleeding.pulse_strength = 0.0;
        return scene;
    }
    throw Error(Failure::runtime,
                Fault{.file = "", .place = "bench fit", .reason = "no view has two places for tools"});
}

bool opens_a_wound(const CaseScene& scene) {
    return seen_truth(scene.tuned, scene.organ).blood_pace > 0.0;
}

CaseScene draw_bleeding_scene(Random& random, PreparedViews& prepared) {
    for (int tried = 0; tried < most_tries; ++tried)
        if (CaseScene scene = draw_scene(random, prepared); opens_a_wound(scene)) return scene;
    throw Error(Failure::runtime, Fault{.file = "", .place = "bench fit", .reason = "no cut of these views bleeds"});
}

/// Smoke is as dense as a drawn peak asks for. False: the scene does not show enough to measure.
bool draw_hidden(Random& random, CaseScene& scene, const std::function<ShownPeaks(const CaseScene&)>& peaks_of) {
    Preset& preset = scene.tuned.preset;
    preset.bleeding.speed = random.log_in(1.5, 8.0);
    preset.bleeding.max_extent = random.log_in(6.0, 20.0);
    double &haze = preset.smoke.haze.accumulation, &plume = preset.smoke.plume.density;
    haze = random.log_in(0.06, 0.25);
    preset.smoke.haze.ventilation = random.log_in(0.05, 0.3);
    plume = random.in(0.1, 0.5);
    const double depth = random.log_in(least_peak_depth, most_peak_depth);
    const ShownPeaks peaks = peaks_of(scene);
    if (peaks.blood < least_peak_blood || peaks.depth <= 0.0) return false;
    const double denser = depth / peaks.depth;
    haze *= denser, plume *= denser;
    if (!check(preset_table(), &preset).empty()) return false;
    const ShownPeaks now = peaks_of(scene);
    return now.depth >= least_peak_depth && now.depth <= most_peak_depth;
}

CaseScene draw_hidden_scene(Random& random, PreparedViews& prepared,
                            const std::function<ShownPeaks(const CaseScene&)>& peaks_of) {
    for (int tried = 0; tried < most_tries; ++tried) {
        CaseScene scene = draw_bleeding_scene(random, prepared);
        if (draw_hidden(random, scene, peaks_of)) return scene;
    }
    throw Error(Failure::runtime,
                Fault{.file = "", .place = "bench fit", .reason = "no scene shows enough blood and smoke"});
}

}  // namespace

FitCase draw_fit_case(std::uint32_t seed, int number, PreparedViews& prepared,
                      const std::function<ShownPeaks(const CaseScene&)>& peaks_of) {
    Random random(seed, part, static_cast<std::uint32_t>(number));
    FitCase drawn{.hidden = draw_hidden_scene(random, prepared, peaks_of), .fitted = {}};
    do {
        drawn.fitted = draw_bleeding_scene(random, prepared);
    } while (drawn.fitted.label == drawn.hidden.label);
    const VesselParameters vessels = drawn.fitted.tuned.preset.vessels;
    drawn.fitted.tuned.preset = load_preset(commands::data_folder() / "presets" / "gastric_banding.json");
    drawn.fitted.tuned.preset.vessels = vessels;
    return drawn;
}

SeenTruth seen_truth(const document::Content& tuned, const std::shared_ptr<const PreparedOrgan>& organ) {
    SeenTruth truth;
    AmountsModel model(organ, {.gravity = tuned.scene.gravity});
    model.set(tuned.preset, tuned.scene.events, tuned.scene.curves);
    double burning = 0.0, emitted = 0.0, last = 0.0;
    bool begun = false;
    for (double time = 0.0; time < tuned.scene.duration; time += sampled) {
        const double emission = model.at(time).emission;
        if (emission <= 0.0) continue;
        if (!begun) truth.burn_start = time;
        begun = true, last = time;
        burning += sampled, emitted += sampled * emission;
    }
    truth.smoke_rate = burning > 0.0 ? tuned.preset.smoke.haze.accumulation * emitted / burning : 0.0;
    truth.ventilation = tuned.preset.smoke.haze.ventilation;
    truth.clears_for = tuned.scene.duration - last;
    model.at(tuned.scene.duration);
    for (const WoundStatus& status : model.wounds()) {
        const Organ& shape = organ->organ();
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < shape.positions.size(); ++i)
            if (glm::distance(glm::dvec3(shape.positions[i]), status.wound.position) <
                glm::distance(glm::dvec3(shape.positions[nearest]), status.wound.position))
                nearest = i;
        const double scale = std::sqrt(match::share_per_mm2(tuned.scene.camera, case_aspect, status.wound.position,
                                                            glm::dvec3(shape.normals[nearest])));
        if (truth.blood_pace > 0.0) continue;  // the first wound
        truth.cut_start = status.wound.start;
        truth.blood_pace = scale * tuned.preset.bleeding.speed * status.wound.strength;
        truth.blood_extent = scale * tuned.preset.bleeding.max_extent;
        truth.blood_stops = status.extent >= tuned.preset.bleeding.max_extent;
    }
    return truth;
}

}  // namespace lapfx::bench
