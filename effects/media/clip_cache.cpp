#include "lapfx/clip_cache.h"

#include <algorithm>

#include "lapfx/authoring/clip.h"
#include "media/clip_file.h"
#include "media/clip_index.h"
#include "media/known_clips.h"
#include "work/stages.h"

namespace lapfx {

namespace fs = std::filesystem;
using media::KnownClip;

namespace {

constexpr std::size_t most_clips = 256;  // most entries; files that play are kept in addition

/// The existing files of a preset's clips, each once.
std::vector<fs::path> files_of(const Preset& preset, std::span<const fs::path> folders) {
    std::vector<fs::path> files;
    for (const SmokeClip& clip : preset.smoke.clips) {
        try {
            fs::path file = media::clip_path(clip.file, preset.folder, folders);
            if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(std::move(file));
        } catch (const Error&) {
            // set_preset() tells.
        }
    }
    return files;
}

KnownClip read(const fs::path& path, const work::Stages& stages) {
    KnownClip clip{.path = path, .stamp = media::stamp_of(path), .info = {}, .faults = {}};
    try {
        clip.info = media::Decoder(path, media::Layout::planar, media::Decoder::most_frames, stages).info();
    } catch (const Error& error) {
        clip.faults = error.faults();
    }
    return clip;
}

}  // namespace

std::optional<KnownClip> ClipCache::State::find(const fs::path& path, const media::FileStamp& stamp) const {
    const std::lock_guard lock(mutex);
    const auto found = std::find_if(clips.begin(), clips.end(),
                                    [&](const KnownClip& clip) { return clip.path == path && clip.stamp == stamp; });
    return found == clips.end() ? std::nullopt : std::optional(*found);
}

void ClipCache::State::put(KnownClip clip) {
    const std::lock_guard lock(mutex);
    // Two threads may have looked through the same file: clips continue with the result of the first one.
    if (std::any_of(clips.begin(), clips.end(), [&](const KnownClip& other) {
            return other.path == clip.path && other.stamp == clip.stamp && other.faults.empty();
        }))
        return;
    std::erase_if(clips, [&](const KnownClip& other) { return other.path == clip.path; });
    clips.push_back(std::move(clip));
    for (std::size_t i = 0; clips.size() > most_clips && i + 1 < clips.size();) {
        if (clips[i].info.index.use_count() < 2)
            clips.erase(clips.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

ClipCache::ClipCache() : state_(std::make_unique<State>()) {}
ClipCache::~ClipCache() = default;

bool ClipCache::knows(const Preset& preset, std::span<const fs::path> folders) const {
    const std::vector<fs::path> files = files_of(preset, folders);
    return std::all_of(files.begin(), files.end(),
                       [&](const fs::path& file) { return state_->find(file, media::stamp_of(file)).has_value(); });
}

bool ClipCache::look_through(const Preset& preset, std::span<const fs::path> folders, const Progress& progress) {
    const std::vector<fs::path> files = files_of(preset, folders);
    const work::Stages stages(progress);
    const double each = 1.0 / static_cast<double>(std::max<std::size_t>(files.size(), 1));
    try {
        for (std::size_t i = 0; i < files.size(); ++i) {
            const double from = each * static_cast<double>(i);
            stages.reach(from);
            if (state_->find(files[i], media::stamp_of(files[i]))) continue;
            state_->put(read(files[i], stages.part(from, from + each)));
        }
        stages.reach(1.0);
    } catch (const work::Stopped&) {
        return false;
    }
    return true;
}

void ClipCache::forget(const fs::path& file) {
    const std::lock_guard lock(state_->mutex);
    std::erase_if(state_->clips, [&](const KnownClip& clip) {
        const bool numbered = clip.info.index && clip.info.index->sequence;
        return file.empty() || clip.path == file || (numbered && clip.path.parent_path() == file.parent_path());
    });
}

void check_clips(const Preset& preset, const std::string& name, std::span<const fs::path> folders, ClipCache* cache) {
    ClipCache own;
    ClipCache& known = cache != nullptr ? *cache : own;
    known.look_through(preset, folders);
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < preset.smoke.clips.size(); ++i) {
        const std::string& file = preset.smoke.clips[i].file;
        try {
            const fs::path path = media::clip_path(file, preset.folder, folders);
            const auto found = ClipCacheAccess::state(known).find(path, media::stamp_of(path));
            if (found && !found->faults.empty()) throw Error(Failure::bad_input, found->faults);
        } catch (const Error& error) {
            for (const Fault& fault : error.faults())
                faults.push_back({.file = name,
                                  .place = "/smoke/clips/" + std::to_string(i) + "/file",
                                  .reason = file + ": " + fault.reason});
        }
    }
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
}

std::vector<fs::path> clip_places(const Preset& preset, std::span<const fs::path> folders) {
    std::vector<fs::path> places;
    const auto add = [&](const fs::path& folder, const fs::path& file) {
        const fs::path path = fs::absolute(folder / file).lexically_normal();
        places.push_back(path.filename().string().find('%') == std::string::npos ? path : path.parent_path());
    };
    for (const SmokeClip& clip : preset.smoke.clips) {
        add(preset.folder, clip.file);
        if (fs::path(clip.file).filename() == fs::path(clip.file))
            for (const fs::path& folder : folders) add(folder, clip.file);
    }
    return places;
}

}  // namespace lapfx
