// Wounds of the radial model: events in the order of time, each a wound that opens or closes.
#include <algorithm>

#include "cautery/radial.h"

namespace lapfx::cautery {

/// When a contact's heat, with that of others, divides a station by `to`; never.
double Radial::divided(const Stay& stay, const Heating& heating, double to) const {
    const double wanted = parameters_.cut_temperature - body_temperature;
    if (!divides(stay.contact.action) || wanted > highest_rise(parameters_)) return never;
    return stations_[heating.station].heat.reaches(wanted, heating.from, to, constants_);
}

void Radial::resolve(const Track& track, double from) {
    const auto kept = std::lower_bound(happened_.begin(), happened_.end(), from);
    wounds_.truncate(kept - happened_.begin());
    happened_.erase(kept, happened_.end());
    events_.clear();
    openings_.clear();
    running_.clear();
    const auto stays = track.stays();
    for (std::size_t i = stays.size(); i-- > 0 && stays[i].latest_end >= from;) {
        ++work_;
        if (stays[i].contact.end() >= from) running_.push_back(static_cast<std::uint32_t>(i));
    }
    std::reverse(running_.begin(), running_.end());
    for (const std::uint32_t number : running_) find_openings(track, number, from);
    for (const std::uint32_t number : running_) find_closings(track, number, from);
    const auto later = [this](const Event& a, const Event& b) { return happens_before(b, a); };
    while (!events_.empty()) {
        std::pop_heap(events_.begin(), events_.end(), later);
        const Event event = events_.back();
        events_.pop_back();
        happen(track, event);
    }
}

/// At one time what closes comes first, so that a wound that is closed does not count for one that opens.
bool Radial::happens_before(const Event& a, const Event& b) const {
    if (a.time != b.time) return a.time < b.time;
    if (a.opens != b.opens) return b.opens;
    if (a.opens) return opens_before(openings_[a.number], openings_[b.number]);
    return std::pair(a.number, a.contact) < std::pair(b.number, b.contact);
}

void Radial::push(const Event& event) {
    events_.push_back(event);
    std::push_heap(events_.begin(), events_.end(),
                   [this](const Event& a, const Event& b) { return happens_before(b, a); });
}

void Radial::find_openings(const Track& track, std::uint32_t number, double from) {
    const Stay& stay = track.stays()[number];
    const auto open = [&](const Wound& wound) {
        if (wound.start < from) return;
        openings_.push_back({.wound = wound, .tip = stay.contact.tip(wound.start), .by_heat = stay.contact.hot()});
        push({.time = wound.start,
              .opens = true,
              .contact = number,
              .number = static_cast<std::uint32_t>(openings_.size() - 1)});
    };
    if (cold(stay.contact.action))
        for (const Place& place : track.places_of(stay))
            if (place.wound)
                open({.position = place.point.position,
                      .start = place.arrival,
                      .strength = wound_strength(stay.contact, place.point.position, strength_at_)});
    if (!stay.contact.hot() || !divides(stay.contact.action)) return;
    for (const Heating& heating : contacts_[number].heatings) {
        ++work_;
        if (heating.to < from || stations_[heating.station].sites.empty()) continue;
        const double start = divided(stay, heating, heating.to);
        if (start == never) continue;
        for (const std::uint32_t s : stations_[heating.station].sites) {
            ++work_;
            const Site& site = sites_[s];
            if (site.chain == stay.chain && !opened_before(track, site, number))
                open({.position = site.place.point.position,
                      .start = std::max(start, site.place.arrival),
                      .strength = site.strength});
        }
    }
}

/// Whether an earlier contact of the site's stroke has divided its place already.
bool Radial::opened_before(const Track& track, const Site& site, std::uint32_t number) {
    const Station& station = stations_[site.station];
    for (const HeatSum::Source& source : station.heat.sources()) {
        ++work_;
        if (source.contact >= number) break;
        if (track.stays()[source.contact].chain != site.chain) continue;
        const Heating heating = heating_by(site.station, source);
        if (heating.to > heating.from && divided(track.stays()[source.contact], heating, heating.to) < never)
            return true;
    }
    return false;
}

void Radial::find_closings(const Track& track, std::uint32_t number, double from) {
    const Stay& stay = track.stays()[number];
    if (!stay.contact.hot()) return;
    for (const Heating& heating : contacts_[number].heatings) {
        ++work_;
        if (heating.to < from) continue;
        const Station& station = stations_[heating.station];
        const glm::dvec3 reach(radius(station.heat.at(heating.to, constants_).stayed) + wound_spacing);
        const glm::dvec3 place = station.place.point.position;
        wounds_.find(place - reach, place + reach, near_wounds_);
        for (const std::uint32_t wound : near_wounds_) find_closing(track, number, heating, wound, from);
    }
}

void Radial::find_closing(const Track& track, std::uint32_t number, const Heating& heating, std::uint32_t wound,
                          double from) {
    ++work_;
    const Wound& w = wounds_.wounds()[wound];
    if (wounds_.is_closed(wound) ||
        track.has_divided(track.stays()[number], wounds_.burn_of(wound), parameters_.tip_radius))
        return;
    const double time =
        closing_time(stations_[heating.station], w, std::max({heating.from, from, w.start}), heating.to);
    if (time < never) push({.time = time, .opens = false, .contact = number, .number = wound});
}

/// The first time within from..to at which the station's heat closes a wound: it is warm enough, the heated region has
/// reached the wound, and the wound is not where tissue is being divided.
double Radial::closing_time(const Station& station, const Wound& wound, double from, double to) const {
    const double warm = parameters_.coagulation_temperature - body_temperature;
    // A little less, so that rounding does not close what opens at this temperature.
    const double hot = parameters_.cut_temperature - body_temperature - 1e-6;
    if (warm > highest_rise(parameters_)) return never;
    const double distance = glm::distance(station.place.point.position, wound.position);
    const bool under_tip = distance <= parameters_.tip_radius && hot <= highest_rise(parameters_);
    const auto& parts = station.heat.parts();
    for (std::size_t i = station.heat.part_at(from); i < parts.size() && parts[i].from <= to; ++i) {
        const HeatSum::HeatPiece part =
            parts[i].between(std::max(from, parts[i].from), std::min(to, parts[i].to), constants_);
        double time = part.when(warm, false, constants_);
        if (under_tip && time < never && part.at(time, constants_).rise >= hot)
            time = part.when(hot - 1e-6, true, constants_);
        if (time == never) continue;
        const double growth = distance - wound_spacing, spread = parameters_.heat_spread;
        if (growth > radius(part.at(time, constants_).stayed)) {
            const double stayed =
                (growth * growth - parameters_.tip_radius * parameters_.tip_radius) / (spread * spread);
            time = part.from + (stayed - part.start.stayed);  // infinite without spread
            if (!(time <= part.to) || part.at(time, constants_).rise < warm ||
                (under_tip && part.at(time, constants_).rise >= hot))
                continue;
        }
        return time;
    }
    return never;
}

void Radial::happen(const Track& track, const Event& event) {
    const auto key = static_cast<std::int64_t>(happened_.size());
    std::uint32_t wound = none;
    if (!event.opens) {
        if (track.has_divided(track.stays()[event.contact], wounds_.burn_of(event.number), parameters_.tip_radius) ||
            !wounds_.close(event.number, event.time, key))
            return;
    } else if (wounds_.add(openings_[event.number], key)) {
        wound = static_cast<std::uint32_t>(wounds_.wounds().size() - 1);
    } else {
        wound = wounds_.stands_for();
    }
    happened_.push_back(event.time);
    if (wound == none) return;
    // It is new, or another tool's now: who of those that still come near closes it?
    const glm::dvec3 place = wounds_.wounds()[wound].position, reach(widest_ + wound_spacing + farthest_touch);
    grid_.find(place - reach, place + reach, found_);
    for (const std::uint32_t s : found_) {
        const Station& station = stations_[s];
        ++work_;
        if (glm::distance(station.place.point.position, place) > widest_ + wound_spacing) continue;
        for (const HeatSum::Source& source : station.heat.sources()) {
            ++work_;
            if (source.to < event.time || source.to <= station.known_from) continue;
            find_closing(track, source.contact, heating_by(s, source), wound, event.time);
        }
    }
}

}  // namespace lapfx::cautery
