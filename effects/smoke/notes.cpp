// smoke_notes(): what the clips of a preset leave out.
#include <algorithm>

#include "lapfx/authoring/smoke_notes.h"

namespace lapfx {

std::vector<std::string> smoke_notes(const SmokeParameters& smoke) {
    const bool plume = smoke.plume.density > 0.0, haze = smoke.haze.accumulation > 0.0;
    if (!plume && !haze) return {};
    if (smoke.clips.empty()) return {"no smoke clips: cautery makes no smoke"};
    const auto shown = [&](ClipRole role) {
        return std::any_of(smoke.clips.begin(), smoke.clips.end(),
                           [&](const SmokeClip& clip) { return clip.role == role && clip.weight > 0.0; });
    };
    std::vector<std::string> notes;
    if (plume && !shown(ClipRole::plume)) notes.push_back("no clip has the role plume: no smoke at the tool tip");
    if (haze && !shown(ClipRole::haze)) notes.push_back("no clip has the role haze: the haze is an even veil");
    return notes;
}

}  // namespace lapfx
