#include "app/events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lapfx::app {

namespace {

constexpr double no_gap = 1e-6;  // s and mm

bool goes_on(const ToolContact& before, const ToolContact& after) {
    return before.action == after.action && std::abs(before.end() - after.time) <= no_gap &&
           glm::distance(before.to, after.position) <= no_gap;
}

double on_grid(double value, double per_unit) {
    return std::round(value * per_unit) / per_unit;
}

/// From the first of these to the last, straight.
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

std::string_view action_title(ToolAction action) {
    constexpr std::array<std::string_view, action_count> titles = {"Cauterise", "Cut",     "Coagulate",
                                                                   "Tear",      "Suction", "Irrigation"};
    return titles[static_cast<std::size_t>(action)];
}

bool is_hot(ToolAction action) {
    return ToolContact{.action = action}.hot();
}

bool is_cutting(ToolAction action) {
    return action == ToolAction::cauterise || action == ToolAction::cut || action == ToolAction::tear;
}

std::vector<Stay> stays_of(std::span<const ToolContact> events) {
    std::vector<std::size_t> order(events.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return events[a].time < events[b].time; });
    std::vector<Stay> stays;
    std::array<std::size_t, action_count> newest;  // of each action
    newest.fill(events.size());
    for (const std::size_t i : order) {
        const ToolContact& event = events[i];
        std::size_t& last = newest[static_cast<std::size_t>(event.action)];
        if (last < stays.size() && goes_on(events[stays[last].events.back()], event)) {
            stays[last].events.push_back(i);
            stays[last].end = event.end();
            continue;
        }
        last = stays.size();
        stays.push_back({.events = {i}, .action = event.action, .start = event.time, .end = event.end()});
    }
    const auto first = [](const Stay& stay) { return *std::min_element(stay.events.begin(), stay.events.end()); };
    std::stable_sort(stays.begin(), stays.end(), [&](const Stay& a, const Stay& b) { return first(a) < first(b); });
    return stays;
}

void move_stay(std::span<ToolContact> events, const Stay& stay, double start) {
    const double by = start - stay.start;
    for (const std::size_t i : stay.events) events[i].time = std::clamp(events[i].time + by, 0.0, last_event_time);
}

void stretch_stay(std::span<ToolContact> events, const Stay& stay, double start, double end) {
    const double length = stay.end - stay.start, factor = length > 0 ? (end - start) / length : 1;
    const auto at = [&](double t) { return std::clamp(start + (t - stay.start) * factor, 0.0, last_event_time); };
    if (!(length > 0)) {
        ToolContact& only = events[stay.events.front()];
        only.time = std::clamp(start, 0.0, last_event_time);
        only.duration = std::clamp(end - start, 0.0, last_event_time);
        return;
    }
    for (const std::size_t i : stay.events) {
        const double stop = at(events[i].end());
        events[i].time = at(events[i].time);
        events[i].duration = std::max(stop - events[i].time, 0.0);
    }
}

void shift_stay(std::span<ToolContact> events, const Stay& stay, const glm::dvec3& by) {
    for (const std::size_t i : stay.events) {
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
