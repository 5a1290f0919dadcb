// Smoke clips read in advance, on another thread. Before a clip plays, its file is read to the end once, which takes
// seconds for a long video. When a ClipCache has read it before, on any thread, Effects::set_preset() opens the clip
// immediately.
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

#include "lapfx/api.h"
#include "lapfx/preset.h"
#include "lapfx/progress.h"

namespace lapfx {

class LAPFX_API ClipCache {
  public:
    ClipCache();
    ~ClipCache();

    /// Whether set_preset() can take this preset without reading a file to its end: each of its clips is known, perhaps
    /// as broken, or missing. `folders` are those of EffectsOptions::clip_folders. This looks at the name and time of
    /// each file.
    bool knows(const Preset& preset, std::span<const std::filesystem::path> folders) const;
    /// Reads the files that are not known yet. False when `progress` stopped it. It remembers what is wrong with a
    /// broken file, and set_preset() throws that.
    bool look_through(const Preset& preset, std::span<const std::filesystem::path> folders,
                      const Progress& progress = {});
    /// Forgets a file, as if it had been replaced: the next set_preset() opens it again. Any picture of a numbered
    /// sequence names the sequence, because its pictures may change one by one. An empty path forgets all files.
    void forget(const std::filesystem::path& file = {});

  private:
    struct LAPFX_HIDDEN State;
    friend struct ClipCacheAccess;  // the core's own
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
