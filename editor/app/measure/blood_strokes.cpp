#include "app/measure/blood_strokes.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/base/not_opened.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/file.h"
#include "lapfx/error.h"
#include "match/frame/blood_strokes.h"
#include "match/use/measure_video.h"
#include "match/video/painted_video.h"
#include "match/video/shots.h"

namespace lapfx::app {

namespace fs = std::filesystem;

double time_within(const VideoReader& video, int frame) {
    constexpr double after = 1e-3;  // so that rounding does not lead to the frame before
    return std::round(1e3 * (video.time_of(frame) + after)) / 1e3;
}

std::string text_of(const Fault& fault, const ReferenceMeasure& measure) {
    constexpr std::string_view before = "/strokes/";
    const std::size_t found = fault.place.find(before);
    std::size_t number = 0;
    if (found == std::string::npos) return fault.reason;
    const char* const end = fault.place.data() + fault.place.size();
    const auto read = std::from_chars(fault.place.data() + found + before.size(), end, number);
    if (read.ec != std::errc{} || number >= measure.strokes.size()) return fault.reason;
    return "stroke " + std::to_string(number + 1) + " at " + match::seconds_text(measure.strokes[number].time) + ": " +
           fault.reason;
}

void open_strokes(document::Document& document, const Reference& reference, const fs::path& path, Notices& notices) {
    if (reference.video() == nullptr) return;
    try {
        match::BloodStrokes read = match::read_blood_strokes(read_file(path, match::longest_strokes), path.string(),
                                                             reference.video()->info().size);
        match::check_times(*reference.video(), read);
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
