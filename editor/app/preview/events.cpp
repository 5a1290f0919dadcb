#include "app/preview/events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "lapfx/authoring/strokes.h"

namespace lapfx::app {

namespace {

double on_grid(double value, double per_unit) {
    return std::round(value * per_unit) / per_unit;
}

/// The straight contact from the first of these to the last.
ToolContact joined(std::span<const ToolContact> contacts) {
    ToolContact one = contacts.front();
    one.duration = contacts.back().end() - one.time;
    one.to = contacts.back().to;
    return one;
}

bool nearly_straight(std::span<const ToolContact> contacts, double tolerance) {
    const ToolContact one = joined(contacts);
    return std::all_of(contacts.begin(), contacts.end(),
                       [&](const ToolContact& c) { return glm::distance(one.tip(c.time), c.position) <= tolerance; });
}

}  // namespace

std::vector<Stroke> strokes_of(std::span<const ToolContact> events) {
    std::vector<std::size_t> order(events.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return events[a].time < events[b].time; });
    std::vector<Stroke> strokes;
    std::vector<std::size_t> stroke_of(order.size());  // each event in the order of time has one
    std::vector<char> is_continued(order.size(), false);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const ToolContact& event = events[order[i]];
        const auto before = goes_on_from(
            i, [&](std::size_t k) -> const ToolContact& { return events[order[k]]; },
            [&](std::size_t k) { return is_continued[k] != 0; });
        stroke_of[i] = before ? stroke_of[*before] : strokes.size();
        if (!before) {
            strokes.push_back({.events = {order[i]}, .action = event.action, .start = event.time, .end = event.end()});
            continue;
        }
        is_continued[*before] = true;
        strokes[stroke_of[i]].events.push_back(order[i]);
        strokes[stroke_of[i]].end = event.end();
    }
    const auto first = [](const Stroke& stroke) {
        return *std::min_element(stroke.events.begin(), stroke.events.end());
    };
    std::stable_sort(strokes.begin(), strokes.end(),
                     [&](const Stroke& a, const Stroke& b) { return first(a) < first(b); });
    return strokes;
}

void move_stroke(std::span<ToolContact> events, const Stroke& stroke, double start) {
    const double by = start - stroke.start;
    for (const std::size_t i : stroke.events) events[i].time = std::clamp(events[i].time + by, 0.0, last_event_time);
}

void stretch_stroke(std::span<ToolContact> events, const Stroke& stroke, double start, double end) {
    const double length = stroke.end - stroke.start, factor = length > 0 ? (end - start) / length : 1;
    const auto at = [&](double t) { return std::clamp(start + (t - stroke.start) * factor, 0.0, last_event_time); };
    if (!(length > 0)) {
        ToolContact& only = events[stroke.events.front()];
        only.time = std::clamp(start, 0.0, last_event_time);
        only.duration = std::clamp(end - start, 0.0, last_event_time);
        return;
    }
    for (const std::size_t i : stroke.events) {
        const double stop = at(events[i].end());
        events[i].time = at(events[i].time);
        events[i].duration = std::max(stop - events[i].time, 0.0);
    }
}

void shift_stroke(std::span<ToolContact> events, const Stroke& stroke, const glm::dvec3& by) {
    for (const std::size_t i : stroke.events) {
        events[i].position += by;
        events[i].to += by;
    }
}

void erase_events(std::vector<ToolContact>& events, std::span<const std::size_t> erased) {
    const std::set<std::size_t> gone(erased.begin(), erased.end());
    std::vector<ToolContact> left;
    for (std::size_t i = 0; i < events.size(); ++i)
        if (!gone.contains(i)) left.push_back(events[i]);
    events = std::move(left);
}

std::vector<ToolContact> simplified(std::span<const ToolContact> recorded, double tolerance) {
    std::vector<ToolContact> made;
    for (std::size_t begin = 0; begin < recorded.size();) {
        std::size_t end = begin + 1;
        while (end < recorded.size() && goes_on(recorded[end - 1], recorded[end]) &&
               recorded[end - 1].power == recorded[end].power && recorded[end - 1].strength == recorded[end].strength &&
               nearly_straight(recorded.subspan(begin, end + 1 - begin), tolerance))
            ++end;
        made.push_back(joined(recorded.subspan(begin, end - begin)));
        begin = end;
    }
    for (ToolContact& contact : made) {
        const double start = on_grid(contact.time, 1e4), stop = on_grid(contact.end(), 1e4);
        contact.time = start;
        contact.duration = on_grid(stop - start, 1e4);
        for (glm::dvec3* place : {&contact.position, &contact.to})
            *place = {on_grid(place->x, 1e3), on_grid(place->y, 1e3), on_grid(place->z, 1e3)};
    }
    return made;
}

}  // namespace lapfx::app
