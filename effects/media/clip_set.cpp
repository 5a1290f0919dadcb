#include "media/clip_set.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "lapfx/error.h"
#include "media/clip_file.h"
#include "media/clip_player.h"
#include "media/known_clips.h"
#include "media/schemes.h"

namespace lapfx::media {

namespace {

/// Decoded frames of all clips together (paper, table 1: MAX_TEXTURES).
constexpr int max_textures = 64;
constexpr int most_buffers = 8;  // more than a few frames ahead has no use and costs memory
constexpr int fewest_buffers = 2;

int decoding_threads(const StreamingOptions& options) {
    return options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
}

void require_drawable(const ClipFile& file) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (file.info.size.x <= most && file.info.size.y <= most) return;
    throw Error(Failure::bad_input,
                Fault{.file = file.path.string(),
                      .place = "",
                      .reason = "is " + std::to_string(file.info.size.x) + "x" + std::to_string(file.info.size.y) +
                                " pixels; this driver takes at most " + std::to_string(most) + " a side"});
}

std::string mebibytes(std::size_t bytes) {
    return std::to_string((bytes + (std::size_t{1} << 20) - 1) >> 20) + " MiB";
}

/// Number of places where it plays.
std::size_t heads_of(const SmokeClip& clip) {
    return clip.crossfade > 0.0 ? 2 : 1;
}

std::size_t store_memory(const ClipFile& file, Loop played) {
    return FrameStore::memory_for(file.format, file.info.frame_count(), played.first, played.last);
}

/// A clip of the preset that is being prepared.
struct Plan {
    std::shared_ptr<ClipFile> file;
    std::optional<Decoder> opened;  // when the file is new
    Scheme scheme = Scheme::resident;
    int buffers = fewest_buffers;
    std::unique_ptr<ClipPlayer> player;
};

/// From the first to the last frame of a file that any clip plays.
Loop played_by_all(const std::shared_ptr<ClipFile>& file, std::span<const SmokeClip> wanted,
                   std::span<const Plan> plans) {
    Loop all{file->info.frame_count() - 1, 0};
    for (std::size_t i = 0; i < plans.size(); ++i) {
        if (plans[i].file != file) continue;
        const Loop one = played_frames(file->info, wanted[i]);
        all = {std::min(all.first, one.first), std::max(all.last, one.last)};
    }
    return all;
}

}  // namespace

struct ClipSet::State {
    State(const StreamingOptions& wanted, std::shared_ptr<ClipCache> known_clips)
        : options(wanted), cache(std::move(known_clips)), pool(decoding_threads(wanted)) {}

    struct Clip {
        SmokeClip settings;
        std::unique_ptr<ClipPlayer> player;
    };

    StreamingOptions options;
    std::shared_ptr<ClipCache> cache;              // or null
    std::vector<std::shared_ptr<ClipFile>> files;  // files of clips, and files kept in case they return
    DecodePool pool;
    std::vector<Clip> clips;  // after the pool: its threads outlive them
    StreamingTimes sums;
    ClipStream::Work gone;  // times of players that have been removed
    std::uint64_t cycle = 0;
    bool missed = false, late = false;  // `missed` is about this cycle, `late` about the one before
    std::vector<ClipStatus> status;     // as last asked for

    std::shared_ptr<ClipFile> opened(const std::filesystem::path& path, const FileStamp& stamp) const;
    Decoder open(const std::filesystem::path& path, const FileStamp& stamp) const;
    Plan plan(const std::filesystem::path& path, std::span<const Plan> before);
    std::size_t share_memory(std::span<const SmokeClip> wanted, std::span<Plan> plans) const;
    void cast(std::span<const SmokeClip> wanted, std::span<Plan> plans);
    void evict(std::span<const Loop> played, std::size_t buffers);
};

/// The file of that name if it is still the one that was opened.
std::shared_ptr<ClipFile> ClipSet::State::opened(const std::filesystem::path& path, const FileStamp& stamp) const {
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const auto& file) { return file->path == path && file->stamp == stamp; });
    if (found == files.end()) return nullptr;
    if (!cache) return *found;
    // A file that the cache was told to forget is opened again.
    const std::optional<KnownClip> known = ClipCacheAccess::state(*cache).find(path, stamp);
    return known && known->info.index == (*found)->info.index ? *found : nullptr;
}

