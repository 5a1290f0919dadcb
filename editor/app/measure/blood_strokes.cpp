#include "app/measure/blood_strokes.h"

#include <cmath>
#include <string>
#include <utility>

#include "app/base/not_opened.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "match/frame/blood_strokes.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

namespace fs = std::filesystem;

double time_within(const VideoReader& video, int frame) {
    constexpr double after = 1e-3;  // so that rounding does not lead to the frame before
    return std::round(1e3 * (video.time_of(frame) + after)) / 1e3;
}

void open_strokes(document::Document& document, const Reference& reference, const fs::path& path, Notices& notices) {
    if (reference.video() == nullptr) return;
    try {
        match::BloodStrokes read = match::read_blood_strokes(read_file(path, match::longest_strokes), path.string(),
                                                             reference.video()->info().size);
        document.change("Open strokes", [&](document::Content& c) {
            c.scene.reference.measure.strokes = std::move(read.strokes);
            c.scene.reference.measure.without_blood = read.without_blood.value_or(-1.0);
        });
    } catch (const Error& error) {
        notices.tell(error.faults());
    }
}

void export_strokes(const ReferenceMeasure& measure, const fs::path& path, Notices& notices) {
    try {
        require_not_opened(path);
        write_file(path, match::write_blood_strokes(match::painted_strokes(measure)));
        notices.add({.text = "Exported " + path.filename().string()});
    } catch (const Error& error) {
        notices.tell(error.faults());
    }
}

void name_frame_without_blood(document::Document& document, const Reference& reference) {
    if (reference.video() == nullptr) return;
    const double time = time_within(*reference.video(), reference.frame());
    document.change("No blood in this frame",
                    [&](document::Content& c) { c.scene.reference.measure.without_blood = time; });
}

void remove_strokes(document::Document& document) {
    document.change("Remove strokes", [](document::Content& c) {
        c.scene.reference.measure.strokes.clear();
        c.scene.reference.measure.without_blood = -1.0;
    });
}

}  // namespace lapfx::app
