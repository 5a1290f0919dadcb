#include "bleeding/bleed_cpu.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "organ/above_zero.h"

namespace lapfx::bleeding {

namespace {

constexpr double longest_triangle = 1000.0;  // mm; organs have none, files with a wrong unit have

/// Bleed value `beyond` mm outside the reach of a source value, below 0: noise may show blood there. While the source
/// value is smaller than the noise the value falls faster, so that a wound never begins as a blob of noise.
float steepness(float source, float noise_strength) {
    return std::max(1.0f, noise_strength / source);
}

double longest_edge(const Surface& surface) {
    double longest = 0.0;
    const auto& p = surface.positions;
    for (const auto& c : surface.triangles)
        for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::distance(p[c[i]], p[c[(i + 1) % 3]]));
    return std::min(longest, longest_triangle);
}

}  // namespace

BleedField::BleedField(const Surface& surface, glm::dvec3 down)
    : surface_(surface),
      longest_edge_(longest_edge(surface)),
      dry_(driest()),
      room_(surface, down),
      clearing_(surface, down),
      surface_values_(surface.positions.size(), glm::vec2(dry_, 0.0f)),
      values_(surface.weld.size(), glm::vec2(dry_, 0.0f)),
      is_touched_(surface.positions.size(), false),
      is_counted_(surface.triangles.size(), false),
      changed_(surface.weld.size()) {
    copies_of_.resize(surface.positions.size() + 1);
    for (const std::uint32_t v : surface.weld) ++copies_of_[v + 1];
    for (std::size_t i = 1; i < copies_of_.size(); ++i) copies_of_[i] += copies_of_[i - 1];
    copies_.resize(surface.weld.size());
    std::vector<std::uint32_t> next(copies_of_.begin(), copies_of_.end() - 1);
    for (std::uint32_t i = 0; i < surface.weld.size(); ++i) copies_[next[surface.weld[i]]++] = i;
    changed_.mark_all();
}

void BleedField::set(std::span<const Wound> wounds, const BleedingParameters& parameters) {
    if (metric_of(parameters) != metric_of(parameters_)) bleeders_.clear();
    // What only the shader or the amounts look at changes no value.
    const bool same_values =
        parameters.speed == parameters_.speed && parameters.max_extent == parameters_.max_extent &&
        parameters.noise_strength == parameters_.noise_strength && parameters.pulse_rate == parameters_.pulse_rate &&
        parameters.pulse_strength == parameters_.pulse_strength &&
        parameters.coagulation_time == parameters_.coagulation_time && metric_of(parameters) == metric_of(parameters_);
    stale_ = stale_ || !same_values;
    watch_all_ = true;
    parameters_ = parameters;
    if (!same_values) strength_ = Strength(strength_.curve(), parameters_);
    amount_known_ = false;
    if (const float wanted = driest(); wanted != dry_) {
        dry_ = wanted;
        std::fill(surface_values_.begin(), surface_values_.end(), glm::vec2(dry_, 0.0f));
        std::fill(values_.begin(), values_.end(), glm::vec2(dry_, 0.0f));
        changed_.mark_all();
    }
    replace_wounds(wounds);
}

/// Gravity at most doubles a distance, so no neighbour of what noise can reach is drier.
float BleedField::driest() const noexcept {
    return static_cast<float>(-(parameters_.noise_strength + 2.0 * longest_edge_ + 1.0));
}

