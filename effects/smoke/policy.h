#pragma once

namespace lapfx::smoke {

/// What to do when a frame has not been decoded yet.
enum class Policy {
    wait,    ///< wait for exactly this frame: offline rendering, tests
    latest,  ///< never wait: show the newest one there is, and count the miss
};

}  // namespace lapfx::smoke
