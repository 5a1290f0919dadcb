// How far a measured amount may be from the true one.
#pragma once

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Sets the intervals of both amounts from the other figures of the frame. They are fitted to renders whose amounts
/// are known exactly, so that nine of ten hold the true amount: `lapfx bench measure` prints how many do.
void set_intervals(FrameAmounts& a);

}  // namespace lapfx::match
