#include "app/clips/clip_shelf.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

#include "app/base/notices.h"
#include "app/base/settings.h"
#include "app/preview/preview_host.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/file.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr glm::ivec2 thumbnail_size{128, 72};
constexpr double between_asking = 0.25;  // s
constexpr double sure_from = 0.5;        // confidence of a suggestion below which a person should look first
constexpr std::size_t most_clips = 64;   // the table of presets allows no more

/// What a job has found out about a file.
struct ExaminedClip {
    fs::path path;
    ClipReport report;
    std::vector<std::uint8_t> thumbnail;
};

/// `path` within `folder`, as a preset there names it; empty: it lies elsewhere. By name alone: the disk is not asked.
std::string within(const fs::path& path, const fs::path& folder) {
    if (folder.empty()) return {};
    const fs::path relative =
        fs::absolute(path).lexically_normal().lexically_relative(fs::absolute(folder / "").lexically_normal());
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") return {};
    return relative.generic_string();
}

/// A whole number without decimals, any other with one.
std::string short_number(double value) {
    const auto tenths = std::llround(10 * value);
    std::string text = std::to_string(tenths / 10);
    if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
    return text;
}

std::string summary_of(const ClipReport& r) {
    const std::string size = std::to_string(r.size.x) + "x" + std::to_string(r.size.y);
    if (r.frames == 1) return size + ", one image";
    return size + ", " + short_number(r.duration) + " s at " + short_number(r.frames_per_second) + " fps" +
           (r.alpha ? ", own opacity" : "");
}

/// A name in `folder` that no file has, and none of `taken`.
fs::path free_name(const fs::path& folder, const fs::path& wanted, const std::map<std::string, std::string>& taken) {
    const auto used = [&](const fs::path& name) {
        return fs::exists(folder / name) ||
               std::any_of(taken.begin(), taken.end(), [&](const auto& one) { return one.second == name; });
    };
    fs::path name = wanted;
    for (int i = 2; used(name); ++i)
        name = wanted.stem().string() + "_" + std::to_string(i) + wanted.extension().string();
    return name;
}

Error cannot_copy(const fs::path& from, const fs::path& to, const std::string& reason) {
    return {Failure::runtime,
            Fault{.file = to.string(), .place = "", .reason = "cannot copy " + from.string() + ": " + reason}};
}

/// Written under another name, then renamed: there is never half a file. False: cancelled.
bool copy_file(const fs::path& from, const fs::path& to, const std::function<bool(std::uintmax_t)>& goes_on) {
    const Beside part(to, Beside::Kind::file, to.extension().string());
    std::ifstream in(from, std::ios::binary);
    std::ofstream out(part.path(), std::ios::binary | std::ios::trunc);
    if (!in) throw cannot_copy(from, to, "it cannot be read");
    if (!out) throw cannot_copy(from, to, "the folder cannot be written to");
    std::vector<char> block(1 << 20);
    while (in && out) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        out.write(block.data(), in.gcount());
        if (!goes_on(static_cast<std::uintmax_t>(in.gcount()))) return false;
    }
    out.close();
    if (!out || in.bad()) throw cannot_copy(from, to, in.bad() ? "it cannot be read" : "the disk is full or failing");
    report_clip(part.path());  // throws where the copy is no clip, or not a whole one
    std::error_code error;
    fs::rename(part.path(), to, error);
    if (error) throw cannot_copy(from, to, error.message());
    return true;
}

/// As suggested for the clip that was added last. The first clip of a preset sets the keying that all share.
void take_keying(SmokeParameters& smoke, const KeyingSuggestion& found) {
    SmokeClip& clip = smoke.clips.back();
    if (found.alpha) return;
    const KeyingParameters unused = std::exchange(clip.keying, smoke.keying);  // what is not suggested stays as it was
    found.apply(clip);
    if (smoke.clips.size() > 1) return;
    smoke.keying = std::exchange(clip.keying, unused);
    clip.own_keying = false;
}

