#include "cautery/radial.h"

#include <algorithm>

namespace lapfx::cautery {

namespace {

/// Beyond so many radii a bell of any height that can be read is below 0.1 degrees.
constexpr double bell_reach = 2.9;

/// Seconds until a rise that grows from `rise` at `rate` reaches `wanted`.
double time_to(double wanted, double rise, double rate, double top) {
    if (wanted > top) return never;
    if (rise >= wanted) return 0.0;
    return rate > 0.0 ? (wanted - rise) / rate : never;
}

}  // namespace

double Radial::radius(double stayed) const {
    return parameters_.tip_radius + parameters_.heat_spread * std::sqrt(stayed);
}

Radial::State Radial::state_at(const Heating& h, double time) const {
    const double heated = std::clamp(time - h.start, 0.0, h.finish - h.start);
    State state{std::min(h.rise + h.rate * heated, std::max(h.top, h.rise)), h.stayed + heated};
    if (time > h.finish) {
        const double left = std::exp(-(time - h.finish) / parameters_.cooling_time);
        state.rise *= left;
        state.stayed *= left;
    }
    return state;
}

void Radial::append(const Track& track, std::uint32_t number) {
    const Stay& stay = track.stays()[number];
    contacts_.push_back({.stations = {},
                         .first_station = static_cast<std::uint32_t>(stations_.size()),
                         .first_site = static_cast<std::uint32_t>(sites_.size()),
                         .chain_start = stay.chain_start});
    const auto first_wound = static_cast<std::uint32_t>(wounds_.wounds().size());
    opened_.clear();
    closings_.clear();
    if (!stay.contact.hot()) {
        open_cold(track, number);
    } else {
        for (const Place& place : track.places_of(stay)) {
            const std::uint32_t s = station_at(place, track.spacing());
            join(track, s, number);
            if (!place.wound || !divides(stay.contact.action)) continue;
            stations_[s].sites.push_back(static_cast<std::uint32_t>(sites_.size()));
            sites_.push_back({.place = place,
                              .chain = stay.chain,
                              .owner = number,
                              .strength = wound_strength(stay.contact, place.point.position, strength_at_)});
        }
        stations_along(stay.contact, along_);
        for (const std::uint32_t s : along_) {
            auto& chains = stations_[s].chains;
            const auto of_chain = std::lower_bound(chains.begin(), chains.end(), std::pair(stay.chain, 0u));
            if (of_chain == chains.end() || of_chain->first != stay.chain) continue;
            heat(stations_[s], track, number, number);
            if (contacts_.back().stations.empty() || contacts_.back().stations.back() != s)
                contacts_.back().stations.push_back(s);
        }
        auto& mine = contacts_.back().stations;
        std::sort(mine.begin(), mine.end());
        mine.erase(std::unique(mine.begin(), mine.end()), mine.end());
        open_hot(track, number);
        find_closings(track, number, 0);
    }
    record(track, number, number);
    // An earlier contact that still runs may close a wound that opens now.
    if (first_wound == wounds_.wounds().size()) return;
    const double start = wounds_.wounds()[first_wound].start;
    opened_.clear();
    for (std::uint32_t other = number; other-- > 0 && track.stays()[other].latest_end > start;) {
        ++work_;
        closings_.clear();
        find_closings(track, other, first_wound);
        record(track, number, other);
    }
}

/// The station at a place: an existing one, or a new one.
std::uint32_t Radial::station_at(const Place& place, double spacing) {
    const glm::dvec3 reach(0.5 * spacing);
    grid_.find(place.tip - reach, place.tip + reach, found_);
    work_ += found_.size();
    std::uint32_t best = none;
    double nearest = 0.5 * spacing;
    for (const std::uint32_t s : found_) {
        const double distance = glm::distance(stations_[s].place.tip, place.tip);
        if (distance < nearest) {
            nearest = distance;
            best = s;
        }
    }
    if (best != none) return best;
    best = static_cast<std::uint32_t>(stations_.size());
    stations_.push_back({.place = place, .chains = {}, .heatings = {}, .sites = {}});
    grid_.insert(best, place.tip, place.tip);
    return best;
}

/// Adds a station to the contact's chain, heated by what the chain has done near it so far.
void Radial::join(const Track& track, std::uint32_t s, std::uint32_t number) {
    const std::uint32_t chain = track.stays()[number].chain;
    Station& station = stations_[s];
    auto& chains = station.chains;
    const auto at = std::lower_bound(chains.begin(), chains.end(), std::pair(chain, 0u));
    if (at == chains.end() || at->first != chain) {
        chains.insert(at, {chain, number});
        if (chain != number) {
            // Contacts of the chain that came near: they have heated a station of it that is near.
            std::vector<std::uint32_t> before;
            const glm::dvec3 reach(parameters_.tip_radius + 2.0 * track.spacing());
            grid_.find(station.place.tip - reach, station.place.tip + reach, found_);
            for (const std::uint32_t other : found_)
                for (const Heating& h : stations_[other].heatings) {
                    ++work_;
                    if (h.contact < number && track.stays()[h.contact].chain == chain) before.push_back(h.contact);
                }
            std::sort(before.begin(), before.end());
            before.erase(std::unique(before.begin(), before.end()), before.end());
            for (const std::uint32_t contact : before) heat(station, track, contact, number);
        }
    }
    contacts_.back().stations.push_back(s);
}

/// Stations in the cells along the tip's path, ascending.
void Radial::stations_along(const ToolContact& contact, std::vector<std::uint32_t>& out) {
    const double step = parameters_.tip_radius;
    const int steps = static_cast<int>(glm::distance(contact.position, contact.to) / step) + 1;
    const glm::dvec3 reach(1.5 * step);
    out.clear();
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec3 tip = glm::mix(contact.position, contact.to, static_cast<double>(i) / steps);
        grid_.find(tip - reach, tip + reach, found_);
        out.insert(out.end(), found_.begin(), found_.end());
        work_ += found_.size();
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
}

void Radial::heat(Station& station, const Track& track, std::uint32_t contact, std::uint32_t owner) {
    const Stay& stay = track.stays()[contact];
    const auto near = passes(stay.contact, station.place.tip, parameters_.tip_radius);
    if (!near) return;
    Heating heating{.contact = contact, .owner = owner};
    heating.visible = track.stays()[owner].contact.time;
    heating.from = near->from;
    heating.to = near->to;
    heating.rate = rise_rate(stay.contact, parameters_);
    heating.top = highest_rise(stay.contact, parameters_);
    heating.cuts = divides(stay.contact.action);
    auto& all = station.heatings;
    const auto later = [](double from, const Heating& other) { return from < other.from; };
    const auto at = all.insert(std::upper_bound(all.begin(), all.end(), heating.from, later), heating);
    settle(station, static_cast<std::size_t>(at - all.begin()));
}

void Radial::settle(Station& station, std::size_t from) {
    for (std::size_t i = from; i < station.heatings.size(); ++i) {
        Heating& h = station.heatings[i];
        ++work_;
        h.start = h.from;
        State state{0.0, 0.0};
        if (i > 0) {
            // When two tips heat one place at the same time, only the first one counts.
            const Heating& before = station.heatings[i - 1];
            h.start = std::max(h.from, before.finish);
            state = state_at(before, h.start);
        }
        h.finish = std::max(h.to, h.start);
        h.rise = state.rise;
        h.stayed = state.stayed;
        const double delay =
            time_to(parameters_.cut_temperature - body_temperature, h.rise, h.rate, std::max(h.top, h.rise));
        // A tip that leaves before its turn divides nothing.
        h.opened = h.cuts && h.start <= h.to && h.start + delay <= h.finish ? h.start + delay : never;
        widest_ = std::max(widest_, spread(h));
    }
}

void Radial::open_cold(const Track& track, std::uint32_t number) {
    const Stay& stay = track.stays()[number];
    if (!cold(stay.contact.action)) return;
    for (const Place& place : track.places_of(stay))
        if (place.wound)
            opened_.push_back({.position = place.point.position,
                               .start = place.arrival,
                               .strength = wound_strength(stay.contact, place.point.position, strength_at_)});
}

void Radial::open_hot(const Track& track, std::uint32_t number) {
    const std::uint32_t chain = track.stays()[number].chain;
    for (const std::uint32_t s : contacts_[number].stations) {
        double opened = never;
        for (auto h = stations_[s].heatings.rbegin(); h != stations_[s].heatings.rend(); ++h) {
            ++work_;
            if (h->from < track.stays()[number].chain_start) break;
            if (h->owner == number) opened = std::min(opened, h->opened);
        }
        if (opened == never) continue;
        const auto& sites = stations_[s].sites;
        for (auto i = sites.rbegin(); i != sites.rend() && sites_[*i].owner >= chain; ++i) {
            Site& site = sites_[*i];
            ++work_;
            if (site.chain != chain || site.opened_by != none) continue;
            site.opened_by = number;
            opened_.push_back({.position = site.place.point.position,
                               .start = std::max(opened, site.place.arrival),
                               .strength = site.strength});
        }
    }
    std::stable_sort(opened_.begin(), opened_.end(), [](const Wound& a, const Wound& b) { return a.start < b.start; });
}

/// The events of contact `number` in the order of time; when a place is closed and divided at the same time, it is
/// closed first. `heater` is the contact that closes.
void Radial::record(const Track& track, std::uint32_t number, std::uint32_t heater) {
    std::stable_sort(closings_.begin(), closings_.end(),
                     [](const Closing& a, const Closing& b) { return a.time < b.time; });
    const Stay& stay = track.stays()[number];
    const Stay& hot = track.stays()[heater];
    const Heater closer{.chain = hot.chain, .divides = divides(hot.contact.action)};
    auto closing = closings_.begin();
    const auto close_until = [&](double time) {
        for (; closing != closings_.end() && closing->time <= time; ++closing)
            wounds_.close(closing->wound, closing->time, closer, number);
    };
    for (const Wound& wound : opened_) {
        close_until(wound.start);
        wounds_.add({.wound = wound, .chain = stay.chain, .by_heat = stay.contact.hot()}, number);
    }
    close_until(never);
}

/// When a heating closes a wound at this distance: as soon as the tip's place is warm enough and the heated region has
/// reached the wound. If it has reached the place before another tool cuts there, that cut is closed immediately.
double Radial::closing_time(const Heating& h, const Wound& wound, double distance) const {
    const double warm =
        time_to(parameters_.coagulation_temperature - body_temperature, h.rise, h.rate, std::max(h.top, h.rise));
    const double growth = distance - wound_spacing - parameters_.tip_radius;
    double wide = 0.0;
    if (growth > 0.0) {
        const double root = growth / parameters_.heat_spread;
        wide = root * root - h.stayed;  // infinite without spread
    }
    const double closed = std::max(h.start + std::max({warm, wide, 0.0}), wound.start);
    return closed <= h.finish ? std::max(closed, h.visible) : never;
}

/// Which wounds contact `number` closes, and when, from `first_wound` on.
void Radial::find_closings(const Track& track, std::uint32_t number, std::uint32_t first_wound) {
    const Stay& stay = track.stays()[number];
    if (!stay.contact.hot()) return;
    for (const std::uint32_t s : contacts_[number].stations) {
        const glm::dvec3 place = stations_[s].place.point.position;
        for (auto h = stations_[s].heatings.rbegin(); h != stations_[s].heatings.rend(); ++h) {
            ++work_;
            if (h->from < stay.chain_start) break;
            if (h->owner != number) continue;
            const glm::dvec3 reach(spread(*h) + wound_spacing);
            wounds_.find(place - reach, place + reach, near_wounds_);
            work_ += near_wounds_.size();
            for (const std::uint32_t w : near_wounds_) {
                const Wound& wound = wounds_.wounds()[w];
                if (w < first_wound || wound.stop <= h->start) continue;
                const double closed = closing_time(*h, wound, glm::distance(place, wound.position));
                if (closed < never) closings_.push_back({closed, w});
            }
        }
    }
}

void Radial::truncate(std::size_t count) {
    while (contacts_.size() > count) {
        const auto number = static_cast<std::uint32_t>(contacts_.size() - 1);
        const Contact& contact = contacts_.back();
        for (const std::uint32_t s : contact.stations) {
            Station& station = stations_[s];
            work_ += station.heatings.size() + station.chains.size() + station.sites.size();
            const auto mine = [&](const Heating& h) { return h.owner == number; };
            const auto first = std::find_if(station.heatings.begin(), station.heatings.end(), mine);
            const auto from = static_cast<std::size_t>(first - station.heatings.begin());
            std::erase_if(station.heatings, mine);
            settle(station, from);
            std::erase_if(station.chains, [&](const auto& chain) { return chain.second == number; });
            while (!station.sites.empty() && station.sites.back() >= contact.first_site) station.sites.pop_back();
            for (auto i = station.sites.rbegin(); i != station.sites.rend(); ++i)
                if (sites_[*i].opened_by == number) sites_[*i].opened_by = none;
        }
        sites_.resize(contact.first_site);
        while (stations_.size() > contact.first_station) {
            const glm::dvec3 place = stations_.back().place.tip;
            stations_.pop_back();
            grid_.remove(static_cast<std::uint32_t>(stations_.size()), place, place);
        }
        wounds_.truncate(number);
        contacts_.pop_back();
    }
    if (count == 0) widest_ = 0.0;
}

double Radial::temperature(const glm::dvec3& place, double time) const {
    const glm::dvec3 reach(bell_reach * widest_);
    std::vector<std::uint32_t> near;
    grid_.find(place - reach, place + reach, near);
    double rise = 0.0;
    for (const std::uint32_t s : near)
        for (auto h = stations_[s].heatings.rbegin(); h != stations_[s].heatings.rend(); ++h) {
            if (h->start > time || h->visible > time) continue;
            const State state = state_at(*h, time);
            const Bell bell{
                .position = stations_[s].place.point.position, .rise = state.rise, .radius = radius(state.stayed)};
            rise = std::max(rise, bell.at(place));
            break;
        }
    return body_temperature + rise;
}

void Radial::bells(std::uint32_t number, double time, std::vector<Bell>& out) const {
    out.clear();
    const Contact& contact = contacts_[number];
    for (const std::uint32_t s : contact.stations) {
        const std::size_t first = out.size();
        for (auto h = stations_[s].heatings.rbegin(); h != stations_[s].heatings.rend(); ++h) {
            ++work_;
            if (h->from < contact.chain_start) break;
            if (h->owner != number || h->start > time || h->visible > time) continue;
            const State state = state_at(*h, std::min(time, h->finish));
            const double wide = radius(state.stayed);
            if (out.size() > first && state.rise <= out[first].rise && wide <= out[first].radius) {
                out[first].divided |= h->opened <= time;  // the newest one covers it
                continue;
            }
            out.push_back({.position = stations_[s].place.point.position,
                           .rise = state.rise,
                           .radius = wide,
                           .divided = h->opened <= time});
        }
    }
}

}  // namespace lapfx::cautery