/// Opened from the data in the cache, or looked through here.
Decoder ClipSet::State::open(const std::filesystem::path& path, const FileStamp& stamp) const {
    if (!cache) return Decoder(path, row_of(options.scheme).layout);
    if (const std::optional<KnownClip> known = ClipCacheAccess::state(*cache).find(path, stamp)) {
        if (!known->faults.empty()) throw Error(Failure::bad_input, known->faults);
        return Decoder(path, row_of(options.scheme).layout, known->info);
    }
    Decoder decoder(path, row_of(options.scheme).layout);
    ClipCacheAccess::state(*cache).put({.path = path, .stamp = stamp, .info = decoder.info(), .faults = {}});
    return decoder;
}

Plan ClipSet::State::plan(const std::filesystem::path& path, std::span<const Plan> before) {
    Plan made;
    const FileStamp stamp = stamp_of(path);
    made.file = opened(path, stamp);
    for (const Plan& other : before)
        if (!made.file && other.file->path == path) made.file = other.file;
    if (made.file) return made;
    made.opened.emplace(open(path, stamp));
    made.file = std::make_shared<ClipFile>(path, stamp, *made.opened);
    require_drawable(*made.file);
    return made;
}

/// Divides the memory as StreamingOptions::memory says. Gives the bytes of the buffers.
std::size_t ClipSet::State::share_memory(std::span<const SmokeClip> wanted, std::span<Plan> plans) const {
    std::size_t heads = 0;
    for (const SmokeClip& clip : wanted) heads += heads_of(clip);
    const int by_count =
        std::clamp(max_textures / static_cast<int>(std::max<std::size_t>(heads, 1)), fewest_buffers, most_buffers);
    std::size_t taken = 0;
    for (std::size_t i = 0; i < plans.size(); ++i) {
        // A quarter of the memory is enough for frames that are decoded ahead.
        const std::size_t fitting = options.memory / 4 / heads / plans[i].file->format.bytes();
        plans[i].buffers =
            std::clamp(static_cast<int>(std::min<std::size_t>(fitting, most_buffers)), fewest_buffers, by_count);
        plans[i].scheme = options.scheme;
        if (!row_of(options.scheme).ahead) plans[i].buffers = 1;
        taken += heads_of(wanted[i]) * head_memory(plans[i].file->format, options.scheme, plans[i].buffers);
    }
    const Scheme otherwise = row_of(options.scheme).otherwise;
    if (otherwise == options.scheme) return taken;
    // The GPU memory that each clip needs when its frames do not stay there is reserved first.
    const auto streamed = [&](std::size_t i) {
        return heads_of(wanted[i]) * SentFrames::memory(plans[i].file->format, otherwise);
    };
    std::size_t aside = taken;
    for (std::size_t i = 0; i < plans.size(); ++i) aside += streamed(i);
    std::size_t left = options.memory - std::min(options.memory, aside);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        Plan& plan = plans[i];
        const auto same = std::find_if(plans.begin(), plans.begin() + static_cast<std::ptrdiff_t>(i),
                                       [&](const Plan& other) { return other.file == plan.file; });
        if (&*same != &plan) plan.scheme = same->scheme;  // that clip has decided for its whole file
        const std::size_t needed =
            &*same != &plan ? 0 : store_memory(*plan.file, played_by_all(plan.file, wanted, plans));
        if (plan.scheme == options.scheme && needed <= left + streamed(i)) {
            left = left + streamed(i) - needed;
        } else {
            plan.scheme = otherwise;
            taken += streamed(i);
        }
    }
    return taken;
}