const ClipFacts unknown_clip{};
const std::vector<std::string> no_faults;

}  // namespace

std::vector<std::uint8_t> shrunk(const Image& image, glm::ivec2 size) {
    std::vector<std::uint8_t> rgba;
    const glm::dvec2 whole(image.width, image.height);
    const double step = std::min(whole.x / size.x, whole.y / size.y);
    const glm::dvec2 corner = 0.5 * (whole - step * glm::dvec2(size));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::ivec2 last(image.width - 1, image.height - 1);
            const glm::ivec2 from = glm::clamp(glm::ivec2(corner + step * glm::dvec2(x, y)), glm::ivec2(0), last);
            const glm::ivec2 to = glm::clamp(glm::ivec2(corner + step * glm::dvec2(x + 1, y + 1)), from, last);
            std::uint32_t sum[4] = {}, count = 0;
            for (int v = from.y; v <= to.y; ++v)
                for (int u = from.x; u <= to.x; ++u, ++count)
                    for (std::size_t c = 0; c < 4; ++c)
                        sum[c] +=
                            image.pixels[4 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                                              static_cast<std::size_t>(u)) +
                                         c];
            for (const std::uint32_t s : sum) rgba.push_back(static_cast<std::uint8_t>(s / count));
        }
    return rgba;
}

// --- what is known ---------------------------------------------------------------------------------------------------

ClipFacts& ClipShelf::find(const std::string& file) {
    const std::string key = document_.preset().folder.string() + '\n' + file;
    const auto [place, made] = known_.try_emplace(key);
    if (made) look(key, file);
    return place->second;
}

void ClipShelf::look(const std::string& key, const std::string& file) {
    const fs::path folder = document_.preset().folder;
    const auto found = std::make_shared<ExaminedClip>();
    const auto work = [=, folders = clip_folders_, this](Job& job) -> Jobs::Apply {
        found->path = find_clip(file, folder, folders);
        KeyingReader reader(found->path, &job.stop());
        found->report = reader.report();
        KeyingFrame frame;
        reader.read(found->report.frames * 2 / 5, frame, &job.stop());  // most clips show smoke by then
        found->thumbnail = shrunk(source_picture(frame), thumbnail_size);
        return [=, this] {
            ClipFacts& facts = known_[key];
            facts = {.path = found->path,
                     .known = true,
                     .summary = summary_of(found->report),
                     .report = found->report,
                     .faults = {},
                     .thumbnail = facts.thumbnail,
                     .job = {}};
            if (facts.thumbnail == 0)
                facts.thumbnail = images_.add(thumbnail_size, found->thumbnail);
            else
                images_.update(facts.thumbnail, thumbnail_size, found->thumbnail);
            ++grown_;
        };
    };
    const auto failed = [=, this](const std::vector<Fault>& faults) {
        ClipFacts& facts = known_[key];
        facts = {.path = found->path,
                 .known = false,
                 .summary = {},
                 .report = {},
                 .faults = faults,
                 .thumbnail = facts.thumbnail,
                 .job = {}};
        ++grown_;
    };
    known_[key].job = jobs_.start("Reading " + fs::path(file).filename().string(), work, failed);
}

void ClipShelf::look_again() {
    for (auto& [key, facts] : known_) {
        if (facts.job != nullptr) facts.job->cancel();
        look(key, key.substr(key.find('\n') + 1));
    }
}

const ClipStatus* ClipShelf::playing(std::size_t clip) const {
    return clip < playing_.size() && playing_[clip].file == of(clip).path ? &playing_[clip] : nullptr;
}

void ClipShelf::play_alone(std::optional<std::size_t> clip) {
    const auto& clips = document_.preset().smoke.clips;
    alone_ = clip && *clip < clips.size() ? clip : std::nullopt;
    alone_file_ = alone_ ? clips[*alone_].file : "";
}

