// Heat under the tool, the paper's radial model ("the amount of heat and its effects on the nearby tissue is
// proportional to the duration of the application of the cautery ... the region affected by the heat is expanded
// radially"), in closed form for any time. Formulas: effects/cautery/parameters.cpp. Contacts are added and removed at
// the end, at a cost that depends on what they touch. One thread at a time.
//
// Stations are places of the tips' paths, each the middle of a bell of heat. Every contact heats all stations near its
// path, whoever has brought them there, so that the heat of several tools adds.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cautery/grid.h"
#include "cautery/heat_sum.h"
#include "cautery/track.h"
#include "cautery/wound_list.h"

namespace lapfx::cautery {

/// How hot a place is: height and radius of the bell of heat around it.
struct Bell {
    glm::dvec3 position{0.0};
    double rise = 0.0;     ///< degrees above the body, not bounded by the highest that can be read
    double radius = 0.0;   ///< mm
    bool divided = false;  ///< the heat has opened the tissue here
    double at(const glm::dvec3& place) const {
        const double r = glm::distance(position, place) / radius;
        return rise * std::exp(-r * r);
    }
};

class Radial {
  public:
    Radial(const StrengthAt& strength_at, SealedAt sealed_at)
        : strength_at_(strength_at), wounds_(std::move(sealed_at)) {}

    /// Starts again with these parameters.
    void reset(const CauteryParameters& parameters);
    /// Forgets the contacts from `count` on, but not their wounds.
    void truncate(std::size_t count);
    /// Adds contact number `number` of the track, the next one, without its wounds.
    void append(const Track& track, std::uint32_t number);
    /// Opens and closes wounds, after contacts have changed. What they did before `from` is as it was.
    void resolve(const Track& track, double from);

    /// Degrees Celsius of the surface at `place`.
    double temperature(const glm::dvec3& place, double time) const;
    /// The hottest bells that contact `number` has made by `time`, replacing the contents of `out`. They only grow with
    /// time.
    void bells(const Track& track, std::uint32_t number, double time, std::vector<Bell>& out) const;

    const WoundList& wounds() const { return wounds_; }
    void seal_wounds() { wounds_.seal(); }  ///< call it after a change of the clips
    /// Stations, heatings, sites and wounds that were looked at so far: the cost, as a count.
    std::uint64_t work() const { return work_; }

  private:
    static constexpr std::uint32_t none = 0xffffffff;

    /// A contact heats a station, or an earlier one has heated it and goes on.
    struct Heating {
        std::uint32_t station = 0;
        double from = 0.0, to = 0.0;  ///< s, while the tip is near and the station is known
    };
    struct Station {
        Place place;
        double known_from = 0.0;  ///< s, when the contact begins that brought it
        HeatSum heat;
        std::vector<std::uint32_t> sites;
    };
    /// Where a wound opens when its stroke's heat divides the tissue.
    struct Site {
        Place place;
        std::uint32_t station = 0, chain = 0, owner = 0;
        double strength = 0.0;
    };
    struct Contact {
        std::vector<Heating> heatings;
        std::vector<std::uint32_t> lent;  ///< earlier contacts that heat stations of this one
        std::uint32_t first_station = 0, first_site = 0;
    };
    /// What may yet happen to a wound.
    struct Event {
        double time;
        bool opens;
        std::uint32_t contact;  ///< that does it
        std::uint32_t number;   ///< of the wound, or in openings_
    };

    double radius(double stayed) const;
    std::uint32_t station_at(const Track& track, const Place& place, std::uint32_t number);
    void heat_before(const Track& track, std::uint32_t station, std::uint32_t number);
    std::optional<HeatSum::Source> source_at(const Track& track, std::uint32_t contact, const glm::dvec3& place);
    void heat(Station& station, std::span<const HeatSum::Source> sources);
    Heating heating_by(std::uint32_t station, const HeatSum::Source& source) const;
    void stations_along(const ToolContact& contact, std::vector<std::uint32_t>& out);
    double divided(const Stay& stay, const Heating& heating, double to) const;
    void find_openings(const Track& track, std::uint32_t number, double from);
    void find_closings(const Track& track, std::uint32_t number, double from);
    void find_closing(const Track& track, std::uint32_t number, const Heating& heating, std::uint32_t wound,
                      double from);
    double closing_time(const Station& station, const Wound& wound, double from, double to) const;
    bool opened_before(const Track& track, const Site& site, std::uint32_t number);
    bool happens_before(const Event& a, const Event& b) const;
    void push(const Event& event);
    void happen(const Track& track, const Event& event);

    const StrengthAt& strength_at_;
    CauteryParameters parameters_;
    HeatSum::Constants constants_;
    std::vector<Station> stations_;
    std::vector<Site> sites_;
    std::vector<Contact> contacts_;
    Grid grid_{3.0};       // stations
    double widest_ = 0.0;  // largest radius of any bell so far, mm
    WoundList wounds_;
    std::vector<double> happened_;  // times of the events, which are their keys in the list
    // While wounds are resolved: a heap of events, the openings among them, and the contacts that run.
    std::vector<Event> events_;
    std::vector<Division> openings_;
    std::vector<std::uint32_t> running_;
    std::vector<std::uint32_t> found_, along_, near_wounds_;
    mutable std::uint64_t work_ = 0;  // bells() counts, too
};

}  // namespace lapfx::cautery
