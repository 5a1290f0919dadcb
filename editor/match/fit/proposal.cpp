#include "match/fit/proposal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

#include "lapfx/authoring/strokes.h"
#include "lapfx/prepared_organ.h"
#include "match/emission.h"
#include "match/fit/core_amounts.h"
#include "match/fit/seen_places.h"
#include "match/view_share.h"
#include "match/wounds.h"

namespace lapfx::match {

namespace {

constexpr double most_veil = 0.95;       // denser says nothing about depth
constexpr double apart = 15.0;           // mm between places of tools: no heat reaches another
constexpr double least_emission = 0.05;  // of the core

std::string text_of(const char* format, double a, double b = 0.0) {
    char text[160];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

/// Numbers of the contacts of each stroke that is hot, in the order of time.
std::vector<std::vector<std::size_t>> hot_strokes(std::span<const ToolContact> events) {
    std::vector<std::size_t> order(events.size()), stroke_of(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return events[a].time < events[b].time; });
    std::vector<std::vector<std::size_t>> strokes;
    std::vector<char> continued(order.size(), 0);
    for (std::size_t n = 0; n < order.size(); ++n) {
        if (!events[order[n]].hot()) continue;
        const auto before = goes_on_from(
            n, [&](std::size_t i) -> const ToolContact& { return events[order[i]]; },
            [&](std::size_t i) { return continued[i] != 0; });
        stroke_of[n] = before ? stroke_of[*before] : strokes.size();
        if (before)
            continued[*before] = 1;
        else
            strokes.emplace_back();
        strokes[stroke_of[n]].push_back(order[n]);
    }
    return strokes;
}

/// The whole stroke, squeezed or stretched.
void retime(std::vector<ToolContact>& events, const std::vector<std::size_t>& stroke, double start, double end) {
    const double from = events[stroke.front()].time;
    double until = from;
    for (const std::size_t i : stroke) until = std::max(until, events[i].end());
    const double ratio = until > from ? (end - start) / (until - from) : 1.0;
    for (const std::size_t i : stroke) {
        ToolContact& contact = events[i];
        contact.time = start + ratio * (contact.time - from);
        contact.duration = until > from ? ratio * contact.duration : end - start;
        contact.power = 1.0, contact.strength = 0.0;
    }
}

class Proposing {
  public:
    Proposing(const Tuned& start, const std::shared_ptr<const PreparedOrgan>& organ,
              std::span<const TargetPoint> target, const ProposalOptions& options)
        : start_(start), organ_(organ), target_(target), options_(options), proposal_{.tuned = start} {}

    Proposal run() {
        propose_smoke();
        propose_blood();
        return std::move(proposal_);
    }

  private:
    void say(std::string line) { proposal_.lines.push_back(std::move(line)); }
    template <class Value>
    void set(const char* key, Value value) {
        free_parameters(proposal_.tuned, std::vector<std::string>{key}).front().set(proposal_.tuned, value);
    }
    std::vector<glm::dvec3> taken() const {
        std::vector<glm::dvec3> places;
        for (const ToolContact& event : proposal_.tuned.scene.events) {
            places.push_back(event.position);
            places.push_back(event.to);
        }
        return places;
    }
    std::vector<SeenPlace> free_places() const {
        return seen_places(organ_->organ(), start_.scene.camera, options_.aspect, apart, taken());
    }

    std::vector<HazePoint> haze_points() const {
        std::vector<HazePoint> points;
        for (const TargetPoint& aim : target_) {
            if (!aim.veil) continue;
            const double veil = std::clamp(aim.veil->value, 0.0, most_veil);
            points.push_back({aim.time, -std::log1p(-veil), course_error(*aim.veil, veil_course) / (1.0 - veil)});
        }
        return points;
    }
    void propose_smoke() {
        const std::vector<HazePoint> points = haze_points();
        if (points.size() < 2) return say("veil: not measurable, smoke stays as it is");
        const HazeParameters& haze = start_.preset.smoke.haze;
        const SmokeFound found = smoke_above_offset(points, haze.ventilation);
        proposal_.veil_offset = found.offset;
        if (options_.moves_events) move_hot(found);
        if (found.bursts.empty()) return say("veil: no smoke beyond the error of measuring");
        for (const Burst& burst : found.bursts) say(text_of("smoke: from %.1f s to %.1f s", burst.start, burst.end));
        if (found.falls)
            set("smoke.haze.ventilation", found.ventilation);
        else
            say("smoke.haze.ventilation: not determined, the veil never falls; 4 s of clearing would tell it");
        if (options_.moves_events) proposal_.tuned.scene.curves.emission = found.emission;
        set_accumulation(points, found);
    }
    void move_hot(const SmokeFound& found) {
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        const std::vector<std::vector<std::size_t>> strokes = hot_strokes(events);
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            if (i < found.bursts.size())
                retime(events, strokes[i], std::max(found.bursts[i].start, 0.0), found.bursts[i].end);
            else
                for (const std::size_t k : strokes[i]) events[k].power = events[k].strength = 0.0;
        }
        if (found.bursts.size() <= strokes.size()) return;
        const std::vector<SeenPlace> places = free_places();
        if (places.empty()) return say("smoke: no place for another tool is seen");
        for (std::size_t i = strokes.size(); i < found.bursts.size(); ++i) {
            const glm::dvec3 at = places[(i - strokes.size()) % places.size()].position;
            events.push_back({.action = ToolAction::coagulate,
                              .time = std::max(found.bursts[i].start, 0.0),
                              .duration = found.bursts[i].end - std::max(found.bursts[i].start, 0.0),
                              .position = at,
                              .to = at,
                              .power = 1.0,
                              .strength = 0.0});
        }
    }
    /// So that the core's own haze, of tools that burn more or less fat, is that of the reference.
    void set_accumulation(std::span<const HazePoint> points, const SmokeFound& found) {
        set("smoke.haze.accumulation", found.accumulation);
        std::vector<double> times;
        for (const HazePoint& point : points) times.push_back(point.time);
        double both = 0.0, core2 = 0.0, emission = 0.0;
        const std::vector<Amounts> amounts = CoreAmounts(organ_).at(proposal_.tuned, times);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double weight = 1.0 / (points[i].error * points[i].error);
            both += weight * std::max(points[i].density - found.offset, 0.0) * amounts[i].haze;
            core2 += weight * amounts[i].haze * amounts[i].haze;
            emission = std::max(emission, amounts[i].emission);
        }
        if (emission < least_emission) return say("smoke: no tool of the scene smokes then; events have to move first");
        if (core2 > 0.0) set("smoke.haze.accumulation", found.accumulation * both / core2);
        say(text_of("smoke.haze.accumulation: %.3f 1/s; only its product with the density of smoke is in the video",
                    proposal_.tuned.preset.smoke.haze.accumulation));
    }

