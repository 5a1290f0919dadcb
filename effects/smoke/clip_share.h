// How much of a role's smoke one clip shows. Pure, any thread.
#pragma once

#include <span>

#include "lapfx/smoke_parameters.h"

namespace lapfx::smoke {

/// The clip's weight as a part of the weights of all clips of its role, 0..1: all shares of a role together are 1, or 0
/// where no clip has a weight.
inline double clip_share(std::span<const SmokeClip> clips, const SmokeClip& clip) noexcept {
    double all = 0.0;
    for (const SmokeClip& other : clips)
        if (other.role == clip.role) all += other.weight;
    return all > 0.0 ? clip.weight / all : 0.0;
}

}  // namespace lapfx::smoke
