// Smoke clips read in advance, on another thread. To play a clip its file is read to the end once; of a long video that
// takes seconds. Done here first, on any thread, Effects::set_preset() opens it at once.
//
//     auto clips = std::make_shared<lapfx::ClipCache>();
//     lapfx::Effects effects(organ, preset, {.clip_folders = folders, .clip_cache = clips});
//     ...
//     if (clips->knows(next, folders)) effects.set_preset(next);
//     else start_job([=] { clips->look_through(next, folders); });   // and meanwhile effects.set_parameters(next)
//
// Files are distinguished by name, device, inode, size and time of writing: a replaced file counts as another. Any
// thread; any number of Effects may share one.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "lapfx/preset.h"
#include "lapfx/progress.h"

namespace lapfx {

class ClipCache {
  public:
    ClipCache();
    ~ClipCache();

    /// Whether set_preset() will not have to look through any file of this preset: those that are known, also as
    /// broken, and those that are not there. Folders as EffectsOptions::clip_folders. Costs a look at each file's name
    /// and time.
    bool knows(const Preset& preset, std::span<const std::filesystem::path> folders) const;
    /// Reads the files that are not known yet. False when `progress` stopped it. Of a broken file it remembers what is
    /// wrong; set_preset() throws that.
    bool look_through(const Preset& preset, std::span<const std::filesystem::path> folders,
                      const Progress& progress = {});
    /// As if the file had been replaced: the next set_preset() opens it again. For pictures of a numbered sequence,
    /// which may change one by one, any of them names the sequence. Empty: all files.
    void forget(const std::filesystem::path& file = {});

  private:
    struct State;
    friend struct ClipCacheAccess;  // the core's own
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