/// Gives each plan its player: one that already plays the same, or a new one.
void ClipSet::State::cast(std::span<const SmokeClip> wanted, std::span<Plan> plans) {
    std::vector<Clip*> taken(plans.size(), nullptr);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        for (Clip& clip : clips) {
            const bool fits = clip.player && clip.player->file() == plans[i].file &&
                              clip.player->scheme() == plans[i].scheme && clip.player->same_heads(wanted[i]);
            if (taken[i] == nullptr && fits && std::find(taken.begin(), taken.end(), &clip) == taken.end())
                taken[i] = &clip;
        }
        if (taken[i] != nullptr) continue;
        Plan& plan = plans[i];
        Decoder decoder = plan.opened ? std::move(*plan.opened)
                                      : Decoder(plan.file->path, row_of(options.scheme).layout, plan.file->info);
        plan.opened.reset();
        plan.player =
            std::make_unique<ClipPlayer>(pool, plan.file, std::move(decoder), wanted[i], plan.scheme, plan.buffers);
    }
    // Nothing throws from here on.
    for (std::size_t i = 0; i < plans.size(); ++i)
        if (taken[i] != nullptr) plans[i].player = std::move(taken[i]->player);
}

/// Frees what is not played any more: frames outside all loops, then files that are kept for later. `buffers`: bytes of
/// the buffers.
void ClipSet::State::evict(std::span<const Loop> played, std::size_t buffers) {
    std::size_t used = buffers;
    for (std::size_t i = 0; i < clips.size(); ++i) {
        ClipFile& file = *clips[i].player->file();
        const std::lock_guard lock(pool.mutex());  // workers read which frames exist
        if (clips[i].player->stays())
            file.store.trim(played[i].first, played[i].last);
        else
            file.store.clear();  // it may have been resident once
    }
    std::stable_sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a->drawn > b->drawn; });
    const auto plays = [&](const std::shared_ptr<ClipFile>& file, std::size_t i) {
        return clips[i].player->file() == file;
    };
    const auto clip_of = [&](const std::shared_ptr<ClipFile>& file) {
        std::size_t i = 0;
        while (i < clips.size() && !plays(file, i)) ++i;
        return i;
    };
    for (const std::shared_ptr<ClipFile>& file : files)
        if (const std::size_t i = clip_of(file); i < clips.size() && clips[i].player->stays())
            used += store_memory(*file, played[i]);
    std::size_t kept = 0;
    std::erase_if(files, [&](const std::shared_ptr<ClipFile>& file) {
        if (clip_of(file) < clips.size()) return false;
        if (file->store.count() == 0) return true;
        kept += file->store.memory();
        return kept > options.kept_memory || used + kept > options.memory;
    });
}

ClipSet::ClipSet(const StreamingOptions& options, std::shared_ptr<ClipCache> cache)
    : state_(std::make_unique<State>(options, std::move(cache))) {}
ClipSet::~ClipSet() = default;

void ClipSet::set(std::span<const SmokeClip> wanted, const std::filesystem::path& preset_folder,
                  std::span<const std::filesystem::path> search_path) {
    State& s = *state_;
    const auto start = std::chrono::steady_clock::now();
    std::vector<Plan> plans;
    for (const SmokeClip& clip : wanted) {
        plans.push_back(s.plan(clip_path(clip.file, preset_folder, search_path), plans));
    }
    const std::size_t buffers = s.share_memory(wanted, plans);
    std::vector<State::Clip> clips(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) clips[i].settings = wanted[i];
    std::vector<std::shared_ptr<ClipFile>> files = s.files;
    for (const Plan& plan : plans)
        if (std::find(files.begin(), files.end(), plan.file) == files.end()) files.push_back(plan.file);
    std::vector<Loop> played;
    for (const Plan& plan : plans) played.push_back(played_by_all(plan.file, wanted, plans));
    s.cast(wanted, plans);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        clips[i].player = std::move(plans[i].player);
        clips[i].player->set_buffers(plans[i].buffers);
        clips[i].player->set_loops(wanted[i]);
    }
    for (const State::Clip& clip : s.clips) {
        if (!clip.player) continue;
        const ClipStream::Work work = clip.player->work();
        s.gone.decode += work.decode;
        s.gone.copy += work.copy;
        s.gone.decoded += work.decoded;
    }
    s.clips = std::move(clips);
    s.files = std::move(files);
    s.evict(played, buffers);
    s.sums.open += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::optional<bool> ClipSet::known_alpha(const SmokeClip& clip, const std::filesystem::path& preset_folder,
                                         std::span<const std::filesystem::path> search_path) const {
    try {
        const std::filesystem::path path = clip_path(clip.file, preset_folder, search_path);
        const FileStamp stamp = stamp_of(path);
        if (const std::shared_ptr<ClipFile> file = state_->opened(path, stamp)) return file->info.alpha;
        const std::optional<KnownClip> known =
            state_->cache ? ClipCacheAccess::state(*state_->cache).find(path, stamp) : std::nullopt;
        if (known && known->faults.empty()) return known->info.alpha;
    } catch (const Error&) {
        // set() tells.
    }
    return std::nullopt;
}

