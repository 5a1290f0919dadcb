// The organ and the clips of the document that an editor begins with: they are loaded before there is a preview.
//
//     const auto early = load_early(scene, preset, clip_folders);   // returns at once
//     PreviewHost host(options, jobs, early);
#pragma once

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <vector>

#include "lapfx/clip_cache.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::app {

class Job;

/// Organ and clips of the first document, which are loaded while the window and the Editor are still being made. Any
/// thread.
struct EarlyLoad {
    EarlyLoad() = default;
    EarlyLoad(const EarlyLoad&) = delete;
    EarlyLoad& operator=(const EarlyLoad&) = delete;
    ~EarlyLoad() { stopped = true; }  // what is still on its way ends soon, and is waited for

    Scene scene;                       ///< whose organ and tool it is
    std::shared_ptr<ClipCache> clips;  ///< gets the facts about the clips
    std::atomic<bool> stopped = false;
    std::atomic<double> progress = 0;                         ///< of the organ, 0..1
    std::future<std::shared_ptr<const PreparedOrgan>> organ;  ///< what it throws is told when it is asked for
    std::future<void> clips_known;
};
std::shared_ptr<EarlyLoad> load_early(const Scene& scene, const Preset& preset,
                                      const std::vector<std::filesystem::path>& clip_folders);
/// For a host that begins with an organ and clips that another one has loaded; they are shared.
std::shared_ptr<EarlyLoad> loaded_already(const Scene& scene, const std::shared_ptr<const PreparedOrgan>& organ,
                                          const std::shared_ptr<ClipCache>& clips);
/// Waits for the organ and for the clips; `job` has its progress. Null when the job was cancelled. Throws what loading
/// threw.
std::shared_ptr<const PreparedOrgan> wait_for(EarlyLoad& early, Job& job);

}  // namespace lapfx::app
