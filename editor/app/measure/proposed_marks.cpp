#include "app/measure/proposed_marks.h"

#include <cmath>
#include <string>

#include "app/measure/measuring.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"

namespace lapfx::app {

namespace {

double time_of(const Parameter& row, const ReferenceMarks& marks) {
    return std::get<double>(row.get(&marks));
}

double shortened(std::optional<double> time) {
    return time ? std::round(*time * 1e4) / 1e4 : -1;
}

}  // namespace

ReferenceMarks marks_of(const match::Measurement& found) {
    ReferenceMarks marks;
    const match::Episode &veil = found.veil, &blood = found.blood;
    marks.smoke_starts = shortened(veil.onset);
    marks.smoke_peaks = shortened(veil.peak_at);
    if (veil.peak_at && veil.decay) marks.smoke_clears = shortened(*veil.peak_at + *veil.decay);
    marks.blood_starts = shortened(blood.onset);
    return marks;
}

ReferenceMarks marks_to_take(const Measuring& measuring, const document::Document& document) {
    if (measuring.found() == nullptr || measuring.stale()) return {};
    ReferenceMarks marks = marks_of(*measuring.found());
    for (const Parameter& row : Reference::mark_table().rows)
        if (time_of(row, document.scene().reference.marks) >= 0) row.set(&marks, -1.0);
    return marks;
}

bool any_marks(const ReferenceMarks& marks) {
    const ReferenceMarks none;
    return !equal(Reference::mark_table(), &marks, &none);
}

void take_marks(document::Document& document, const ReferenceMarks& marks) {
    std::string name;
    int count = 0;
    for (const Parameter& row : Reference::mark_table().rows)
        if (time_of(row, marks) >= 0 && ++count == 1) name = "Mark: " + std::string(row.name);
    if (count == 0) return;
    document.change(count == 1 ? name : "Take proposed marks", [&](document::Content& c) {
        for (const Parameter& row : Reference::mark_table().rows)
            if (const double time = time_of(row, marks); time >= 0) row.set(&c.scene.reference.marks, time);
    });
}

}  // namespace lapfx::app
