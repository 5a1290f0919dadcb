#include "app/base/saved.h"

#include <algorithm>

namespace lapfx::app {

namespace {

constexpr auto no_clip = static_cast<std::size_t>(-1);

}  // namespace

const document::Content& Saved::content() {
    follow();
    return content_;
}

const SmokeClip* Saved::known_clip(std::size_t number) {
    follow();
    if (number >= clips_.size() || clips_[number] == no_clip) return nullptr;
    return &content_.preset.smoke.clips[clips_[number]];
}

const SmokeClip& Saved::clip(std::size_t number) {
    static const SmokeClip standard;
    const SmokeClip* const known = known_clip(number);
    return known != nullptr ? *known : standard;
}

const KeyingParameters& Saved::keying(std::size_t number) {
    const SmokeParameters& smoke = document_.preset().smoke;
    const SmokeClip& saved = clip(number);
    const bool own = number < smoke.clips.size() && smoke.clips[number].own_keying && saved.own_keying;
    return own ? saved.keying : content_.preset.smoke.keying;
}

void Saved::follow() {
    if (followed_ == document_.version()) return;
    bool scene_differs = document_.scene_changes_since(followed_) != 0;
    bool clips_differ = (document_.preset_changes_since(followed_) & redo::clips) != 0;
    followed_ = document_.version();
    if (const auto& saved = document_.saved_preset(); saved != preset_) {
        preset_ = saved;
        content_.preset = saved ? *saved : Preset{};
        clips_differ = true;
    }
    if (const auto& saved = document_.saved_scene(); saved != scene_) {
        scene_ = saved;
        content_.scene = saved ? *saved : Scene{};
        scene_differs = true;
    }
    // Its files may be named from another folder now.
    if (scene_differs && !document_.scene_unsaved()) content_.scene = document_.scene();
    if (clips_differ) follow_clips();
}

void Saved::follow_clips() {
    const Preset &now = document_.preset(), &saved = content_.preset;
    // If both have the same folder, the disk need not be read.
    const auto files = [asks = now.folder != saved.folder](const Preset& preset) {
        std::vector<std::filesystem::path> all;
        for (const SmokeClip& clip : preset.smoke.clips)
            all.push_back(asks ? document::real_clip(clip.file, preset.folder) : std::filesystem::path(clip.file));
        return all;
    };
    const auto present = files(now);
    auto before = files(saved);
    clips_.assign(present.size(), no_clip);
    for (std::size_t i = 0; i < present.size(); ++i) {
        const auto found = std::find(before.begin(), before.end(), present[i]);
        if (found == before.end() || found->empty()) continue;
        clips_[i] = static_cast<std::size_t>(found - before.begin());
        found->clear();  // the next one of that name is the next one saved
    }
}

}  // namespace lapfx::app
