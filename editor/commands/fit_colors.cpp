#include "commands/fit_colors.h"

namespace lapfx::commands {

namespace {

std::vector<std::string> free_keys(bool scene_is_written) {
    std::vector<std::string> keys(match::color_keys().begin(), match::color_keys().end());
    if (!scene_is_written) std::erase_if(keys, [](const std::string& key) { return key.starts_with("camera."); });
    return keys;
}

/// What is measured changes a little with the colours. False: it was ended.
bool draw_again(match::FitResult& result, std::span<const match::TargetPoint> target, match::PreviewCurve& curve,
                const lapfx::Progress& progress) {
    std::vector<double> times;
    for (const match::TargetPoint& aim : target) times.push_back(aim.time);
    std::optional<std::vector<match::FrameAmounts>> frames =
        curve.measure(result.tuned.scene, result.tuned.preset, times, {.progress = progress});
    if (!frames) return false;
    result.after = std::move(*frames);
    result.blood_after = match::misfit(target, result.after, &match::TargetPoint::blood);
    result.veil_after = match::misfit(target, result.after, &match::TargetPoint::veil);
    ++result.curves;
    return true;
}

}  // namespace

void watch_colors(match::MeasureOptions& options, match::PeakColors& colors) {
    options.measured = [&colors](Image& frame, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
        colors.add(frame, estimator, amounts);
    };
}

std::vector<std::string> fit_colors(match::FitResult& result, const match::PeakColors& reference,
                                    std::span<const match::TargetPoint> target, match::PreviewCurve& curve,
                                    bool scene_is_written, const lapfx::Progress& progress) {
    const match::ColorMatch found = match::match_colors(
        {.start = result.tuned,
         .reference = reference.at_peak(),
         .keys = free_keys(scene_is_written),
         .draw = [&](const match::Tuned& tuned) { return match::drawn_colors(curve, tuned, target, progress); }});
    if (found.drawn == 0) return {"colours: the time ended before the scene was drawn for them; they stay"};
    result.tuned = found.tuned;
    std::vector<std::string> lines = match::likeness_lines(found);
    lines.insert(lines.end(), found.lines.begin(), found.lines.end());
    if (!draw_again(result, target, curve, progress))
        lines.emplace_back("the curves are those before the colours were matched: the time ended");
    if (!scene_is_written) lines.emplace_back("camera.exposure: stays, the scene is written with --fitted-scene only");
    if (found.ended_early) lines.emplace_back("colours: the time ended before they were as near as they can be");
    return lines;
}

}  // namespace lapfx::commands
