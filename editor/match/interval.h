// How far a measured amount may be from the true one.
#pragma once

#include <span>

namespace lapfx::match {

struct FrameAmounts;

/// Sets the intervals of both amounts from the other figures of the frame. They are fitted to renders whose amounts
/// are known exactly, so that nine of ten hold the true amount: `lapfx bench measure` prints how many do.
void set_intervals(FrameAmounts& a);

/// Frames that the file could not give (told::missing) have the amounts of the one before them: their intervals grow to
/// hold those of the frames on both sides of the gap.
void widen_missing(std::span<FrameAmounts> frames);

}  // namespace lapfx::match
