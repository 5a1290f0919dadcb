// What ClipCache (lapfx/clip_cache.h) remembers. Any thread.
#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include "lapfx/clip_cache.h"
#include "lapfx/error.h"
#include "smoke/decoder.h"
#include "smoke/file_stamp.h"

namespace lapfx::smoke {

struct KnownClip {
    std::filesystem::path path;
    FileStamp stamp;
    ClipInfo info;
    std::vector<Fault> faults;  ///< why it cannot be played; empty: it can
};

}  // namespace lapfx::smoke

namespace lapfx {

struct ClipCache::State {
    std::optional<smoke::KnownClip> find(const std::filesystem::path& path, const smoke::FileStamp& stamp) const;
    void put(smoke::KnownClip clip);

    mutable std::mutex mutex;
    std::vector<smoke::KnownClip> clips;  ///< the oldest first
};

}  // namespace lapfx
