// Suggesting for a file: what decoding has to do with it.
#include <algorithm>

#include "smoke/decoder.h"
#include "smoke/suggest_cpu.h"

namespace lapfx {

namespace {

constexpr int looked_at = 24;  // pictures: a loop's smoke has gone through its whole path

}  // namespace

void KeyingSuggestion::apply(SmokeClip& clip) const {
    clip.own_keying = true;
    clip.keying.luma_low = keying.luma_low, clip.keying.luma_high = keying.luma_high;
    clip.keying.key_color = keying.key_color;
    clip.keying.chroma_low = keying.chroma_low, clip.keying.chroma_high = keying.chroma_high;
    clip.keying.spill = keying.spill;
    clip.polarity = polarity;
    if (crop != ClipCrop{}) clip.crop = crop;
    if (edge_fade > 0.0) clip.edge_fade = std::max(clip.edge_fade, edge_fade);
    if (clip.masks.empty()) clip.masks = masks;
}

KeyingSuggestion suggest_keying(const std::filesystem::path& clip) {
    smoke::Decoder decoder(clip, smoke::Layout::rgb);
    const smoke::ClipInfo& info = decoder.info();
    smoke::KeyingSurvey survey;
    smoke::Picture picture;
    const int wanted = std::min(info.frame_count(), looked_at);
    for (int i = 0; i < wanted; ++i) {
        const auto index = static_cast<int>((2L * i + 1) * info.frame_count() / (2L * wanted));
        if (!decoder.read(index, picture)) continue;  // broken: the one before has been looked at
        survey.add(info.size, {picture.bytes.data(), decoder.format().color_bytes()});
    }
    KeyingSuggestion found = survey.suggest();
    found.alpha = info.alpha;
    if (info.alpha) found.reason = "the clip brings its own opacity, which takes the place of keying; " + found.reason;
    return found;
}

}  // namespace lapfx
