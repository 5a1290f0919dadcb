#include "cautery/radial.h"

#include <algorithm>

namespace lapfx::cautery {

namespace {

/// Beyond so many radii a bell of 800 degrees is below 0.1 degrees.
constexpr double bell_reach = 3.0;
/// A place of a path uses a station that is closer than this share of the distance between places.
constexpr double same_station = 0.25;

/// Of a place from the line that the tip moves along, or from a tip that rests. Not from the ends of the path: a place
/// is heated alike however its stroke is cut into pieces.
double distance_to_line(const ToolContact& contact, const glm::dvec3& place) {
    const glm::dvec3 path = contact.to - contact.position, offset = place - contact.position;
    const double length = glm::length(path);
    return length > 1e-6 ? glm::length(glm::cross(path, offset)) / length : glm::length(offset);
}

}  // namespace

void Radial::reset(const CauteryParameters& parameters) {
    truncate(0);
    widest_ = 0.0;
    wounds_.truncate(0);
    happened_.clear();
    parameters_ = parameters;
    constants_ = {.cooling_time = parameters.cooling_time, .gentle_top = gentle_rise(parameters)};
}

double Radial::radius(double stayed) const {
    const double spread = parameters_.heat_spread;
    return std::sqrt(parameters_.tip_radius * parameters_.tip_radius + spread * spread * stayed);
}

void Radial::append(const Track& track, std::uint32_t number) {
    const Stay& stay = track.stays()[number];
    contacts_.push_back({.heatings = {},
                         .lent = {},
                         .first_station = static_cast<std::uint32_t>(stations_.size()),
                         .first_site = static_cast<std::uint32_t>(sites_.size())});
    if (!stay.contact.hot()) return;
    for (const Place& place : track.places_of(stay)) {
        const std::uint32_t s = station_at(track, place, number);
        if (!place.wound || !divides(stay.contact.action)) continue;
        stations_[s].sites.push_back(static_cast<std::uint32_t>(sites_.size()));
        sites_.push_back({.place = place,
                          .station = s,
                          .chain = stay.chain,
                          .owner = number,
                          .strength = wound_strength(stay.contact, place.point.position, strength_at_)});
    }
    stations_along(stay.contact, along_);
    for (const std::uint32_t s : along_)
        if (const auto source = source_at(track, number, stations_[s].place.tip)) {
            heat(stations_[s], {&*source, 1});
            contacts_.back().heatings.push_back({.station = s, .from = source->from, .to = source->to});
        }
}

/// The station at a place: an existing one, or a new one.
std::uint32_t Radial::station_at(const Track& track, const Place& place, std::uint32_t number) {
    const glm::dvec3 reach(same_station * track.spacing());
    grid_.find(place.tip - reach, place.tip + reach, found_);
    work_ += found_.size();
    std::uint32_t best = none;
    double nearest = same_station * track.spacing();
    for (const std::uint32_t s : found_) {
        const double distance = glm::distance(stations_[s].place.tip, place.tip);
        if (distance < nearest) {
            nearest = distance;
            best = s;
        }
    }
    if (best != none) return best;
    best = static_cast<std::uint32_t>(stations_.size());
    stations_.push_back({.place = place, .known_from = track.stays()[number].contact.time, .heat = {}, .sites = {}});
    heat_before(track, best, number);
    grid_.insert(best, place.tip, place.tip);
    return best;
}

/// Gives a new station of contact `number` the heat of those before.
void Radial::heat_before(const Track& track, std::uint32_t s, std::uint32_t number) {
    Station& station = stations_[s];
    // Contacts that came near have heated another station near it.
    std::vector<std::uint32_t> before;
    const glm::dvec3 reach(parameters_.tip_radius + 2.0 * track.spacing());
    grid_.find(station.place.tip - reach, station.place.tip + reach, found_);
    for (const std::uint32_t other : found_)
        for (const HeatSum::Source& source : stations_[other].heat.sources()) {
            ++work_;
            if (source.contact < number) before.push_back(source.contact);
        }
    std::sort(before.begin(), before.end());
    before.erase(std::unique(before.begin(), before.end()), before.end());
    std::vector<HeatSum::Source> sources;
    for (const std::uint32_t contact : before) {
        const auto source = source_at(track, contact, station.place.tip);
        if (!source) continue;
        sources.push_back(*source);
        if (!(source->to > station.known_from)) continue;
        contacts_[contact].heatings.push_back(heating_by(s, *source));
        contacts_.back().lent.push_back(contact);
    }
    heat(station, sources);
}

/// The heat that a contact gives to a place, if it comes near.
std::optional<HeatSum::Source> Radial::source_at(const Track& track, std::uint32_t number, const glm::dvec3& place) {
    const ToolContact& contact = track.stays()[number].contact;
    ++work_;
    const auto near = passes(contact, place, parameters_.tip_radius);
    if (!near || !(near->to > near->from)) return std::nullopt;
    const double r = distance_to_line(contact, place) / parameters_.tip_radius;
    const double rate = rise_rate(contact, parameters_) * std::exp(-r * r);
    if (!(rate > 0.0)) return std::nullopt;
    return HeatSum::Source{
        .contact = number, .from = near->from, .to = near->to, .rate = rate, .gentle = row_of(contact.action).gentle};
}

/// The part of a source's time that the station knows of.
Radial::Heating Radial::heating_by(std::uint32_t station, const HeatSum::Source& source) const {
    return {.station = station, .from = std::max(source.from, stations_[station].known_from), .to = source.to};
}

void Radial::heat(Station& station, std::span<const HeatSum::Source> sources) {
    station.heat.add(sources, constants_);
    // H is greatest where a part begins: at the end of a heating. One may be lengthened by a later source.
    for (const HeatSum::HeatPiece& part : station.heat.parts()) widest_ = std::max(widest_, radius(part.start.stayed));
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

void Radial::truncate(std::size_t count) {
    while (contacts_.size() > count) {
        const auto number = static_cast<std::uint32_t>(contacts_.size() - 1);
        const Contact& contact = contacts_.back();
        for (const std::uint32_t lender : contact.lent) {
            auto& heatings = contacts_[lender].heatings;
            while (!heatings.empty() && heatings.back().station >= contact.first_station) heatings.pop_back();
        }
        for (const Heating& heating : contact.heatings) {
            if (heating.station >= contact.first_station) continue;
            stations_[heating.station].heat.remove_from(number, constants_);
            work_ += stations_[heating.station].heat.sources().size();
        }
        for (; sites_.size() > contact.first_site; sites_.pop_back()) stations_[sites_.back().station].sites.pop_back();
        while (stations_.size() > contact.first_station) {
            const glm::dvec3 place = stations_.back().place.tip;
            stations_.pop_back();
            grid_.remove(static_cast<std::uint32_t>(stations_.size()), place, place);
        }
        contacts_.pop_back();
    }
}

double Radial::temperature(const glm::dvec3& place, double time) const {
    const glm::dvec3 reach(bell_reach * widest_);
    std::vector<std::uint32_t> near;
    grid_.find(place - reach, place + reach, near);
    double rise = 0.0;
    for (const std::uint32_t s : near) {
        const Station& station = stations_[s];
        if (station.known_from > time) continue;
        const HeatSum::State state = station.heat.at(time, constants_);
        const Bell bell{.position = station.place.point.position, .rise = state.rise, .radius = radius(state.stayed)};
        rise = std::max(rise, bell.at(place));
    }
    return body_temperature + std::min(rise, highest_rise(parameters_));
}

void Radial::bells(const Track& track, std::uint32_t number, double time, std::vector<Bell>& out) const {
    out.clear();
    const Stay& stay = track.stays()[number];
    for (const Heating& heating : contacts_[number].heatings) {
        if (heating.from > time) continue;
        const Station& station = stations_[heating.station];
        const double to = std::min(time, heating.to);
        const bool opened = divided(stay, heating, to) <= to;
        const std::size_t first = out.size();
        const auto add = [&](double t) {
            ++work_;
            const HeatSum::State state = station.heat.at(t, constants_);
            const Bell bell{.position = station.place.point.position,
                            .rise = state.rise,
                            .radius = radius(state.stayed),
                            .divided = opened};
            // It grows as long as it is heated: the later one mostly covers the earlier.
            if (out.size() > first && out.back().rise <= bell.rise && out.back().radius <= bell.radius) out.pop_back();
            out.push_back(bell);
        };
        add(heating.from);
        const auto& parts = station.heat.parts();
        for (std::size_t i = station.heat.part_at(heating.from) + 1; i < parts.size() && parts[i].from < to; ++i)
            add(parts[i].from);
        if (to > heating.from) add(to);
    }
}

}  // namespace lapfx::cautery