/// The common case, wounds added at the end and others stopped, touches no front.
void BleedField::replace_wounds(std::span<const Wound> wounds) {
    const auto in_place = [&] {
        for (std::size_t i = 0; i < bleeders_.size(); ++i)
            if (bleeders_[i].wound.position != wounds[i].position) return false;
        return true;
    };
    if (wounds.size() >= bleeders_.size() && in_place()) {
        for (std::size_t i = 0; i < bleeders_.size(); ++i) bleeders_[i].wound = wounds[i];
    } else {
        const auto key = [](const glm::dvec3& p) { return std::tuple(p.x, p.y, p.z); };
        std::multimap<std::tuple<double, double, double>, Bleeder> known;
        for (Bleeder& b : bleeders_)
            if (is_place(b.wound.position)) known.emplace(key(b.wound.position), std::move(b));
        bleeders_.clear();
        for (const Wound& wound : wounds) {
            // A NaN has no order: it must not be looked up.
            const auto found = is_place(wound.position) ? known.find(key(wound.position)) : known.end();
            if (found == known.end()) {
                bleeders_.push_back({.wound = wound, .front = Front(room_, metric_of(parameters_), wound.position)});
                continue;
            }
            bleeders_.push_back({.wound = wound, .front = std::move(found->second.front)});
            known.erase(found);
        }
        stale_ = true;
    }
    bleeders_.reserve(wounds.size());
    for (std::size_t i = bleeders_.size(); i < wounds.size(); ++i)
        bleeders_.push_back({.wound = wounds[i], .front = Front(room_, metric_of(parameters_), wounds[i].position)});
    status_.resize(wounds.size());
    for (std::size_t i = 0; i < wounds.size(); ++i) status_[i].wound = wounds[i];
}

void BleedField::set_clearing(const tool::Log& log, const BleedingParameters& parameters) {
    if (clearing_.set(log, parameters)) stale_ = watch_all_ = true;
}

void BleedField::set_strength(const FactorCurve& strength) {
    if (strength == strength_.curve()) return;
    strength_ = Strength(strength, parameters_);
    stale_ = watch_all_ = true;
}

void BleedField::keep(std::vector<glm::vec2> values, double time) {
    kept_ = std::move(values);
    kept_at_ = time;
    for (std::uint32_t v = 0; v < kept_.size(); ++v)
        if (kept_[v].x > none) touch(v);
    stale_ = true;
}

/// mm that blood has come, of a flow that nothing bounds; clots draw together.
double BleedField::source_of(const Bleeder& bleeder, double flowed) const noexcept {
    return std::min(flowed, parameters_.max_extent) * (1.0 - clot_shrink * static_cast<double>(bleeder.clot));
}

/// Whether places that were cleared fill up with the flow between what was written and `flowed`: it goes on when the
/// extent has long been reached.
bool BleedField::refills(const Bleeder& b, double flowed) const noexcept {
    if (b.cleared == never_cleared || flowed == b.flowed) return false;
    return std::min(flowed, b.flowed) - flow(b.wound, parameters_, b.cleared, strength_) < parameters_.max_extent;
}

/// Whether nothing that comes changes what the bleeder is, but for another clearing: it has clotted, or bled all over
/// its extent with nothing to end it.
bool BleedField::is_settled(const Bleeder& b, double time) const noexcept {
    if (b.clot == 1.0f && time > b.wound.start) return true;
    return b.wound.stop == std::numeric_limits<double>::infinity() && b.cleared == never_cleared &&
           flow(b.wound, parameters_, time, strength_) >= parameters_.max_extent;
}

/// Much has bled and stands: a frame costs what still changes.
void BleedField::watch(double time, bool cleared) noexcept {
    if (watch_all_ || cleared || time < watched_at_) {
        watched_.resize(bleeders_.size());
        std::iota(watched_.begin(), watched_.end(), 0u);
    }
    watch_all_ = false;
    watched_at_ = time;
}

