#include "app/preview/early_load.h"

#include <chrono>

#include "app/base/jobs.h"
#include "lapfx/authoring/prepared_scene.h"

namespace lapfx::app {

std::shared_ptr<EarlyLoad> load_early(const Scene& scene, const Preset& preset,
                                      const std::vector<std::filesystem::path>& clip_folders) {
    auto early = std::make_shared<EarlyLoad>();
    early->scene = scene;
    early->clips = std::make_shared<ClipCache>();
    // Both end before what they refer to goes: their futures are parts of it.
    early->organ = std::async(std::launch::async, [scene, vessels = preset.vessels, e = early.get()] {
        return prepare_organ(scene, vessels, [e](double share) {
            e->progress = share;
            return !e->stopped;
        });
    });
    early->clips_known = std::async(std::launch::async, [preset, clip_folders, e = early.get()] {
        e->clips->look_through(preset, clip_folders, [e](double) { return !e->stopped; });
    });
    return early;
}

std::shared_ptr<EarlyLoad> loaded_already(const Scene& scene, const std::shared_ptr<const PreparedOrgan>& organ,
                                          const std::shared_ptr<ClipCache>& clips) {
    auto early = std::make_shared<EarlyLoad>();
    early->scene = scene;
    early->clips = clips;
    std::promise<std::shared_ptr<const PreparedOrgan>> ready;
    early->organ = ready.get_future();
    ready.set_value(organ);
    std::promise<void> known;
    early->clips_known = known.get_future();
    known.set_value();
    return early;
}

std::shared_ptr<const PreparedOrgan> wait_for(EarlyLoad& early, Job& job) {
    using namespace std::chrono_literals;
    while (early.organ.wait_for(20ms) != std::future_status::ready) {
        job.set_progress(early.progress);
        if (job.cancelled()) early.stopped = true;
    }
    std::shared_ptr<const PreparedOrgan> organ = early.organ.get();
    early.clips_known.wait();  // without waiting they would be looked through twice
    return organ;
}

}  // namespace lapfx::app
