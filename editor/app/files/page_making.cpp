#include "app/files/page_making.h"

#include "app/measure/drawn_curve.h"
#include "app/measure/measuring.h"
#include "app/measure/side_by_side.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

PageMaking::PageMaking(PageWanted wanted, const Parts& parts)
    : wanted_(std::move(wanted)),
      measured_side_(parts.measured_side),
      job_(std::make_shared<Job>("Comparing with " + wanted_.compared.video)),
      steps_(std::make_unique<RenderSteps>([&jobs = parts.jobs] { jobs.wake(); })),
      curve_(drawn_curve(parts.organ, parts.preview, parts.clip_folders, parts.exact ? nullptr : &steps_, {})) {
    work_.start([this](Job& job) { return measure(job); },
                {.ended = [&jobs = parts.jobs] { jobs.wake(); }, .given_up = [this] { steps_->stop(); }}, !parts.exact,
                job_);
}

void PageMaking::serve() {
    steps_->serve(frame_budget);
}

PageMaking::Video PageMaking::measure(Job& job) {
    // A reader of its own: it walks the whole film, beside the window, which shows another frame.
    auto video = std::make_shared<VideoReader>(wanted_.video, &job.stop());
    const SceneReference& reference = wanted_.scene.reference;
    const match::MeasureOptions options = match::measure_options(reference.measure);
    curve_->set_options(
        match::PreviewCurve::options_for(video->info().size, reference.aspect, options.estimator, measured_side_));
    const auto progress = [&job](double share) {
        job.set_progress(share);
        return !job.cancelled();
    };
    measure_both(wanted_.compared,
                 {.scene = wanted_.scene,
                  .preset = wanted_.preset,
                  .video = *video,
                  .options = options,
                  .found = wanted_.found ? &*wanted_.found : nullptr,
                  .curve = *curve_},
                 progress);
    return video;
}

std::unique_ptr<output::FramePage> PageMaking::take() {
    if (!work_.ended()) return nullptr;
    work_.rethrow();
    return std::make_unique<SideBySide>(std::move(*work_.result()), std::move(wanted_.compared));
}

}  // namespace lapfx::app
