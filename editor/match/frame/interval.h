// How far a measured amount may be from the true one.
#pragma once

#include "match/frame/added_light.h"
#include "match/frame/frame_amounts.h"

namespace lapfx::match {

/// Sets the intervals of both amounts from the other figures of the frame. They are fitted to renders whose amounts
/// are known exactly, so that nine of ten hold the true amount: `lapfx bench measure` prints how many do.
void set_intervals(FrameAmounts& a);

/// Of how much of the veil stands out (FrameAmounts::plume), from its value: dense plumes are told too thin.
void set_plume_interval(Amount& plume);

/// Sets the added light and the camera's gain to what was found, with their intervals, after the frame's flags are
/// known. A gain below 1 that no added light explains may as well be a veil that throws no light back: its interval
/// reaches up to 1 then. Where nothing is known the light is 0, the gain 1, and the intervals hold everything.
void set_camera_intervals(FrameAmounts& a, const AddedLight& found);

/// Of blood that a person's strokes tell (painted_blood.h), from its value: the true area is that times or divided by
/// 2, give or take 0.005. Nothing from inside, such as votes of several classifiers, held as often: on labelled frames
/// of four real operations this held nine of ten in a trial, and about seven of ten where strokes are drawn at random
/// over two of them (`lapfx bench measure --labelled`).
void set_painted_interval(Amount& blood);

}  // namespace lapfx::match
