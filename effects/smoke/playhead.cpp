#include "smoke/playhead.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

Playhead playhead(const ClipInfo& clip, const SmokeClip& settings, std::uint32_t chance, double time) noexcept {
    const int count = clip.frame_count();
    const double fps = count / clip.duration;
    const double start = chance % static_cast<std::uint32_t>(count);
    const double played = std::floor(start + time * fps * settings.speed);
    const double looped = std::fmod(std::fmod(played, count) + count, count);
    Playhead head;
    head.frame = std::clamp(static_cast<int>(looped), 0, count - 1);
    if (settings.crossfade > 0.0) {
        head.fading = (head.frame + count / 2) % count;
        head.fade = 0.4;
    }
    return head;
}

}  // namespace lapfx::smoke
