#include "smoke/plume_cpu.h"

#include <algorithm>

namespace lapfx::smoke {

namespace {

/// 0 before `from`, 1 after `to`, smooth between; a step when they are equal.
double fade(double from, double to, double time) {
    return to > from ? glm::smoothstep(from, to, time) : (time >= from ? 1.0 : 0.0);
}

}  // namespace

PlumeState plume_state(const ToolContact& contact, const PlumeParameters& plume, glm::dvec3 up, double time,
                       double fat) noexcept {
    PlumeState state;
    if (!contact.hot() || time < contact.time || time > contact.end() + plume.fade_out) return state;
    const double after = std::max(0.0, time - contact.end());
    const double envelope = fade(contact.time, contact.time + plume.fade_in, time) *
                            (1.0 - fade(contact.end(), contact.end() + plume.fade_out, time));
    state.density = plume.density * emission(contact, fat, plume) * envelope;
    state.anchor = contact.tip(time) + plume.rise * after * up;
    // A young plume is small: it reaches its size as it fades in.
    state.height = plume.size * (0.6 + 0.4 * fade(contact.time, contact.time + 2.0 * plume.fade_in, time)) *
                   (1.0 + plume.growth * after);
    return state;
}

}  // namespace lapfx::smoke