std::size_t ClipSet::size() const {
    return state_->clips.size();
}

const ClipInfo& ClipSet::info(std::size_t clip) const {
    return state_->clips[clip].player->file()->info;
}

ClipFrame ClipSet::frame(std::size_t clip, int head, int index, Policy policy) noexcept {
    ClipPlayer& player = *state_->clips[clip].player;
    player.file()->drawn = state_->cycle;
    const std::uint64_t misses = player.misses();
    const ClipFrame found = player.frame(head, index, policy, state_->sums);
    state_->missed |= player.misses() != misses;
    return found;
}

ClipFrame ClipSet::shown(std::size_t clip, int head) const noexcept {
    return state_->clips[clip].player->shown(head);
}

int ClipSet::asked(std::size_t clip, int head) const noexcept {
    return state_->clips[clip].player->asked(head);
}

void ClipSet::end_cycle() noexcept {
    std::uint64_t count = state_->cycle++;
    state_->late = std::exchange(state_->missed, false);
    for (State::Clip& clip : state_->clips) {
        clip.player->end_cycle(count, state_->sums);
        count += clip.player->heads();
    }
}

bool ClipSet::late() const noexcept {
    return state_->late;
}

std::size_t ClipSet::memory() const noexcept {
    std::size_t bytes = 0;
    for (const std::shared_ptr<ClipFile>& file : state_->files) bytes += file->store.memory();
    for (const State::Clip& clip : state_->clips) bytes += clip.player->memory();
    return bytes;
}

std::span<const ClipStatus> ClipSet::status() const {
    std::vector<ClipStatus>& all = state_->status;
    all.resize(state_->clips.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const State::Clip& clip = state_->clips[i];
        const ClipFile& file = *clip.player->file();
        const bool resident = clip.player->stays();
        const bool counted = std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(i),
                                         [&](const ClipStatus& before) { return before.file == file.path.native(); });
        ClipStatus& status = all[i];
        status.file = file.path.native();
        status.size = file.info.size;
        status.frames = file.info.frame_count();
        status.duration = file.info.duration;
        status.alpha = file.info.alpha;
        status.resident = resident ? file.store.count() : 0;
        status.memory = clip.player->memory() + (resident && !counted ? file.store.memory() : 0);
        status.broken = clip.player->work().broken;
        status.misses = clip.player->misses();
        status.warning = file.info.warning;
        if (status.warning.empty() && status.broken > 0)
            status.warning = std::to_string(status.broken) + " of its " + std::to_string(status.frames) +
                             " frames cannot be decoded; the frame before is shown in their place";
        if (status.warning.empty() && clip.player->scheme() != state_->options.scheme)
            status.warning = "does not fit into the memory for clips together with those before it (it needs " +
                             mebibytes(store_memory(file, played_frames(file.info, clip.settings))) + " of " +
                             mebibytes(state_->options.memory) + "); it is decoded while it plays";
    }
    return all;
}

StreamingTimes ClipSet::times() const noexcept {
    StreamingTimes times = state_->sums;
    times.decode = state_->gone.decode;
    times.copy = state_->gone.copy;
    times.decoded = state_->gone.decoded;
    for (const State::Clip& clip : state_->clips) {
        const ClipStream::Work work = clip.player->work();
        times.decode += work.decode;
        times.copy += work.copy;
        times.decoded += work.decoded;
    }
    return times;
}

}  // namespace lapfx::media
