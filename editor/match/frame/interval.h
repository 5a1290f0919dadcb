// How far a measured amount may be from the true one.
#pragma once

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Sets the intervals of both amounts from the other figures of the frame. They are fitted to renders whose amounts
/// are known exactly, so that nine of ten hold the true amount: `lapfx bench measure` prints how many do.
void set_intervals(FrameAmounts& a);

/// Of blood that a person's strokes tell (painted_blood.h), from its value: the true area is that times or divided by
/// 2, give or take 0.005. Nothing from inside, such as votes of several classifiers, held as often: on labelled frames
/// of four real operations this held nine of ten in a trial, and about seven of ten where strokes are drawn at random
/// over two of them (`lapfx bench measure --labelled`).
void set_painted_interval(Amount& blood);

}  // namespace lapfx::match