void BleedField::update(double time) noexcept {
    const bool cleared = clearing_.update(time);
    watch(time, cleared);
    bool changed = stale_ || cleared, only_grows = !changed;
    for (const std::uint32_t i : watched_) {
        Bleeder& b = bleeders_[i];
        const auto clot = static_cast<float>(clot_of(b.wound, parameters_, time));
        only_grows = only_grows && clot == b.clot;
        changed = changed || clot != b.clot;
        b.clot = clot;
        const double flowed = flow(b.wound, parameters_, time, strength_), source = source_of(b, flowed);
        only_grows = only_grows && source >= b.source;
        changed = changed || source != b.source || refills(b, flowed);
    }
    if (age_kept(time)) changed = true, only_grows = false;
    if (!changed) return tell(time);
    stale_ = false;
    if (!only_grows) wipe();
    const auto write_at = [&](Bleeder& b) {
        const double flowed = flow(b.wound, parameters_, time, strength_), source = source_of(b, flowed);
        const bool same = source == b.source && !refills(b, flowed);
        b.flowed = flowed;
        if (only_grows && same) return;
        b.source = source;
        write(b);
    };
    if (only_grows)
        for (const std::uint32_t i : watched_) write_at(bleeders_[i]);
    else
        for (Bleeder& b : bleeders_) write_at(b);
    publish();
    if (bleeders_.empty() && kept_.empty()) forget();
    tell(time);
}

/// What each wound is doing: of what has been written, for that is where its blood was cleared.
void BleedField::tell(double time) noexcept {
    for (const std::uint32_t i : watched_) {
        const Bleeder& b = bleeders_[i];
        status_[i] = {.wound = b.wound,
                      .state = state_of(b.wound, parameters_, time, strength_, b.cleared),
                      .extent = source_value(b.wound, parameters_, time, strength_),
                      .bleeds = bleeds(b.wound, parameters_, time, strength_, b.cleared)};
    }
    std::erase_if(watched_, [&](std::uint32_t i) { return is_settled(bleeders_[i], time); });
}

/// No blood is left: what it has touched need not be looked at again.
void BleedField::forget() noexcept {
    for (const std::uint32_t v : touched_) is_touched_[v] = false;
    for (const Touched& t : touched_triangles_) is_counted_[t.triangle] = false;
    touched_.clear();
    touched_triangles_.clear();
    sorted_triangles_ = 0;
}

/// Blood that was there before the organ was cut belongs to the wounds of that time: it clots when they have. True when
/// that has changed.
bool BleedField::age_kept(double time) noexcept {
    if (kept_.empty()) return false;
    const bool shown = time >= kept_at_;
    float clot = 1.0f;
    bool any = false;
    for (const Bleeder& b : bleeders_) {
        if (b.wound.start >= kept_at_) continue;
        clot = std::min(clot, b.clot);
        any = true;
    }
    const float aged = any ? clot : 0.0f;
    const bool changed = shown != kept_shown_ || aged != kept_clot_;
    kept_shown_ = shown;
    kept_clot_ = aged;
    return changed;
}

void BleedField::wipe() noexcept {
    for (const std::uint32_t v : touched_) {
        surface_values_[v] = glm::vec2(dry_, 0.0f);
        if (kept_.empty() || kept_[v].x <= none) continue;
        if (!kept_shown_) continue;
        glm::vec2 value(kept_[v].x, std::max(kept_[v].y, kept_clot_));
        clearing_.for_each(v, [&](const Clearing::Cap& cap) {
            if (cap.time >= kept_at_) value.x = std::min(value.x, cap.cap);
        });
        surface_values_[v] = {std::max(value.x, dry_), value.x > dry_ ? value.y : 0.0f};
    }
    written_.assign(touched_.begin(), touched_.end());
}

void BleedField::write(Bleeder& b) noexcept {
    b.cleared = never_cleared;
    if (b.source <= 0.0) return;
    const auto source = static_cast<float>(b.source), noise = static_cast<float>(parameters_.noise_strength);
    const float steep = steepness(source, noise);
    const bool cleared = clearing_.any();
    double edge = 0.0;
    // Up to what noise can reach, and a triangle beyond, where gravity at most doubles a distance.
    for (std::size_t r = 0;
         static_cast<double>(r) * Front::ring_width <= b.source + parameters_.noise_strength + 2.0 * edge; ++r) {
        const std::span<const Reached> ring = b.front.ring(r, room_);
        if (b.front.ended(r)) break;
        edge = std::min(b.front.longest_edge(r), longest_triangle);
        for (const Reached& at : ring) {
            const float inside = source - at.distance;
            const float value = inside >= 0.0f ? inside : inside * steep;
            put(at.vertex, std::max(cleared ? shown(b, at) : value, dry_), b.clot);
        }
    }
}

