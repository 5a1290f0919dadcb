// smoke_notes(): what the clips of a preset leave out.
#include <algorithm>

#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/smoke_notes.h"

namespace lapfx {

std::vector<std::string> smoke_notes(const SmokeParameters& smoke) {
    const auto wanted = [&](const ClipRoleRow& row) { return row.wanted(smoke); };
    if (std::none_of(std::begin(clip_roles), std::end(clip_roles), wanted)) return {};
    if (smoke.clips.empty()) return {"no smoke clips: cautery makes no smoke"};
    const auto shown = [&](ClipRole role) {
        return std::any_of(smoke.clips.begin(), smoke.clips.end(),
                           [&](const SmokeClip& clip) { return clip.role == role && clip.weight > 0.0; });
    };
    std::vector<std::string> notes;
    for (const ClipRoleRow& row : clip_roles)
        if (wanted(row) && !shown(row.role))
            notes.push_back("no clip has the role " + std::string(row.key) + ": " + std::string(row.without));
    return notes;
}

}  // namespace lapfx
