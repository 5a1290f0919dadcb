#include "match/fit/proposal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>
#include <utility>

#include "lapfx/prepared_organ.h"
#include "match/compare/joined.h"
#include "match/explain/emission.h"
#include "match/explain/strokes.h"
#include "match/explain/wounds.h"
#include "match/fit/reference_offset.h"
#include "match/scene/core_amounts.h"
#include "match/scene/seen_places.h"

namespace lapfx::match {

namespace {

constexpr double most_veil = 0.95;       // denser says nothing about depth
constexpr double apart = 15.0;           // mm between places of tools: no heat reaches another
constexpr double least_emission = 0.05;  // of the core
constexpr double curve_step = 0.25;      // s between times of the scene's own curves
constexpr double lead = 2.0;             // s before the target, at most: smoke that is there at its beginning came then

std::string text_of(const char* format, double a, double b = 0.0) {
    char text[160];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

/// "event 2", or "events 2, 3 and 4", as the editor numbers them.
std::string names_of(const std::vector<std::size_t>& events) {
    std::vector<std::string> numbers;
    for (const std::size_t event : events) numbers.push_back(std::to_string(event + 1));
    return (events.size() == 1 ? "event " : "events ") + joined(numbers);
}

/// The whole stroke, squeezed or stretched, with full power.
void retime(std::vector<ToolContact>& events, const std::vector<std::size_t>& stroke, double start, double end) {
    const double from = events[stroke.front()].time;
    double until = from;
    for (const std::size_t i : stroke) until = std::max(until, events[i].end());
    const double ratio = until > from ? (end - start) / (until - from) : 1.0;
    for (const std::size_t i : stroke) {
        ToolContact& contact = events[i];
        contact.time = start + ratio * (contact.time - from);
        contact.duration = until > from ? ratio * contact.duration : end - start;
        contact.power = 1.0;
    }
}

class Proposing {
  public:
    Proposing(const document::Content& start, const std::shared_ptr<const PreparedOrgan>& organ,
              std::span<const TargetPoint> target, const ProposalOptions& options)
        : start_(start), organ_(organ), target_(target), options_(options), proposal_{.tuned = start} {}

    Proposal run() {
        propose_smoke();
        propose_blood();
        tell_offset();
        return std::move(proposal_);
    }

  private:
    void say(std::string line, About about = About::amounts) { proposal_.lines.push_back({about, std::move(line)}); }
    bool may_set(const std::string& key) const {
        return std::find(options_.keys.begin(), options_.keys.end(), key) != options_.keys.end();
    }
    /// Of a parameter that may be proposed; of others nothing is to be said.
    void say_of(const std::string& key, const std::string& line) {
        if (may_set(key)) say(key + ": " + line);
    }
    void set(const std::string& key, double value) {
        if (!may_set(key)) return;
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

    /// Smoke may come from then on; a scene is clear at time 0.
    double begins() const { return std::max(target_.front().time - lead, 0.0); }
    std::vector<HazePoint> haze_points() const {
        std::vector<HazePoint> points;
        for (const TargetPoint& aim : target_) {
            if (!aim.veil) continue;
            const double veil = std::clamp(aim.veil->value, 0.0, most_veil);
            points.push_back({aim.time, -std::log1p(-veil), course_error(*aim.veil, veil_course) / (1.0 - veil)});
        }
        return points;
    }
    /// By the scene as it was: what is proposed has moved to the reference already.
    void tell_offset() {
        if (target_.size() < 2) return;
        const Courses courses = courses_of(target_);
        std::string line = told_of_offset(target_, courses, curves_of_core());
        if (!line.empty()) say(std::move(line), About::offset);
    }
    /// As an ideal camera sees the start.
    std::vector<FrameAmounts> curves_of_core() const {
        const double from = target_.front().time, to = target_.back().time;
        const std::optional<double> share = seen_share_per_mm2(organ_->organ(), start_.scene, options_.aspect);
        std::vector<double> times;
        for (double time = from; time <= to; time += curve_step) times.push_back(time);
        const std::vector<Amounts> amounts = CoreAmounts(organ_).at(start_, times);
        std::vector<FrameAmounts> frames;
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double blood = share.value_or(0.0) * amounts[i].blood_area, veil = -std::expm1(-amounts[i].haze);
            frames.push_back({.time = times[i], .blood = {blood, blood, blood}, .veil = {veil, veil, veil}});
        }
        return frames;
    }
    void propose_smoke() {
        const std::vector<HazePoint> points = haze_points();
        if (points.size() < 2) return say("veil: not measurable, smoke stays as it is");
        const SmokeFound found = smoke_above_offset(points, start_.preset.smoke.haze.ventilation, begins());
        proposal_.veil_offset = found.offset;
        move_hot(found);
        if (found.bursts.empty()) return say("veil: no smoke beyond the error of measuring");
        for (const Burst& burst : found.bursts)
            say(text_of("smoke: from %.1f s to %.1f s", std::max(burst.start, 0.0), burst.end));
        if (found.falls)
            set("smoke.haze.ventilation", found.ventilation);
        else
            say_of("smoke.haze.ventilation", "not determined, the veil never falls; 4 s of clearing would tell it");
        set_emission(found.emission);
        set_accumulation(points, found);
    }
    /// What the target says nothing about stays as it is.
    bool is_told(const ToolContact& event) const {
        return event.end() >= begins() && event.time <= target_.back().time;
    }
    /// Of the strokes that are told, each burst takes the one that begins nearest; the others are silenced.
    void move_hot(const SmokeFound& found) {
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        std::vector<std::vector<std::size_t>> strokes =
            strokes_of(events, [](const ToolContact& contact) { return contact.hot(); });
        std::erase_if(strokes,
                      [&](const std::vector<std::size_t>& stroke) { return !is_told(events[stroke.front()]); });
        std::vector<Burst> without;
        for (const Burst& burst : found.bursts) {
            const auto nearest = std::min_element(strokes.begin(), strokes.end(), [&](const auto& a, const auto& b) {
                return std::abs(events[a.front()].time - burst.start) < std::abs(events[b.front()].time - burst.start);
            });
            if (nearest == strokes.end()) {
                without.push_back(burst);
                continue;
            }
            retime(events, *nearest, std::max(burst.start, 0.0), burst.end);
            // Wounds are found anew by the blood; where none is seen, what a stroke opens stays.
            if (shows_blood(target_))
                for (const std::size_t k : *nearest) events[k].strength = 0.0;
            strokes.erase(nearest);
        }
        silence(strokes);
        add_hot(without);
    }
    void silence(const std::vector<std::vector<std::size_t>>& strokes) {
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        std::vector<std::size_t> silenced;
        for (const std::vector<std::size_t>& stroke : strokes)
            for (const std::size_t k : stroke) {
                if (events[k].power > 0.0 || events[k].strength > 0.0) silenced.push_back(k);
                events[k].power = events[k].strength = 0.0;
            }
        if (silenced.empty()) return;
        say("tools: " + names_of(silenced) + (silenced.size() == 1 ? " is" : " are") +
                " silenced, power and strength 0: the smoke of the reference is explained without",
            About::tools);
    }
    void add_hot(const std::vector<Burst>& bursts) {
        if (bursts.empty()) return;
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        const std::vector<SeenPlace> places = free_places();
        if (places.empty()) return say("smoke: no place for another tool is seen");
        for (std::size_t i = 0; i < bursts.size(); ++i) {
            const glm::dvec3 at = places[i % places.size()].position;
            events.push_back({.action = ToolAction::coagulate,
                              .time = std::max(bursts[i].start, 0.0),
                              .duration = bursts[i].end - std::max(bursts[i].start, 0.0),
                              .position = at,
                              .to = at,
                              .power = 1.0,
                              .strength = 0.0});
        }
    }
    /// Within the target's time and what leads to it; 1 at both ends, so that what is beyond keeps its smoke.
    void set_emission(std::vector<CurvePoint> found) {
        std::vector<CurvePoint>& curve = proposal_.tuned.scene.curves.emission;
        const double from = begins(), to = target_.back().time;
        std::erase_if(curve, [&](const CurvePoint& point) { return point.time >= from && point.time <= to; });
        if (found.empty()) return;
        if (found.front().time > from) found.insert(found.begin(), {from, 1.0});
        if (found.back().time < to) found.push_back({to, 1.0});
        const auto place = std::find_if(curve.begin(), curve.end(), [&](const CurvePoint& p) { return p.time > to; });
        curve.insert(place, found.begin(), found.end());
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
        say_of("smoke.haze.accumulation",
               text_of("%.3f 1/s; only its product with the density of smoke is in the video",
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
        if (!shows_blood(target_)) return say("blood: no bleeding is seen, it stays as it is");
        // A hot stroke keeps the time of its smoke: for the wounds it does not divide.
        Scene scene = proposal_.tuned.scene;
        for (ToolContact& event : scene.events) {
            if (event.hot()) event.action = ToolAction::coagulate;
            if (divides(event.action) && !is_told(event)) event.action = ToolAction::coagulate, event.power = 0.0;
        }
        const std::vector<SeenPlace> places = free_places();
        std::vector<glm::dvec3> elsewhere;
        for (const SeenPlace& place : places) elsewhere.push_back(place.position);
        const std::optional<double> share = seen_share_per_mm2(organ_->organ(), scene, options_.aspect);
        if (!share) return say("blood: no place of the organ is seen, it stays as it is");
        const WoundsFound found = wounds_of(points, {.scene = scene,
                                                     .preset = proposal_.tuned.preset,
                                                     .organ = organ_,
                                                     .share_per_mm2 = *share,
                                                     .elsewhere = elsewhere,
                                                     .error_lasts = 1.0});
        take_events(found);
        if (found.wounds.empty()) return say("blood: none beyond the error of measuring");
        tell(found);
    }
    void take_events(const WoundsFound& found) {
        std::vector<ToolContact>& events = proposal_.tuned.scene.events;
        for (std::size_t i = 0; i < found.events.size(); ++i) {
            if (i >= events.size())
                events.push_back(found.events[i]);
            else if (is_told(events[i]) && events[i].hot())
                events[i].strength = 0.0;
            else if (is_told(events[i]))
                events[i] = found.events[i];
        }
    }
    void tell(const WoundsFound& found) {
        for (const WoundFound& wound : found.wounds)
            say(text_of(wound.start_is_known ? "blood: from %.1f s, strength %.2f"
                                             : "blood: about from %.1f s, which is not determined; strength %.2f",
                        wound.start, wound.strength));
        if (found.speed_is_known)
            set("bleeding.speed", found.speed);
        else
            say_of("bleeding.speed", "not determined, the blood grows too little or too unevenly");
        set("bleeding.max_extent", found.max_extent);
        if (!found.max_extent_is_known)
            say_of("bleeding.max_extent",
                   text_of("not determined, but not below %.0f mm; blood still spreads at the end", found.at_least));
    }

    const document::Content& start_;
    const std::shared_ptr<const PreparedOrgan>& organ_;
    std::span<const TargetPoint> target_;
    const ProposalOptions& options_;
    Proposal proposal_;
};

/// When what was moved works is known to some tenths of a second: the search is to find it more exactly. Contacts that
/// form a stroke with others stay together as they are.
void free_moved_tools(FitInput& input, const std::vector<std::string>& chosen) {
    constexpr std::size_t most = 4;  // of contacts
    const std::vector<ToolContact>&events = input.start.scene.events, &before = input.before->scene.events;
    std::vector<std::string> keys;
    const auto add = [&](std::size_t event, const char* name) {
        const std::string key = "events." + std::to_string(event) + '.' + name;
        if (std::find(chosen.begin(), chosen.end(), key) == chosen.end()) keys.push_back(key);
    };
    const auto works = [](const ToolContact& contact) {
        return contact.hot() ? contact.power > 0.0 : divides(contact.action) && contact.strength > 0.0;
    };
    std::size_t freed = 0;
    for (const std::vector<std::size_t>& stroke : strokes_of(events, works)) {
        const std::size_t k = stroke.front();
        const ToolContact& event = events[k];
        const bool moved = k >= before.size() || event.time != before[k].time || event.duration != before[k].duration;
        if (stroke.size() > 1 || !moved || freed == most) continue;
        ++freed;
        add(k, "time");
        if (event.hot()) add(k, "duration");
    }
    if (keys.empty()) return;
    for (FreeParameter& p : free_parameters(input.start, keys)) input.parameters.push_back(std::move(p));
    input.of_proposal = keys.size();
}

}  // namespace

Proposal propose(const document::Content& start, const std::shared_ptr<const PreparedOrgan>& organ,
                 std::span<const TargetPoint> target, const ProposalOptions& options) {
    return Proposing(start, organ, target, options).run();
}

std::vector<std::string> texts_of(std::span<const ProposalLine> lines) {
    std::vector<std::string> texts;
    for (const ProposalLine& line : lines) texts.push_back(line.text);
    return texts;
}

ProposalLine scene_was_nearer(const Scene& before, const Scene& proposed) {
    if (before.events == proposed.events && before.curves.emission == proposed.curves.emission)
        return {About::amounts, "the scene as it was is nearer to the reference than what was proposed"};
    return {About::tools, before.events.empty()
                              ? "tools: none are added, what they would explain is within the error of measuring"
                              : "tools: stay as they are, with which the scene is nearer to the reference than with "
                                "those proposed"};
}

std::vector<ProposalLine> without_moves(std::span<const ProposalLine> lines) {
    std::vector<ProposalLine> left;
    std::ranges::copy_if(lines, std::back_inserter(left),
                         [](const ProposalLine& line) { return line.about == About::offset; });
    return left;
}

std::vector<ProposalLine> begin_with_proposal(FitInput& input, bool tools) {
    std::vector<std::string> keys;
    for (const FreeParameter& p : input.parameters) keys.push_back(p.key);
    Proposal proposal = propose(input.start, input.organ, input.target, {.aspect = input.aspect, .keys = keys});
    for (const FreeParameter& p : input.parameters) p.set(proposal.tuned, p.get(proposal.tuned));  // within its bounds
    if (tools) {
        input.before = std::exchange(input.start, std::move(proposal.tuned));
        free_moved_tools(input, keys);
    } else {
        proposal.tuned.scene = input.start.scene;
        input.proposed = std::move(proposal.tuned);
        std::erase_if(proposal.lines, [](const ProposalLine& line) { return line.about == About::tools; });
        proposal.lines.push_back({About::tools, "tools: stay as they are"});
    }
    return std::move(proposal.lines);
}

}  // namespace lapfx::match
