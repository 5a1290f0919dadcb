#pragma once

namespace lapfx::media {

/// What to do when a frame has not been decoded yet.
enum class Policy {
    wait,    ///< wait for exactly this frame: offline rendering, tests
    latest,  ///< never wait: show the newest one there is, and count the miss; what is late is shown in slow motion
    skip,    ///< never wait: of a clip that is late every second frame is skipped, and it keeps its time (the paper's
             ///< buffering)
};

}  // namespace lapfx::media
