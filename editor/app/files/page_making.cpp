#include "app/files/page_making.h"

#include "app/measure/drawn_curve.h"
#include "app/measure/measuring.h"
#include "app/measure/side_by_side.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

PageMaking::PageMaking(PageWanted wanted, const Parts& parts)
    : wanted_(std::move(wanted)),
      jobs_(parts.jobs),
      measured_side_(parts.measured_side),
      job_("Comparing with " + wanted_.compared.video),
      steps_(std::make_unique<RenderSteps>([this] { jobs_.wake(); })),
      curve_(drawn_curve(parts.organ, parts.preview, parts.clip_folders, parts.exact ? nullptr : &steps_, {})) {
    if (parts.exact)
        work();
    else
        thread_ = std::thread([this] { work(); });
}

PageMaking::~PageMaking() {
    job_.cancel();
    steps_->stop();
    if (thread_.joinable()) thread_.join();
}

void PageMaking::serve() {
    steps_->serve(frame_budget);
}

void PageMaking::work() noexcept {
    try {
        make();
    } catch (...) {
        thrown_ = std::current_exception();
    }
    ended_ = true;
    jobs_.wake();
}

void PageMaking::make() {
    video_ = std::make_shared<VideoReader>(wanted_.video, &job_.stop());
    const SceneReference& reference = wanted_.scene.reference;
    const match::MeasureOptions options = match::measure_options(reference.measure);
    curve_->set_options({.size = match::preview_size(video_->info().size, reference.aspect, measured_side_),
                         .estimator = options.estimator});
    const auto progress = [this](double share) {
        job_.set_progress(share);
        return !job_.cancelled();
    };
    measure_both(wanted_.compared,
                 {.scene = wanted_.scene,
                  .preset = wanted_.preset,
                  .video = *video_,
                  .options = options,
                  .found = wanted_.found ? &*wanted_.found : nullptr,
                  .curve = *curve_},
                 progress);
}

std::unique_ptr<output::FramePage> PageMaking::take() {
    if (!ended_) return nullptr;
    if (thrown_) std::rethrow_exception(thrown_);
    return std::make_unique<SideBySide>(std::move(video_), std::move(wanted_.compared));
}

}  // namespace lapfx::app