void ClipShelf::follow_alone() {
    if (!alone_) return;
    const auto& clips = document_.preset().smoke.clips;
    if (*alone_ < clips.size() && clips[*alone_].file == alone_file_) return;
    const auto moved =
        std::find_if(clips.begin(), clips.end(), [&](const SmokeClip& clip) { return clip.file == alone_file_; });
    if (moved == clips.end()) return play_alone({});
    alone_ = static_cast<std::size_t>(moved - clips.begin());
}

void ClipShelf::update(double now) {
    const std::size_t count = document_.preset().smoke.clips.size();
    if (count > 0 && selected >= count) selected = count - 1;  // one that is gone gives way to the last
    follow_alone();
    if (work_ && work_->cancelled()) end_work();
    if (const bool changed = stale(); changed || now - asked_ > between_asking) {
        asked_ = changed ? now - between_asking : now;  // what a change does is seen once the preview has drawn it
        const auto playing = preview_.ready() ? preview_.preview()->clips() : std::span<const ClipStatus>{};
        playing_.assign(playing.begin(), playing.end());
    }
    follow();
    if (!exact_ || !jobs_.busy()) return;
    jobs_.finish();
    follow();
}

/// Whether the clips, their crop and keying, the folder that they may be in, or the reports about them have changed.
bool ClipShelf::stale() const {
    return (document_.preset_changes_since(followed_) & (redo::clips | redo::keyed_frame)) != 0 ||
           grown_ != followed_grown_ || document_.preset_file().native() != followed_file_;
}

void ClipShelf::follow() {
    const bool changed = stale();
    followed_ = document_.version();
    if (!changed) return;
    followed_grown_ = grown_;
    followed_file_ = document_.preset_file().native();
    const std::vector<SmokeClip>& clips = document_.preset().smoke.clips;
    seen_ = {};
    seen_.faults.resize(clips.size());
    for (const SmokeClip& clip : clips) seen_.facts.push_back(&find(clip.file));
    for (const ClipFacts* facts : seen_.facts) seen_.outside.push_back(is_outside(*facts));
    constexpr std::string_view place = "/smoke/clips/";
    for (const Fault& fault : document_.preset_faults()) {
        if (!fault.place.starts_with(place)) continue;
        const std::size_t clip = static_cast<std::size_t>(std::atoi(fault.place.c_str() + place.size()));
        const std::size_t key = fault.place.find('/', place.size());
        if (clip < clips.size())
            seen_.faults[clip].push_back(fault.place.substr(std::min(key + 1, fault.place.size())) + ": " +
                                         fault.reason);
    }
    for (std::size_t i = 0; i < clips.size(); ++i)
        for (const Fault& fault : seen_.facts[i]->faults) seen_.faults[i].push_back(fault.text());
}

const ClipFacts& ClipShelf::of(std::size_t clip) const {
    return clip < seen_.facts.size() ? *seen_.facts[clip] : unknown_clip;
}

const std::vector<std::string>& ClipShelf::faults(std::size_t clip) const {
    return clip < seen_.faults.size() ? seen_.faults[clip] : no_faults;
}

bool ClipShelf::outside(std::size_t clip) const {
    return clip < seen_.outside.size() && seen_.outside[clip];
}

bool ClipShelf::any_outside() const {
    return std::find(seen_.outside.begin(), seen_.outside.end(), true) != seen_.outside.end();
}

fs::path ClipShelf::home() const {
    const fs::path& file = document_.preset_file();
    return file.empty() ? document_.preset().folder : fs::absolute(file).parent_path();
}

bool ClipShelf::is_outside(const ClipFacts& facts) const {
    if (facts.path.empty()) return false;
    for (const fs::path& folder : clip_folders_)
        if (facts.path.parent_path() == folder) return false;
    const auto real = [](const fs::path& path) {
        std::error_code error;
        fs::path found = fs::weakly_canonical(path, error);
        return error ? path : found;
    };
    return within(real(facts.path), real(home())).empty();
}

// --- adding ----------------------------------------------------------------------------------------------------------

