// Suggests keying for a file: decoding for keying_survey.h.
#include <algorithm>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/error.h"
#include "media/decoder.h"
#include "smoke/keying_survey.h"

namespace lapfx {

namespace {

constexpr int looked_at = 24;  // pictures, enough to see smoke everywhere on its path
constexpr int looked_at_for_use = 16;
constexpr int any_frames = 10'000'000;  // of a surgery, which may last for hours; a clip may not

/// Adds `wanted` pictures, evenly spaced over the clip.
media::ClipInfo look_through(const std::filesystem::path& clip, int wanted, int most_frames,
                             smoke::KeyingSurvey& survey, const std::atomic<bool>* stop) {
    media::Decoder decoder = media::open_stoppable(clip, media::Layout::rgb, most_frames, stop);
    const media::ClipInfo& info = decoder.info();
    media::Picture picture;
    wanted = std::min(info.frame_count(), wanted);
    for (int i = 0; i < wanted; ++i) {
        const auto index = static_cast<int>((2L * i + 1) * info.frame_count() / (2L * wanted));
        const bool read = decoder.read(index, picture, stop);
        if (stop != nullptr && *stop)
            throw Error(Failure::runtime,
                        Fault{.file = clip.string(), .place = "", .reason = "was not read to its end"});
        if (!read) continue;  // a broken frame repeats the one before
        survey.add(info.size, {picture.bytes.data(), decoder.format().color_bytes()});
    }
    return info;
}

}  // namespace

void KeyingSuggestion::apply(SmokeClip& clip) const {
    clip.own_keying = true;
    clip.keying.luma_low = keying.luma_low, clip.keying.luma_high = keying.luma_high;
    clip.keying.key_color = keying.key_color;
    clip.keying.chroma_low = keying.chroma_low, clip.keying.chroma_high = keying.chroma_high;
    clip.keying.spill = keying.spill;
    clip.polarity = polarity;
    if (crop != ClipCrop{}) clip.crop = crop;
    // What fills the view has no edge to fade.
    if (!row_of(clip.role).fills_view) clip.edge_fade = std::max(clip.edge_fade, edge_fade);
    for (const ClipMask& mask : masks)
        if (clip.masks.size() < most_masks && std::find(clip.masks.begin(), clip.masks.end(), mask) == clip.masks.end())
            clip.masks.push_back(mask);
}

KeyingSuggestion suggest_keying(const std::filesystem::path& clip, const std::atomic<bool>* stop) {
    smoke::KeyingSurvey survey;
    const media::ClipInfo info = look_through(clip, looked_at, media::Decoder::most_frames, survey, stop);
    KeyingSuggestion found = survey.suggest();
    found.alpha = info.alpha;
    if (info.alpha) found.reason = "the clip has its own opacity, which is used instead of keying; " + found.reason;
    return found;
}

UseSuggestion suggest_use(const std::filesystem::path& video, const std::atomic<bool>* stop) {
    smoke::KeyingSurvey survey;
    const media::ClipInfo info = look_through(video, looked_at_for_use, any_frames, survey, stop);
    if (info.alpha) return {.use = VideoUse::smoke, .sure = true, .reason = "it has its own opacity"};
    if (survey.empty())
        throw Error(Failure::bad_input,
                    Fault{.file = video.string(), .place = "", .reason = "not one of its pictures can be read"});
    return smoke::use_of(survey.look());
}

}  // namespace lapfx
