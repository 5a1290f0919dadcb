// What ClipCache (lapfx/clip_cache.h) remembers. Any thread.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "lapfx/clip_cache.h"
#include "lapfx/error.h"
#include "media/decoder.h"
#include "media/file_stamp.h"

namespace lapfx::media {

struct KnownClip {
    std::filesystem::path path;
    FileStamp stamp;
    ClipInfo info;
    std::vector<Fault> faults;  ///< why it cannot be played; empty if it can
};

}  // namespace lapfx::media

namespace lapfx {

struct ClipCache::State {
    std::optional<media::KnownClip> find(const std::filesystem::path& path, const media::FileStamp& stamp) const;
    void put(media::KnownClip clip);

    mutable std::mutex mutex;
    std::vector<media::KnownClip> clips;  ///< the oldest first
};

/// Gives the core access to the state of a ClipCache.
struct ClipCacheAccess {
    static auto& state(const ClipCache& cache) { return *cache.state_; }
};

}  // namespace lapfx