void ClipShelf::add(const std::vector<std::string>& files, std::optional<std::size_t> replace) {
    if (files.empty()) return;
    if (!work_) refused_.clear();
    waiting_.push_back({files, replace});
    if (!work_) end_work();
}

/// Goes on with what waits.
void ClipShelf::end_work() {
    work_.reset();
    work_files_.clear();
    if (waiting_.empty()) return;
    const Lot next = std::move(waiting_.front());
    waiting_.pop_front();
    look_through(next);
}

void ClipShelf::look_through(const Lot& lot) {
    const auto& [files, replace] = lot;
    const auto faults = std::make_shared<std::vector<Fault>>();
    const auto work = [this, files = lot.files, replace = lot.replace, faults](Job& job) -> Jobs::Apply {
        std::vector<Good> good;
        std::vector<std::string> bad;
        for (std::size_t i = 0; i < files.size() && !job.cancelled(); ++i) {
            if (files.size() > 1) job.set_progress(static_cast<double>(i) / static_cast<double>(files.size()));
            try {
                KeyingReader opened(files[i], &job.stop());
                Good one{.file = fs::absolute(files[i]).lexically_normal().string()};
                if (!replace) one.source = suggest_source(files[i], &job.stop());
                if (!replace) one.keying = suggest_keying(files[i], &job.stop());
                good.push_back(std::move(one));
            } catch (const Error& error) {
                faults->insert(faults->end(), error.faults().begin(), error.faults().end());
                bad.push_back(files[i]);
            }
        }
        return [=, this] {
            refused_.insert(refused_.end(), faults->begin(), faults->end());
            settings_.forget_missing(bad);
            take_found(good, replace);
            end_work();
        };
    };
    const std::string name =
        files.size() == 1 ? fs::path(files[0]).filename().string() : std::to_string(files.size()) + " clips";
    work_files_ = files;
    work_ = jobs_.start("Reading " + name, work, [this](const std::vector<Fault>& told) {
        refused_.insert(refused_.end(), told.begin(), told.end());
        end_work();
    });
}

void ClipShelf::take_found(const std::vector<Good>& files, std::optional<std::size_t> replace) {
    if (files.empty()) return;
    for (auto file = files.rbegin(); file != files.rend(); ++file) settings_.note_recent(file->file);
    document::Document& document = document_;
    if (replace) {
        if (*replace >= document.preset().smoke.clips.size()) return;
        return document.change("Replace clip", [&](document::Content& c) {
            SmokeClip& clip = c.preset.smoke.clips[*replace];
            clip.file = files[0].file;
            clip.in = clip.out = 0;  // the old times are those of another file
            document.gather_clips(c.preset);
        });
    }
    std::size_t added = 0;
    document.change(files.size() == 1 ? "Add clip" : "Add " + std::to_string(files.size()) + " clips",
                    [&](document::Content& c) {
                        for (const Good& one : files) {
                            if (c.preset.smoke.clips.size() >= most_clips) break;
                            SmokeClip& clip = c.preset.smoke.clips.emplace_back();
                            clip.file = one.file;
                            take_source(clip, one.source);  // a new clip is a plume
                            take_keying(c.preset.smoke, one.keying);
                            ++added;
                        }
                        document.gather_clips(c.preset);
                    });
    if (added > 0) selected = document.preset().smoke.clips.size() - 1;
    tell_keying({files.begin(), files.begin() + static_cast<std::ptrdiff_t>(added)});
    if (added < files.size())
        refused_.push_back({.file = files[added].file,
                            .place = "",
                            .reason = "a preset has at most " + std::to_string(most_clips) + " clips"});
}

/// Whatever was suggested may be wrong: it is said how sure it is, and undone with the clips.
void ClipShelf::tell_keying(const std::vector<Good>& added) {
    const Good* least = nullptr;
    for (const Good& one : added)
        if (!one.keying.alpha && (least == nullptr || one.keying.confidence < least->keying.confidence)) least = &one;
    if (least == nullptr) return;
    const bool unsure = least->keying.confidence < sure_from;
    const std::string of = added.size() == 1 ? "" : std::to_string(added.size()) + " clips, the least sure of them ";
    notices_.add({.kind = unsure ? ui::ToastKind::warning : ui::ToastKind::info,
                  .text = "Suggested keying for " + of + fs::path(least->file).filename().string() + ", " +
                          (unsure ? "only " : "") + std::to_string(std::lround(100 * least->keying.confidence)) +
                          " % sure; the Keying panel shows what it leaves"});
}

