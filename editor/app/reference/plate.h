// The plate of the scene as a switch: a frame of the reference in place of the organ (lapfx/scene.h). UI thread.
#pragma once

#include "document/document.h"

namespace lapfx::app {

/// An undo step: turns the plate on or off. What it is made of stays.
void show_plate(document::Document& document, bool on);
/// An undo step: the frame at `time`, s in the reference, becomes the plate.
void plate_from(document::Document& document, double time);

}  // namespace lapfx::app
