#pragma once

namespace lapfx::media {

/// What to do when a frame has not been decoded yet.
enum class Policy {
    wait,    ///< wait for exactly this frame: offline rendering, tests
    latest,  ///< never wait: show the newest frame, and count the miss; a late clip is shown in slow motion
    skip,    ///< never wait: a late clip skips every second frame and so keeps its time (the paper's buffering)
};

}  // namespace lapfx::media
