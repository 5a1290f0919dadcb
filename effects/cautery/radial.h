// Heat under the tool, the paper's radial model ("the amount of heat and its effects on the nearby tissue is
// proportional to the duration of the application of the cautery ... the region affected by the heat is expanded
// radially"), in closed form for any time. Formulas: effects/cautery/parameters.cpp. Contacts are added and removed at
// the end, at a cost that depends on what they touch. One thread at a time.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "cautery/grid.h"
#include "cautery/track.h"
#include "cautery/wound_list.h"

namespace lapfx::cautery {

/// How hot a place is: height and radius of the bell of heat around it.
struct Bell {
    glm::dvec3 position{0.0};
    double rise = 0.0;     ///< degrees above the body, bounded
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

    /// Forgets the contacts from `count` on. New parameters need truncate(0).
    void truncate(std::size_t count);
    void set_parameters(const CauteryParameters& parameters) { parameters_ = parameters; }
    /// Adds contact number `number` of the track, the next one; hot ones heat, cold ones only open wounds.
    void append(const Track& track, std::uint32_t number);

    /// Degrees Celsius of the surface at `place`.
    double temperature(const glm::dvec3& place, double time) const;
    /// The hottest bells that contact `number` has made by `time`, replacing the contents of `out`. They only grow with
    /// time.
    void bells(std::uint32_t number, double time, std::vector<Bell>& out) const;

    const WoundList& wounds() const { return wounds_; }
    /// Stations, heatings, sites and wounds that were looked at so far: the cost, as a count.
    std::uint64_t work() const { return work_; }

  private:
    static constexpr std::uint32_t none = 0xffffffff;

    /// One contact of a chain heats one place of that chain.
    struct Heating {
        std::uint32_t contact = 0;
        std::uint32_t owner = 0;      // the contact that added it; the place may belong to a later one
        double visible = 0.0;         // s, when the owner begins
        double from = 0.0, to = 0.0;  // when the tip is near
        double rate = 0.0;            // degrees per second
        double top = 0.0;             // degrees, the highest rise that it makes
        bool cuts = false;
        double start = 0.0, finish = 0.0;  // the same without the part that an earlier contact heats
        double rise = 0.0, stayed = 0.0;   // U and H at the start
        double opened = never;             // when U passes the cut temperature
    };
    /// A place of one or more chains and what has heated it.
    struct Station {
        Place place;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> chains;  // chain and the contact that brought it here
        std::vector<Heating> heatings;                                // by their start
        std::vector<std::uint32_t> sites;
    };
    /// Where a wound opens when its chain's heat divides the tissue.
    struct Site {
        Place place;
        std::uint32_t chain = 0, owner = 0;
        double strength = 0.0;
        std::uint32_t opened_by = none;
    };
    struct Contact {
        std::vector<std::uint32_t> stations;  // stations where it has heated, ascending
        std::uint32_t first_station = 0, first_site = 0;
        double chain_start = 0.0;  // none of its heatings is earlier
    };
    struct State {
        double rise, stayed;
    };
    struct Closing {
        double time;
        std::uint32_t wound;
    };

    State state_at(const Heating& heating, double time) const;
    double radius(double stayed) const;
    double spread(const Heating& heating) const { return radius(state_at(heating, heating.finish).stayed); }
    std::uint32_t station_at(const Place& place, double spacing);
    void join(const Track& track, std::uint32_t station, std::uint32_t number);
    void stations_along(const ToolContact& contact, std::vector<std::uint32_t>& out);
    void heat(Station& station, const Track& track, std::uint32_t contact, std::uint32_t owner);
    void settle(Station& station, std::size_t from);
    void open_hot(const Track& track, std::uint32_t number);
    void open_cold(const Track& track, std::uint32_t number);
    void find_closings(const Track& track, std::uint32_t number, std::uint32_t first_wound);
    void record(const Track& track, std::uint32_t number, std::uint32_t heater);
    double closing_time(const Heating& heating, const Wound& wound, double distance) const;

    const StrengthAt& strength_at_;
    CauteryParameters parameters_;
    std::vector<Station> stations_;
    std::vector<Site> sites_;
    std::vector<Contact> contacts_;
    Grid grid_{3.0};       // stations
    double widest_ = 0.0;  // largest radius of any bell so far, mm
    WoundList wounds_;
    std::vector<Wound> opened_;
    std::vector<Closing> closings_;
    std::vector<std::uint32_t> found_, along_, near_wounds_;
    mutable std::uint64_t work_ = 0;  // bells() counts, too
};

}  // namespace lapfx::cautery
