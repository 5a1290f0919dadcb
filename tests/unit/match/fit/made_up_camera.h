// A scene of a cut and a burn, a camera that sees more or less of it, and what a fit finds for one.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "lapfx/prepared_organ.h"
#include "match/fit/fit.h"
#include "match/scene/core_amounts.h"
#include "support/meshes.h"

namespace lapfx::match::made_up {

inline constexpr double seconds = 14.0;

/// A cut and a burn on a plane.
inline document::Content scene() {
    document::Content tuned;
    BleedingParameters& b = tuned.preset.bleeding;
    b.speed = 4.0, b.max_extent = 12.0;
    b.noise_strength = b.gravity_bias = b.crease_bias = b.rivulets = 0.0;
    tuned.preset.smoke.haze.accumulation = 0.12, tuned.preset.smoke.haze.ventilation = 0.05;
    tuned.preset.smoke.clips = {{.file = "smoke.mkv"}};  // there is no smoke without a clip; it is not opened
    tuned.scene.duration = seconds;
    tuned.scene.events = {{.action = ToolAction::cut, .time = 1.0, .duration = 0.0},
                          {.action = ToolAction::coagulate,
                           .time = 2.0,
                           .duration = 4.0,
                           .position = {25.0, 0.0, 0.0},
                           .to = {25.0, 0.0, 0.0}}};
    return tuned;
}

inline const std::shared_ptr<const PreparedOrgan>& organ() {
    static const std::shared_ptr<const PreparedOrgan> one = prepare_organ(test::plane(80.0, 60));
    return one;
}

/// A camera that sees 1.3 of the core's haze, a plume, and blood with a share of its own that is less for large areas.
struct Camera {
    double noise = 0.0;
    std::uint32_t seed = 1;
    bool takes_bright_for_dense = false;  ///< smoke of twice the default's light for twice as much
    double plume_share = 0.0;             ///< of the plume's depth stands out of the veil; 0: that is not measurable
    bool plume_in_mean = true;            ///< else the mean veil, as the estimator's model tells it, has no plume
    CoreAmounts core{organ()};

    std::vector<FrameAmounts> see(const document::Content& tuned, std::span<const double> times) {
        const std::vector<Amounts> amounts = core.at(tuned, times);
        std::mt19937 random(seed);
        std::normal_distribution<double> normal(0.0, 1.0);
        std::vector<FrameAmounts> frames;
        for (std::size_t i = 0; i < times.size(); ++i) {
            FrameAmounts& frame = frames.emplace_back();
            frame.time = times[i];
            const PlumeParameters& plume = tuned.preset.smoke.plume;
            const double plume_depth = 0.15 * plume.density * plume.size / PlumeParameters{}.size;
            double depth = 1.3 * amounts[i].haze + (plume_in_mean ? plume_depth * amounts[i].emission : 0.0);
            if (takes_bright_for_dense) depth *= tuned.preset.smoke.haze.color.r / scene().preset.smoke.haze.color.r;
            const double share = 2e-4 * amounts[i].blood_area;
            const double veil = 1.0 - std::exp(-depth) + 1.0 * noise * normal(random);
            const double blood = share - 0.5 * share * share + 0.2 * noise * normal(random);
            frame.veil = {veil, veil - 0.04, veil + 0.04};
            const double above = plume_share * plume_depth * amounts[i].emission + 0.02 * depth;
            if (plume_share > 0.0) frame.plume = {above, 0.7 * above - 0.004, 1.8 * above + 0.004};
            frame.likeness = 1.0;  // all of the texture is there: nothing is hidden
            frame.blood = {blood, blood - 0.01, blood + 0.01};
        }
        return frames;
    }
};

inline std::vector<double> all_times(double step = 0.04, double until = seconds) {
    std::vector<double> times;
    for (double time = 0.0; time <= until; time += step) times.push_back(time);
    return times;
}

struct Known {
    document::Content hidden = scene();
    std::vector<std::string> keys = {"bleeding.speed", "bleeding.max_extent", "smoke.haze.accumulation",
                                     "smoke.haze.ventilation"};
    double noise = 0.0, until = seconds;
    std::uint32_t seed = 1;
    double plume_share = 0.0;
    bool plume_in_mean = true;
};

inline FitInput input_of(const Known& known, Camera& camera) {
    const document::Content start = scene();
    Camera reference{.noise = known.noise,
                     .seed = known.seed + 100,
                     .plume_share = known.plume_share,
                     .plume_in_mean = known.plume_in_mean};
    camera.plume_share = known.plume_share, camera.plume_in_mean = known.plume_in_mean;
    return {.start = start,
            .parameters = free_parameters(start, known.keys),
            .target = target_of(reference.see(known.hidden, all_times(0.04, known.until)), {.to = seconds}),
            .organ = organ(),
            .draw = [&camera](const document::Content& tuned,
                              std::span<const double> times) { return std::optional(camera.see(tuned, times)); },
            .seed = known.seed};
}

inline FitResult found_for(const Known& known) {
    Camera camera;
    return fit(input_of(known, camera));
}

inline const FittedParameter& of(const FitResult& result, const std::string& key) {
    for (const FittedParameter& p : result.parameters)
        if (p.parameter.key == key) return p;
    throw std::out_of_range(key);
}

inline document::Content hidden(double speed, double extent, double accumulation, double ventilation) {
    document::Content tuned = scene();
    tuned.preset.bleeding.speed = speed, tuned.preset.bleeding.max_extent = extent;
    tuned.preset.smoke.haze.accumulation = accumulation, tuned.preset.smoke.haze.ventilation = ventilation;
    return tuned;
}

}  // namespace lapfx::match::made_up
