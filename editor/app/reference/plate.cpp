#include "app/reference/plate.h"

#include <cmath>

namespace lapfx::app {

void show_plate(document::Document& document, bool on) {
    document.change(on ? "Plate from the reference" : "Organ in place of the plate",
                    [on](document::Content& c) { c.scene.plate.use = on; });
}

void plate_from(document::Document& document, double time) {
    document.change("Plate from this frame", [time](document::Content& c) {
        c.scene.plate.use = true;
        c.scene.plate.frame = PlateFrame::chosen;
        c.scene.plate.time = std::round(time * 1e4) / 1e4;  // far below a frame, and short in the file
    });
}

}  // namespace lapfx::app