/// Value of one wound where something may have been cleared. What was there is capped; what has flowed since is not.
/// Notes when blood of the wound was taken away.
float BleedField::shown(Bleeder& b, const Reached& at) const noexcept {
    const auto since = [&](double time) {
        const double source = source_of(b, b.flowed - flow(b.wound, parameters_, time, strength_));
        if (source <= 0.0) return dry_;
        const float inside = static_cast<float>(source) - at.distance;
        return inside >= 0.0f
                   ? inside
                   : inside * steepness(static_cast<float>(source), static_cast<float>(parameters_.noise_strength));
    };
    const float whole = since(Clearing::never);
    float value = whole;
    clearing_.for_each(at.vertex, [&](const Clearing::Cap& cap) {
        value = std::max(std::min(value, cap.cap), since(cap.time));
        if (cap.cap < whole) b.cleared = std::max(b.cleared, cap.time);
    });
    return value;
}

/// The larger value counts; of equal ones the fresher blood.
void BleedField::put(std::uint32_t vertex, float value, float clot) noexcept {
    touch(vertex);
    glm::vec2& at = surface_values_[vertex];
    if (value < at.x || (value == at.x && clot >= at.y)) return;
    at = {value, clot};
    written_.push_back(vertex);
}

void BleedField::touch(std::uint32_t vertex) noexcept {
    if (is_touched_[vertex]) return;
    is_touched_[vertex] = true;
    touched_.push_back(vertex);
    for (const std::uint32_t t : surface_.triangles_at(vertex)) {
        if (is_counted_[t]) continue;
        is_counted_[t] = true;
        touched_triangles_.push_back({t, static_cast<float>(surface_.area(t))});
    }
}

void BleedField::publish() noexcept {
    for (const std::uint32_t v : written_)
        for (std::uint32_t i = copies_of_[v]; i < copies_of_[v + 1]; ++i) {
            const std::uint32_t copy = copies_[i];
            if (values_[copy] == surface_values_[v]) continue;
            values_[copy] = surface_values_[v];
            changed_.mark(copy);
        }
    written_.clear();
    amount_known_ = false;
}

BloodAmount BleedField::amount() const noexcept {
    if (amount_known_) return amount_;
    amount_ = {};
    // In the order of the triangles: sums depend on theirs, and blood touches them in another at each frame rate.
    if (sorted_triangles_ != touched_triangles_.size())
        std::sort(touched_triangles_.begin(), touched_triangles_.end(),
                  [](const Touched& a, const Touched& b) { return a.triangle < b.triangle; });
    sorted_triangles_ = touched_triangles_.size();
    const auto above = [&](std::uint32_t v) { return surface_values_[v].x - parameters_.threshold; };
    for (const Touched& t : touched_triangles_) {
        const auto& c = surface_.triangles[t.triangle];
        const organ::AboveZero wet = organ::above_zero(above(c[0]), above(c[1]), above(c[2]));
        amount_.area += t.area * wet.share;
        amount_.volume += t.area * wet.share * parameters_.thickness * std::min(1.0, wet.mean / parameters_.deep_at);
    }
    amount_known_ = true;
    return amount_;
}

int BleedField::bleeding_wounds() const noexcept {
    return static_cast<int>(
        std::count_if(status_.begin(), status_.end(), [](const WoundStatus& status) { return status.bleeds; }));
}

}  // namespace lapfx::bleeding
