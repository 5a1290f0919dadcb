// The part of Files that decides what videos are for: smoke clips of the preset, or the reference. A surgery that is
// keyed as smoke ruins a preset without a word, so it goes by what is in the pictures, and asks where that is not
// clear.
#include <algorithm>

#include "app/base/file_words.h"
#include "app/base/jobs.h"
#include "app/base/layouts.h"
#include "app/base/notices.h"
#include "app/base/settings.h"
#include "app/clips/clip_shelf.h"
#include "app/files/files.h"
#include "app/reference/reference.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double told_for = 20;  // s: the notice has the way back, so it stays longer than others

bool is_same(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return !a.empty() && fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool names(const SmokeClip& clip, const Preset& preset, const fs::path& file) {
    return is_same(document::real_clip(clip.file, preset.folder), file);
}

std::ptrdiff_t count_of(const Preset& preset, const fs::path& file) {
    return std::count_if(preset.smoke.clips.begin(), preset.smoke.clips.end(),
                         [&](const SmokeClip& clip) { return names(clip, preset, file); });
}

}  // namespace

void Files::look_at(const std::vector<std::string>& videos, std::optional<VideoUse> meant) {
    if (videos.empty()) return;
    const std::string name =
        videos.size() == 1 ? fs::path(videos[0]).filename().string() : std::to_string(videos.size()) + " videos";
    const auto work = [this, videos, meant](Job& job) -> Jobs::Apply {
        std::vector<LookedAt> looked;
        for (const std::string& file : videos) {
            if (job.cancelled()) return {};
            job.set_progress(static_cast<double>(looked.size()) / static_cast<double>(videos.size()));
            LookedAt& video = looked.emplace_back(LookedAt{.file = file, .found = {}, .faults = {}});
            try {
                video.found = suggest_use(file, &job.stop());
            } catch (const Error& error) {
                video.faults = error.faults();
            }
        }
        return [this, looked, meant] { sort_videos(looked, meant); };
    };
    parts_.jobs.start("Looking at " + name, work,
                      [this](const std::vector<Fault>& faults) { parts_.notices.tell(faults); });
}

void Files::sort_videos(std::vector<LookedAt> videos, std::optional<VideoUse> meant) {
    // There is one question at a time, and what it is about may be what the videos are opened into.
    if (question_) {
        after_question_.push_back([this, videos, meant] { sort_videos(videos, meant); });
        return;
    }
    std::vector<std::string> clips, references;
    std::vector<LookedAt> unclear;
    std::string smoke_seen, surgery_seen;
    for (const LookedAt& video : videos) {
        if (!video.faults.empty() && !meant) {
            parts_.notices.tell(video.faults);
            parts_.settings.forget_missing({video.file});
            continue;
        }
        const bool clear = !video.faults.empty() ||  // the panel that it was brought to tells them
                           (meant ? !video.found.sure || video.found.use == *meant : video.found.sure);
        if (!clear) {
            unclear.push_back(video);
            continue;
        }
        const bool smoke = meant.value_or(video.found.use) == VideoUse::smoke;
        (smoke ? clips : references).push_back(video.file);
        (smoke ? smoke_seen : surgery_seen) = video.found.reason;
    }
    const bool told = !meant;
    // All of one use together: the shelf takes one lot at a time.
    const auto put_all_to_use = [=, this](const std::vector<std::string>& more, std::optional<VideoUse> as) {
        std::vector<std::string> all_clips = clips, all_references = references;
        if (as == VideoUse::smoke) all_clips.insert(all_clips.end(), more.begin(), more.end());
        // There is one reference: the one that a person chose, and not one that was only recognised.
        const bool chosen = as == VideoUse::reference;
        if (chosen) all_references.insert(all_references.begin(), more.begin(), more.end());
        if (told && !clips.empty()) tell_what_for(clips, VideoUse::smoke, smoke_seen);
        if (told && !references.empty() && !chosen) tell_what_for(references, VideoUse::reference, surgery_seen);
        put_to_use(all_clips, VideoUse::smoke);
        put_to_use(all_references, VideoUse::reference);
    };
    if (unclear.empty()) return put_all_to_use({}, {});
    std::vector<std::string> asked;
    for (const LookedAt& video : unclear) asked.push_back(video.file);
    ask_what_for(unclear, [put_all_to_use, asked](std::optional<VideoUse> as) { put_all_to_use(asked, as); });
}

