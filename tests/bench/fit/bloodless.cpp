#include "bench/fit/bloodless.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <vector>

#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/scene/preview_curve.h"
#include "match/use/fit_scene.h"
#include "match/video/measure.h"

namespace lapfx::bench {

namespace {

bool is_of_bleeding(const match::FittedParameter& fitted) {
    return fitted.parameter.key.starts_with("bleeding.");
}

std::vector<ToolContact> cuts_of(const document::Content& tuned) {
    std::vector<ToolContact> cuts;
    std::ranges::copy_if(tuned.scene.events, std::back_inserter(cuts),
                         [](const ToolContact& event) { return divides(event.action); });
    return cuts;
}

bool is_left_alone(const match::FitResult& result, const document::Content& start) {
    return cuts_of(result.tuned) == cuts_of(start) &&
           std::ranges::all_of(result.parameters, [](const match::FittedParameter& fitted) {
               return !is_of_bleeding(fitted) || fitted.after == fitted.before;
           });
}

void tell_blood(const std::vector<match::FrameAmounts>& frames, BloodlessFit& fitted) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (!measurable(frames[i], match::Curve::blood)) continue;
        fitted.most_blood = std::max(fitted.most_blood, frames[i].blood.value);
        if (frames[i].blood.low > 0.0 && i > 0) fitted.above_error += frames[i].time - frames[i - 1].time;
    }
}

}  // namespace

BloodlessFit fit_bloodless(const std::filesystem::path& video, const CaseScene& scene, const PreviewOptions& preview,
                           const BloodlessEffort& effort) {
    const auto began = std::chrono::steady_clock::now();
    VideoReader reader(video);
    const VideoInfo& info = reader.info();
    BloodlessFit fitted{.video = video.filename().string()};
    try {
        const int every = std::max(1, static_cast<int>(std::lround(effort.apart * info.frames_per_second)));
        const match::Measurement found = match::measure(reader, {.every = every});
        tell_blood(found.frames, fitted);
        const double aspect = static_cast<double>(info.size.x) / info.size.y;
        match::PreviewCurve curve(scene.organ, preview, {.size = match::preview_size(info.size, 0.0, effort.side)});
        const match::SceneFit fit{.start = scene.tuned,
                                  .organ = scene.organ,
                                  .keys = {match::usual_parameters.begin(), match::usual_parameters.end()},
                                  .reference = found.frames,
                                  .to = std::min(found.frames.back().time, scene.tuned.scene.duration),
                                  .step = effort.step,
                                  .aspect = aspect,
                                  .seed = effort.seed,
                                  .rounds = effort.rounds};
        const match::FitResult result = *match::fit_scene(fit, curve).result;
        fitted.fitted = true;
        fitted.left_alone = is_left_alone(result, scene.tuned);
        fitted.veil_rms = result.veil_after;
        if (const auto speed = std::ranges::find_if(result.parameters, is_of_bleeding);
            speed != result.parameters.end())
            fitted.why = speed->why;
    } catch (const Error& error) {
        if (error.failure() != Failure::bad_input) throw;
        fitted.why = error.what();
    }
    fitted.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return fitted;
}

}  // namespace lapfx::bench