    std::vector<BloodPoint> blood_points() const {
        std::vector<BloodPoint> points;
        for (const TargetPoint& aim : target_)
            if (aim.blood) points.push_back({aim.time, aim.blood->value, course_error(*aim.blood, blood_course)});
        return points;
    }
    void propose_blood() {
        const std::vector<BloodPoint> points = blood_points();
        if (points.size() < 2) return say("blood: not measurable, it stays as it is");
        // A hot stroke keeps the time of its smoke: for the wounds it does not divide.
        Scene scene = proposal_.tuned.scene;
        if (options_.moves_events)
            for (ToolContact& event : scene.events)
                if (event.hot()) event.action = ToolAction::coagulate;
        const std::vector<SeenPlace> places = free_places();
        std::vector<glm::dvec3> elsewhere;
        if (options_.moves_events)
            for (const SeenPlace& place : places) elsewhere.push_back(place.position);
        const std::optional<double> share = share_per_mm2_of(scene, places);
        if (!share) return say("blood: no place of the organ is seen, it stays as it is");
        const WoundsFound found = wounds_of(points, {.scene = scene,
                                                     .preset = proposal_.tuned.preset,
                                                     .organ = organ_,
                                                     .share_per_mm2 = *share,
                                                     .elsewhere = elsewhere,
                                                     .error_lasts = 1.0});
        if (options_.moves_events) take_events(found);
        if (found.wounds.empty()) return say("blood: none beyond the error of measuring");
        tell(found);
    }
    void take_events(const WoundsFound& found) {
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        for (std::size_t i = 0; i < found.events.size(); ++i) {
            if (i >= events.size())
                events.push_back(found.events[i]);
            else if (events[i].hot())
                events[i].strength = 0.0;
            else
                events[i] = found.events[i];
        }
    }
    /// Where a wound is or will be.
    std::optional<double> share_per_mm2_of(const Scene& scene, const std::vector<SeenPlace>& places) const {
        std::optional<double> nearest;
        double distance = 0.0;
        const Organ& organ = organ_->organ();
        for (const ToolContact& event : scene.events) {
            if (!divides(event.action)) continue;
            for (std::size_t i = 0; i < organ.positions.size(); ++i) {
                const double here = glm::distance(glm::dvec3(organ.positions[i]), event.position);
                if (nearest && here >= distance) continue;
                distance = here;
                nearest = share_per_mm2(scene.camera, options_.aspect, event.position, glm::dvec3(organ.normals[i]));
            }
            if (nearest && *nearest > 0.0) return nearest;
            nearest.reset();
        }
        if (places.empty()) return {};
        return share_per_mm2(scene.camera, options_.aspect, places.front().position, places.front().normal);
    }
    void tell(const WoundsFound& found) {
        for (const WoundFound& wound : found.wounds)
            say(text_of(wound.start_is_known ? "blood: from %.1f s, strength %.2f"
                                             : "blood: about from %.1f s, which is not determined; strength %.2f",
                        wound.start, wound.strength));
        if (found.speed_is_known)
            set("bleeding.speed", found.speed);
        else
            say("bleeding.speed: not determined, the blood grows too little or too unevenly");
        set("bleeding.max_extent", found.max_extent);
        if (!found.max_extent_is_known)
            say(text_of("bleeding.max_extent: not determined, but not below %.0f mm; blood still spreads at the end",
                        found.at_least));
    }

    const Tuned& start_;
    const std::shared_ptr<const PreparedOrgan>& organ_;
    std::span<const TargetPoint> target_;
    const ProposalOptions& options_;
    Proposal proposal_;
};

}  // namespace

Proposal propose(const Tuned& start, const std::shared_ptr<const PreparedOrgan>& organ,
                 std::span<const TargetPoint> target, const ProposalOptions& options) {
    return Proposing(start, organ, target, options).run();
}

}  // namespace lapfx::match