void Files::ask_what_for(const std::vector<LookedAt>& videos, std::function<void(std::optional<VideoUse>)> then) {
    const bool one = videos.size() == 1;
    const auto smoke = std::count_if(videos.begin(), videos.end(),
                                     [](const LookedAt& video) { return video.found.use == VideoUse::smoke; });
    const bool smoke_likelier = 2 * static_cast<std::size_t>(smoke) > videos.size();
    std::vector<std::string> lines;
    for (const LookedAt& video : videos) lines.push_back(in_marks(video.file) + ": " + video.found.reason);
    ask({.title = one ? "What is " + in_marks(videos.front().file) + '?' : "What are these videos?",
         .text = "Smoke on a plain background becomes a clip of the preset. A surgery video becomes the reference, "
                 "with which the preview is compared.",
         .lines = std::move(lines),
         .answers = {{.label = one ? "Smoke clip" : "Smoke clips",
                      .tip = "Adds to the clips of the preset",
                      .act = [then] { then(VideoUse::smoke); },
                      .standard = smoke_likelier},
                     {.label = "Reference",
                      .tip = one ? "Compares the preview with it" : "Compares the preview with the first of them",
                      .act = [then] { then(VideoUse::reference); },
                      .standard = !smoke_likelier},
                     {.label = "Cancel", .act = [then] { then({}); }, .cancel = true}}});
}

void Files::put_to_use(const std::vector<std::string>& videos, VideoUse as) {
    if (videos.empty()) return;
    if (as == VideoUse::smoke) {
        parts_.layouts.bring_to_front("Clips");
        return parts_.clips.add(videos);
    }
    parts_.layouts.bring_to_front("Reference");
    // Chosen again, it would lose its offset and its marks.
    if (!is_same(parts_.reference.file(), videos.front())) parts_.reference.choose(videos.front());
}

/// Before put_to_use(), because its button goes back to what was there.
void Files::tell_what_for(const std::vector<std::string>& videos, VideoUse as, const std::string& reason) {
    const std::string file = videos.front(), name = fs::path(file).filename().string();
    const std::string why = videos.size() == 1 ? ": " + reason : "";
    const auto tell = [&](std::string text, const char* action, Then act) {
        parts_.notices.add({.kind = ui::ToastKind::info,
                            .text = std::move(text),
                            .action = action,
                            .act = std::move(act),
                            .seconds = told_for});
    };
    if (as == VideoUse::smoke) {
        const std::ptrdiff_t before = count_of(parts_.document.preset(), file);
        const auto make_reference = [this, file, before] {
            parts_.clips.give_up(file);
            if (count_of(parts_.document.preset(), file) > before)
                parts_.document.change("Remove clip", [&](document::Content& c) {
                    std::vector<SmokeClip>& clips = c.preset.smoke.clips;
                    const auto last = std::find_if(clips.rbegin(), clips.rend(),
                                                   [&](const SmokeClip& clip) { return names(clip, c.preset, file); });
                    clips.erase(std::next(last).base());
                });
            put_to_use({file}, VideoUse::reference);
        };
        if (videos.size() == 1)
            return tell(name + " becomes a smoke clip" + why, "Make it the reference", make_reference);
        return tell(std::to_string(videos.size()) + " videos become smoke clips", "", {});
    }
    if (is_same(parts_.reference.file(), file)) return tell(name + " is the reference already", "", {});
    const auto make_clip = [this, file, before = parts_.document.scene()] {
        parts_.reference.give_up_choosing();
        if (is_same(parts_.reference.file(), file))
            parts_.document.change("Former reference", [&](document::Content& c) {
                c.scene.reference = before.reference;
                std::string& former = c.scene.reference.file;
                former = document::moved_path(former, before.folder, c.scene.folder);
                c.scene.plate.frame = before.plate.frame;
                c.scene.plate.time = before.plate.time;
            });
        put_to_use({file}, VideoUse::smoke);
    };
    const std::string text = name + " becomes the reference" + why;
    if (videos.size() == 1) return tell(text, "Use it as a smoke clip instead", make_clip);
    tell(text + ", the first of " + std::to_string(videos.size()) + " surgery videos", "", {});
}

}  // namespace lapfx::app
