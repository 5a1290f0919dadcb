#include "match/explain/wound_site.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapfx/amounts.h"
#include "match/explain/strokes.h"

namespace lapfx::match {

namespace {

/// s: a wound that closes sooner does not bleed.
constexpr double least_open = 0.1;
/// s after a stroke in which its heat may still close what it opened, or open more.
constexpr double heat_lasts = 2.0;
/// mm: wounds are no nearer to one another.
constexpr double same_place = 1.0;
// Extents that are asked for, mm: close together where the area begins, farther apart where it is a disc.
constexpr double least_step = 0.4, step_grows = 0.06, most_extent = 200.0;

double end_of(std::span<const ToolContact> contacts) {
    double end = contacts.front().end();
    for (const ToolContact& contact : contacts) end = std::max(end, contact.end());
    return end;
}

/// The preset in which blood grows evenly, without end.
Preset growing(const Preset& preset) {
    Preset even = preset;
    if (!(even.bleeding.speed > 0.0)) even.bleeding.speed = BleedingParameters{}.speed;
    even.bleeding.max_extent = most_extent;
    even.bleeding.pulse_strength = 0.0;
    return even;
}

}  // namespace

double Growth::area(double extent) const {
    if (!(extent > 0.0) || extents.size() < 2) return 0.0;
    auto next = static_cast<std::size_t>(std::upper_bound(extents.begin(), extents.end(), extent) - extents.begin());
    next = std::clamp<std::size_t>(next, 1, extents.size() - 1);
    const double share = (extent - extents[next - 1]) / (extents[next] - extents[next - 1]);
    const double root = std::lerp(std::sqrt(areas[next - 1]), std::sqrt(areas[next]), share);
    return root * root;
}

std::vector<ToolContact> WoundSite::contacts_at(double start, double of_strength,
                                                std::span<const ToolContact> events) const {
    if (contacts.empty())
        return {{.action = ToolAction::cut,
                 .time = std::max(start, 0.0),
                 .duration = 0.0,
                 .position = position,
                 .to = position,
                 .strength = of_strength}};
    const double later = std::max(start - delay, 0.0) - time;
    const bool none =
        std::all_of(contacts.begin(), contacts.end(), [&](std::size_t i) { return !(events[i].strength > 0.0); });
    std::vector<ToolContact> made;
    for (const std::size_t i : contacts) {
        made.push_back(events[i]);
        made.back().time += later;
        made.back().strength = none ? of_strength : events[i].strength / strength * of_strength;
    }
    return made;
}

std::optional<double> WoundSite::opens(std::span<const WoundStatus> wounds, std::span<const ToolContact> made) const {
    const double from = made.front().time, to = end_of(made) + heat_lasts;
    std::optional<double> first;
    for (const WoundStatus& status : wounds) {
        const Wound& wound = status.wound;
        if (wound.start < from || wound.start > to || wound.stop - wound.start < least_open) continue;
        if (glm::distance(wound.position, opened) < same_place && !(first < wound.start && first)) first = wound.start;
    }
    return first;
}

std::vector<WoundSite> strokes_that_divide(std::span<const ToolContact> events) {
    std::vector<WoundSite> sites;
    for (std::vector<std::size_t>& stroke :
         strokes_of(events, [](const ToolContact& contact) { return divides(contact.action); })) {
        const ToolContact& first = events[stroke.front()];
        WoundSite& site =
            sites.emplace_back(WoundSite{.position = first.position, .time = first.time, .strength = 0.0});
        for (const std::size_t i : stroke) site.strength = std::max(site.strength, events[i].strength);
        if (!(site.strength > 0.0)) site.strength = 1.0;
        site.contacts = std::move(stroke);
    }
    return sites;
}

bool probe(WoundSite& site, const WoundSearch& search, double largest) {
    const Preset preset = growing(search.preset);
    AmountsModel model(search.organ, {.gravity = search.scene.gravity});
    const std::vector<ToolContact> alone = site.contacts_at(site.time, site.strength, search.scene.events);
    Curves power;
    power.cautery_power = search.scene.curves.cautery_power;
    model.set(preset, alone, power);
    model.at(end_of(alone) + heat_lasts);
    const WoundStatus* first = nullptr;
    for (const WoundStatus& status : model.wounds()) {
        if (std::isfinite(status.wound.stop) || !(status.wound.strength > 0.0)) continue;
        if (!first || status.wound.start < first->wound.start) first = &status;
    }
    if (!first) return false;
    const Wound wound = first->wound;
    site.delay = wound.start - alone.front().time;
    site.factor = wound.strength / site.strength;
    site.opened = wound.position;
    for (double extent = least_step; extent <= most_extent; extent += least_step + step_grows * extent) {
        const double area = model.at(wound.start + extent / (preset.bleeding.speed * wound.strength)).blood_area;
        site.growth.extents.push_back(extent);
        site.growth.areas.push_back(std::max(area, site.growth.areas.back()));
        if (area >= largest) break;
    }
    return site.growth.areas.back() > 0.0;
}

}  // namespace lapfx::match
