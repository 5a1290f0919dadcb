#include "app/preview/timeline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lapfx::app {

void Timeline::seek(double to) {
    time = std::clamp(to, 0.0, duration());
}

void Timeline::advance(double seconds, bool endless) {
    if (!playing()) return;
    double next = time + speed * seconds;
    // Of a part that lies outside of the scene, by the reference's offset, what is left of it plays.
    const ui::Span inside{std::clamp(range.low, 0.0, duration()), std::clamp(range.high, 0.0, duration())};
    const bool part = has_range && inside.length() > 0;
    const double begin = part ? inside.low : 0, end = part ? inside.high : duration();
    if (!endless && (next >= end || next < begin)) {
        if (loop && end > begin) {
            next = begin + std::fmod(std::fmod(next - begin, end - begin) + (end - begin), end - begin);
        } else {
            next = std::clamp(next, begin, end);
            speed = 0;
        }
    }
    time = next;
}

void Timeline::follow() {
    if (document_.scene_changes_since(std::exchange(followed_, document_.version())) == 0) return;
    const SceneReference& reference = document_.scene().reference;
    has_range = reference.loop.set();
    if (has_range) range = {reference.loop.from - reference.offset, reference.loop.to - reference.offset};
}

void Timeline::put_range(document::Content& content) const {
    const auto rounded = [](double s) { return std::round(s * 1e4) / 1e4; };  // far below a frame
    SceneReference& reference = content.scene.reference;
    reference.loop = {};
    if (has_range)
        reference.loop = {.from = rounded(range.low + reference.offset), .to = rounded(range.high + reference.offset)};
}

void Timeline::take_range(const ui::Edit& edit) {
    document_.take(edit, "Loop range", [this](document::Content& c) { put_range(c); });
    if (edit.began || edit.changed || edit.committed || edit.cancelled) follow();
}

void Timeline::end_range_at(bool in) {
    const ui::Span before = has_range ? range : ui::Span{0, duration()};
    ui::Span now = in ? ui::Span{time, before.high} : ui::Span{before.low, time};
    if (now.length() <= 0) now = in ? ui::Span{time, duration()} : ui::Span{0, time};
    if (now.length() <= 0) return;  // at the very end of the scene
    has_range = true;
    range = now;
    take_range(ui::Edit::once());
}

void Timeline::drop_range() {
    if (!std::exchange(has_range, false)) return;
    take_range(ui::Edit::once());
}

}  // namespace lapfx::app
