#include "media/playhead.h"

#include <algorithm>
#include <cmath>

namespace lapfx::media {

namespace {

/// Frames come this much early, s, so that rounding of k / fps does not show one of them twice.
constexpr double early = 1e-6;

/// The part of a clip that plays, s: from `in`, repeated every `period`; the last `fade` before in + period + fade
/// fades over the beginning.
struct Span {
    double in, period, fade;
};

Span span_of(const ClipInfo& clip, const SmokeClip& settings) {
    // A preset may outlive the clip that it was tuned with: points beyond the end are the end.
    const double out = settings.out > 0.0 ? std::min(settings.out, clip.duration) : clip.duration;
    const double in = std::min(settings.in, clip.times.back());
    const double length = std::max(out - in, 0.0);
    const double fade = std::min(settings.crossfade, 0.5 * length);
    return {in, length - fade, fade};
}

Loop frames_between(const ClipInfo& clip, double from, double to) {
    const int first = clip.frame_at(from + early);
    return {first, std::max(first, clip.frame_at(to - early))};
}

}  // namespace

Playhead playhead(const ClipInfo& clip, const SmokeClip& settings, std::uint32_t chance, double time) noexcept {
    const Span span = span_of(clip, settings);
    const double start = settings.start == ClipStart::seeded ? chance * 0x1p-32 * span.period : 0.0;
    double place = span.period > 0.0 ? std::fmod(start + time * settings.speed + early, span.period) : 0.0;
    if (place < 0.0) place += span.period;
    Playhead head{.frame = clip.frame_at(span.in + place)};
    if (place < span.fade) {
        head.fading = clip.frame_at(span.in + span.period + place);
        head.fade = 1.0 - place / span.fade;
    }
    return head;
}

Loop main_loop(const ClipInfo& clip, const SmokeClip& settings) noexcept {
    const Span span = span_of(clip, settings);
    return frames_between(clip, span.in, span.in + span.period);
}

Loop fading_loop(const ClipInfo& clip, const SmokeClip& settings) noexcept {
    const Span span = span_of(clip, settings);
    return frames_between(clip, span.in + span.period, span.in + span.period + span.fade);
}

}  // namespace lapfx::media