void ClipShelf::copy_beside() {
    const fs::path to = home();
    std::map<std::string, fs::path> from;  // the key is the name in the preset
    const std::vector<SmokeClip>& clips = document_.preset().smoke.clips;
    for (std::size_t i = 0; i < clips.size(); ++i)
        if (outside(i)) from[clips[i].file] = of(i).path;
    copy(from, to, [this, to](const std::map<std::string, std::string>& names) {
        document_.change("Copy clips next to the preset", [&](document::Content& c) {
            for (SmokeClip& clip : c.preset.smoke.clips)
                if (const auto name = names.find(clip.file); name != names.end())
                    clip.file = (to / name->second).string();
            document_.gather_clips(c.preset);
        });
    });
}

void ClipShelf::copy_to(const fs::path& folder, std::function<void()> then) {
    const std::vector<std::string> needed = document_.clips_outside(folder);
    std::map<std::string, fs::path> from;
    const std::vector<SmokeClip>& clips = document_.preset().smoke.clips;
    for (std::size_t i = 0; i < clips.size(); ++i)
        if (std::find(needed.begin(), needed.end(), clips[i].file) != needed.end()) from[clips[i].file] = of(i).path;
    copy(from, folder, [this, folder, then = std::move(then)](const std::map<std::string, std::string>& names) {
        document_.change("Copy clips", [&](document::Content& c) {
            for (SmokeClip& clip : c.preset.smoke.clips)
                if (const auto name = names.find(clip.file); name != names.end())
                    clip.file = (folder / name->second).string();
            document_.gather_clips(c.preset);
        });
        then();
    });
}

void ClipShelf::copy(const std::map<std::string, fs::path>& from, const fs::path& to,
                     std::function<void(const std::map<std::string, std::string>&)> taken) {
    if (from.empty() || to.empty()) return;
    cancel_work();
    refused_.clear();
    const auto work = [=, this](Job& job) -> Jobs::Apply {
        std::error_code error;
        std::uintmax_t bytes = 0, done = 0;
        for (const auto& [name, path] : from) bytes += std::max<std::uintmax_t>(fs::file_size(path, error), 1);
        std::map<std::string, std::string> names;
        for (const auto& [name, path] : from) {
            const fs::path free = free_name(to, path.filename(), names);
            const bool whole = copy_file(path, to / free, [&](std::uintmax_t more) {
                job.set_progress(static_cast<double>(done += more) / static_cast<double>(bytes));
                return !job.cancelled();
            });
            if (!whole) return {};
            names[name] = free.string();
        }
        return [=, this] {
            taken(names);
            end_work();
        };
    };
    work_ = jobs_.start("Copying clips", work, [this](const std::vector<Fault>& told) {
        refused_ = told;
        end_work();
    });
}

void ClipShelf::cancel_work() {
    waiting_.clear();
    if (work_) work_->cancel();
    end_work();
}

void ClipShelf::give_up(const std::string& file) {
    const auto has = [&](const std::vector<std::string>& files) {
        return std::find(files.begin(), files.end(), file) != files.end();
    };
    std::erase_if(waiting_, [&](const Lot& lot) { return has(lot.files); });
    if (!work_ || !has(work_files_)) return;
    work_->cancel();
    end_work();
}

void take_source(SmokeClip& clip, const SourceSuggestion& found) {
    if (!found.found) return;
    clip.source_x = std::round(200.0 * found.place.x) / 200.0;  // it is not known more precisely
    clip.source_y = std::round(200.0 * found.place.y) / 200.0;
}

}  // namespace lapfx::app
