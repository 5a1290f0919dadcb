#include "bleeding/bleed_cpu.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "lapfx/authoring/compare.h"
#include "lapfx/preset.h"

namespace lapfx::bleeding {

namespace {

constexpr double ever = std::numeric_limits<double>::infinity();  // s
constexpr float lowest = std::numeric_limits<float>::lowest();    // mm
constexpr double longest_triangle = 1000.0;                       // mm; only files with a wrong unit have such edges

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

/// How far the blood of one wound has come again since a clearing, kept by the clearing's time, which many places
/// share.
class BleedField::Refills {
  public:
    template <class Source>
    double at(double time, const Source& source) {
        Entry& entry = entries_[std::bit_cast<std::uint64_t>(time) * 0x9e3779b97f4a7c15u >> (64 - bits)];
        if (entry.time != time) entry = {time, source()};
        return entry.source;
    }

  private:
    static constexpr int bits = 6;
    struct Entry {
        double time = std::numeric_limits<double>::quiet_NaN(), source = 0.0;  // s, mm
    };
    std::array<Entry, 1 << bits> entries_;
};

BleedField::BleedField(const Surface& surface, glm::dvec3 down)
    : surface_(surface),
      longest_edge_(longest_edge(surface)),
      dry_(driest()),
      room_(surface, down),
      clearing_(surface, down),
      surface_values_(surface.positions.size(), glm::vec2(dry_, 0.0f)),
      settled_values_(surface_values_),
      ended_(surface.positions.size(), dry_),
      places_(surface.positions.size()),
      anew_(surface.positions),
      settled_anew_(surface.positions),
      values_(surface.weld.size(), glm::vec2(dry_, 0.0f)),
      touched_(surface.positions.size()),
      changed_(surface.weld.size()),
      amount_(surface, down) {
    changed_.mark_all();
}

void BleedField::set(std::span<const Wound> wounds, const BleedingParameters& parameters) {
    set_parameters(parameters, difference(*preset_table().find("bleeding"), &parameters_, &parameters));
    set_wounds(wounds);
}

void BleedField::set_parameters(const BleedingParameters& parameters, unsigned changed) {
    const bool same_values = (changed & redo::bleed) == 0;
    stale_ = stale_ || !same_values;
    if (changed & redo::blood_sums) amount_.mark_all();
    parameters_ = parameters;
    clearing_.set_parameters(parameters, changed);
    if (!same_values) strength_ = Strength(strength_.curve(), parameters_);
    if (changed & redo::fronts) run_again();
    if (const float wanted = driest(); wanted != dry_) {
        dry_ = wanted;
        std::fill(surface_values_.begin(), surface_values_.end(), glm::vec2(dry_, 0.0f));
        std::fill(settled_values_.begin(), settled_values_.end(), glm::vec2(dry_, 0.0f));
        std::fill(values_.begin(), values_.end(), glm::vec2(dry_, 0.0f));
        ended_.reset(dry_);
        stale_ = true;
        changed_.mark_all();
        amount_.mark_all();  // nothing else shows where blood was removed
    }
}

/// All fronts from the beginning.
void BleedField::run_again() {
    const std::vector<WoundStatus> former = std::exchange(status_, {});
    bleeders_.clear();
    active_.clear();
    for (const WoundStatus& status : former) add_bleeder(status.wound, new_front(status.wound));
    stale_ = true;
}

/// Gravity at most doubles a distance, so no neighbour of a place within reach of noise is drier.
float BleedField::driest() const noexcept {
    return static_cast<float>(-(parameters_.noise_strength + 2.0 * longest_edge_ + 1.0));
}

void BleedField::add_bleeder(const Wound& wound, Front front) {
    const auto number = static_cast<std::uint32_t>(bleeders_.size());
    bleeders_.push_back({.number = number, .front = std::move(front)});
    active_.push_back(number);
    status_.push_back({.wound = wound});
}

/// Whether all that has changed is that a clip was put on a wound, or taken off, after it had clotted: its blood stays.
bool BleedField::is_clip_on_clotted(const Wound& was, const Wound& now) const noexcept {
    Wound sealed = was;
    sealed.sealed = now.sealed;
    return sealed == now && std::min(was.sealed, now.sealed) >= was.stop + parameters_.coagulation_time;
}

/// In the common case, wounds are added at the end or stopped, and no front changes.
void BleedField::set_wounds(std::span<const Wound> wounds) {
    const auto in_place = [&] {
        for (std::size_t i = 0; i < bleeders_.size(); ++i)
            if (status_[i].wound.position != wounds[i].position) return false;
        return true;
    };
    if (wounds.size() >= bleeders_.size() && in_place()) {
        for (std::uint32_t i = 0; i < bleeders_.size(); ++i) {
            if (status_[i].wound == wounds[i]) continue;
            if (bleeders_[i].has_ended)
                stale_ = stale_ || !is_clip_on_clotted(status_[i].wound, wounds[i]);
            else if (bleeders_[i].is_settled)
                activate(i);
            else  // the flow since a clearing may also be smaller now
                for_each_reached(bleeders_[i], [&](const Reached& at) { anew_.add(at.vertex); });
            status_[i].wound = wounds[i];
        }
    } else {
        const auto key = [](const glm::dvec3& p) { return std::tuple(p.x, p.y, p.z); };
        std::multimap<std::tuple<double, double, double>, Front> known;
        for (Bleeder& b : bleeders_)
            if (const glm::dvec3& place = wound_of(b).position; is_place(place))
                known.emplace(key(place), std::move(b.front));
        bleeders_.clear();
        active_.clear();
        status_.clear();
        for (const Wound& wound : wounds) {
            // A NaN has no order and must not be looked up.
            const auto found = is_place(wound.position) ? known.find(key(wound.position)) : known.end();
            if (found == known.end()) {
                add_bleeder(wound, new_front(wound));
                continue;
            }
            add_bleeder(wound, std::move(found->second));
            known.erase(found);
        }
        stale_ = true;
    }
    bleeders_.reserve(wounds.size());
    clotted_.reserve(wounds.size());  // updates do not allocate
    for (std::size_t i = bleeders_.size(); i < wounds.size(); ++i) add_bleeder(wounds[i], new_front(wounds[i]));
}

void BleedField::set_clearing(const tool::Log& log) {
    clearing_.set(log);
    if (clearing_.unfinished_since() < ended_.since()) stale_ = true;  // those wounds may still have flowed
}

void BleedField::set_strength(const FactorCurve& strength) {
    if (strength == strength_.curve()) return;
    strength_ = Strength(strength, parameters_);
    stale_ = true;
}

void BleedField::keep(KeptBlood kept) {
    kept_ = std::move(kept);
    for (std::uint32_t v = 0; v < kept_.values.size(); ++v)
        if (kept_.values[v].x > none) touched_.add(v);
    stale_ = true;
}

void BleedField::replace(Bleeding& former) {
    if (former.model() == model()) keep(std::move(static_cast<BleedField&>(former).kept_));
}

void BleedField::keep(const Bleeding& former, std::span<const std::uint32_t> sources, double time) {
    KeptBlood kept{.values = std::vector(surface_.positions.size(), glm::vec2(none, 0.0f)), .time = time};
    for (std::size_t v = 0; v < sources.size(); ++v) {
        if (sources[v] == gone) continue;
        const BloodAt blood = former.at(sources[v]);
        glm::vec2& at = kept.values[surface_.weld[v]];
        if (blood.any && blood.value > at.x) at = {blood.value, blood.clot};
    }
    keep(std::move(kept));
}

/// How far blood has travelled for an unbounded flow, mm; clots draw together.
double BleedField::source_of(const Bleeder& bleeder, double flowed) const noexcept {
    return std::min(flowed, parameters_.max_extent) * (1.0 - clot_shrink * static_cast<double>(bleeder.clot));
}

/// Whether cleared places still fill with the flow between what was written and `flowed`, even long after the extent
/// was reached.
bool BleedField::refills(const Bleeder& b, double flowed) const noexcept {
    if (b.cleared == never_cleared || flowed == b.flowed) return false;
    return std::min(flowed, b.flowed) - flow(wound_of(b), parameters_, b.cleared, strength_) < parameters_.max_extent;
}

/// Whether only the tool can still change the bleeder after `time`: it has clotted, or its blood covers its extent and
/// nothing will end the bleeding.
bool BleedField::has_settled(const Bleeder& b, double time) const noexcept {
    constexpr double rounding = 1e-6;  // mm; rounding may make a later flow smaller by this
    if (b.clot == 1.0f && time > wound_of(b).start) return true;
    const double full = parameters_.max_extent + rounding;
    if (wound_of(b).stop != std::numeric_limits<double>::infinity() || b.flowed < full) return false;
    return b.cleared == never_cleared || b.flowed - flow(wound_of(b), parameters_, b.cleared, strength_) >= full;
}

/// Finds the state of the bleeder at `time`, and what that changes.
void BleedField::look(Bleeder& b, double time) noexcept {
    const auto clot = static_cast<float>(clot_of(wound_of(b), parameters_, time));
    const double flowed = flow(wound_of(b), parameters_, time, strength_), before = b.source;
    const bool clots = clot != b.clot;
    b.clot = clot;
    b.source = source_of(b, flowed);
    b.falls = clots || b.source < before;
    b.spreads = b.falls || b.source != before;
    b.writes = b.spreads || refills(b, flowed);
    b.flowed = flowed;
}

void BleedField::update(double time) noexcept {
    const bool cleared = clearing_.update(time);
    stale_ = stale_ || time < updated_ || (cleared && clearing_.changed_anywhere());
    updated_ = time;
    if (stale_)
        for (Bleeder& b : bleeders_) look(b, time);
    else
        for (const std::uint32_t i : active_) look(bleeders_[i], time);
    if (age_kept(time)) stale_ = true;
    if (stale_) {
        write_anew(time);
    } else {
        if (cleared) unsettle_cleared(time);
        write_changes(time);
    }
    stale_ = false;
    publish();
    if (bleeders_.empty() && kept_.values.empty()) forget();
    settle(time);
}

/// Everything, as at the first time.
void BleedField::write_anew(double time) noexcept {
    anew_.clear();
    settled_anew_.clear();
    ended_.reset(touched_.points());
    active_.clear();
    clotted_.clear();
    for (std::uint32_t i = 0; i < bleeders_.size(); ++i) {
        Bleeder& b = bleeders_[i];
        look(b, time);
        b.cleared = never_cleared;
        // Where something was cleared, only writing shows it.
        b.is_settled = has_settled(b, time) && (b.clot == 1.0f || !clearing_.any());
        b.has_ended = false;
        march(b);
        if (!b.is_settled)
            active_.push_back(i);
        else if (b.clot == 1.0f)
            clotted_.push_back(i);
    }
    end_clotted();
    for (const std::uint32_t v : touched_.points()) settle_anew(v);
    for (Bleeder& b : bleeders_)
        if (b.is_settled && !b.has_ended) write(b, settled_values_);
    for (const std::uint32_t v : touched_.points()) surface_values_[v] = settled_values_[v];
    written_.assign(touched_.points().begin(), touched_.points().end());
    for (const std::uint32_t i : active_) write(bleeders_[i], surface_values_);
    for (std::uint32_t i = 0; i < bleeders_.size(); ++i) tell(i, time);
}

/// The tool has removed blood at some places; settled wounds whose blood was there may fill them again.
void BleedField::unsettle_cleared(double time) noexcept {
    for (const std::uint32_t v : clearing_.changed())
        if (touched_.has(v)) {
            settled_anew_.add(v);
            anew_.add(v);
        }
    const Box cleared = settled_anew_.box();
    for (std::uint32_t i = 0; i < bleeders_.size(); ++i) {
        Bleeder& b = bleeders_[i];
        if (!b.is_settled || b.clot == 1.0f || !b.box.meets(cleared)) continue;
        look(b, time);
        Refills refills;
        for_each_reached(b, [&](const Reached& at) {
            if (settled_anew_.has(at.vertex)) value_at(b, at, refills, lowest, ever);
        });
        if (!has_settled(b, time)) activate(i);
    }
}

/// What has changed since the last time, at the places where it has.
void BleedField::write_changes(double time) noexcept {
    for (const std::uint32_t v : settled_anew_.vertices()) settle_anew(v);
    if (!settled_anew_.empty())
        for (Bleeder& b : bleeders_)
            if (b.is_settled && !b.has_ended && b.box.meets(settled_anew_.box()))
                write(b, settled_values_, settled_anew_);
    for (const std::uint32_t i : active_) {
        Bleeder& b = bleeders_[i];
        if (b.falls) for_each_reached(b, [&](const Reached& at) { anew_.add(at.vertex); });
    }
    for (const std::uint32_t v : anew_.vertices()) {
        surface_values_[v] = settled_values_[v];
        written_.push_back(v);
    }
    places_.forget();
    for (const std::uint32_t i : active_) {
        Bleeder& b = bleeders_[i];
        const bool is_wiped = !anew_.empty() && b.box.meets(anew_.box());
        if (b.writes || is_wiped) {
            march(b);
            if (b.spreads)
                write(b, surface_values_);
            else
                write_refill(b);
        }
        tell(i, time);
    }
    anew_.clear();
    settled_anew_.clear();
}

/// A settled bleeder may change again: its values leave the settled layer.
void BleedField::activate(std::uint32_t number) noexcept {
    Bleeder& b = bleeders_[number];
    b.is_settled = false;
    active_.push_back(number);
    std::erase(clotted_, number);
    for_each_reached(b, [&](const Reached& at) {
        settled_anew_.add(at.vertex);
        anew_.add(at.vertex);
    });
}

/// Wounds that have settled by clotting go to the blood that has ended, as soon as no sweep is left that their flow
/// could answer to.
void BleedField::end_clotted() noexcept {
    constexpr double rounding = 1e-6;  // s; a sum of times may be too early by this
    const auto end_of = [&](const Bleeder& b) { return wound_of(b).stop + parameters_.coagulation_time + rounding; };
    if (clotted_.empty()) return;
    const double until = clearing_.unfinished_since();
    double latest = EndedBlood::never;
    for (const std::uint32_t i : clotted_)
        if (const double end = end_of(bleeders_[i]); end <= until) latest = std::max(latest, end);
    ended_.advance(latest, clearing_);
    std::erase_if(clotted_, [&](std::uint32_t i) {
        Bleeder& b = bleeders_[i];
        if (end_of(b) > until) return false;
        b.has_ended = true;
        Refills refills;
        for_each_reached(
            b, [&](const Reached& at) { ended_.add(at.vertex, value_at(b, at, refills, lowest, ended_.since())); });
        return true;
    });
}

/// The settled value of a place without the wounds that are written one by one.
void BleedField::settle_anew(std::uint32_t vertex) noexcept {
    glm::vec2& at = settled_values_[vertex] = kept_at(vertex);
    if (const float value = ended_.at(vertex, clearing_); value > at.x) at = {value, 1.0f};
}

void BleedField::settle(double time) noexcept {
    std::erase_if(active_, [&](std::uint32_t i) {
        Bleeder& b = bleeders_[i];
        b.is_settled = has_settled(b, time);
        if (!b.is_settled) return false;
        write(b, settled_values_);
        if (b.clot == 1.0f) clotted_.push_back(i);
        return true;
    });
    end_clotted();
}

/// The state of a wound, from what has been written, because writing notes where its blood was cleared.
void BleedField::tell(std::uint32_t number, double time) noexcept {
    const double cleared = bleeders_[number].cleared;
    WoundStatus& status = status_[number];
    status.state = state_of(status.wound, parameters_, time, strength_, cleared);
    status.extent = source_value(status.wound, parameters_, time, strength_);
    status.bleeds = bleeds(status.wound, parameters_, time, strength_, cleared);
}

/// No blood is left: the places that it touched need not be examined again.
void BleedField::forget() noexcept {
    touched_.clear();
    amount_.clear();
}

/// Blood from before the organ was cut belongs to the wounds of that time and clots with them. True when that has
/// changed.
bool BleedField::age_kept(double time) noexcept {
    if (kept_.values.empty()) return false;
    const bool shown = time >= kept_.time;
    float clot = 1.0f;
    bool any = false;
    for (const Bleeder& b : bleeders_) {
        if (wound_of(b).start >= kept_.time) continue;
        clot = std::min(clot, b.clot);
        any = true;
    }
    const float aged = any ? clot : 0.0f;
    const bool changed = shown != kept_shown_ || aged != kept_clot_;
    kept_shown_ = shown;
    kept_clot_ = aged;
    return changed;
}

/// The value kept at a place, dry where nothing was kept.
glm::vec2 BleedField::kept_at(std::uint32_t v) const noexcept {
    const glm::vec2 none_here(dry_, 0.0f);
    if (!kept_shown_ || kept_.values.empty() || kept_.values[v].x <= none) return none_here;
    glm::vec2 value(kept_.values[v].x, std::max(kept_.values[v].y, kept_clot_));
    clearing_.for_each(v, [&](const Clearing::Cap& cap) {
        if (cap.time >= kept_.time) value.x = std::min(value.x, cap.cap);
    });
    return value.x > dry_ ? value : none_here;
}

/// As far as it was written.
template <class Visit>
void BleedField::for_each_reached(Bleeder& b, Visit visit) noexcept {
    for (std::size_t r = 0; r < b.rings; ++r)
        for (const Reached& at : b.front.ring(r, room_)) visit(at);
}

/// As far as noise can reach, and one triangle more, where gravity at most doubles a distance.
void BleedField::march(Bleeder& b) noexcept {
    b.rings = 0;
    if (b.source <= 0.0) return;
    double edge = 0.0;
    for (std::size_t r = 0;
         static_cast<double>(r) * Front::ring_width <= b.source + parameters_.noise_strength + 2.0 * edge; ++r) {
        const std::span<const Reached> ring = b.front.ring(r, room_);
        if (b.front.ended(r)) break;
        edge = std::min(b.front.longest_edge(r), longest_triangle);
        b.rings = r + 1;
        if (r < b.boxed) continue;
        b.boxed = b.rings;
        for (const Reached& at : ring) {
            b.box.add(surface_.positions[at.vertex]);
            touched_.add(at.vertex);
        }
    }
}

void BleedField::write(Bleeder& b, Layer& layer) noexcept {
    b.cleared = never_cleared;
    Refills refills;
    for_each_reached(b, [&](const Reached& at) { put_value(b, at, layer, refills); });
}

void BleedField::write(Bleeder& b, Layer& layer, const Region& within) noexcept {
    Refills refills;
    for_each_reached(b, [&](const Reached& at) {
        if (within.has(at.vertex)) put_value(b, at, layer, refills);
    });
}

/// Writes a wound whose blood has not spread since it was written: only where anything else can have changed.
void BleedField::write_refill(Bleeder& b) noexcept {
    b.cleared = never_cleared;
    Refills refills;
    for_each_reached(b, [&](const Reached& at) {
        const ClearedPlace* place = places_.at(at.vertex, [&] { return place_at(at.vertex); });
        if (place != nullptr && may_raise(b, at, *place, refills)) put_value(b, at, surface_values_, refills);
    });
}

std::optional<ClearedPlace> BleedField::place_at(std::uint32_t vertex) const noexcept {
    if (!clearing_.is_capped(vertex) && !anew_.has(vertex)) return std::nullopt;
    ClearedPlace place;
    const float beyond = std::nextafter(surface_values_[vertex].x, lowest);
    clearing_.from_latest(vertex, [&](const Clearing::Cap& cap) {
        place.latest = std::max(place.latest, cap.time);
        place.earliest = std::min(place.earliest, cap.time);
        place.limit = std::min(place.limit, cap.cap);
        return place.limit > beyond;
    });
    return place;
}

/// False where neither what the clearings have left of the wound's blood nor what has flowed since can be more than
/// what lies there, and it is known already when blood of the wound was removed.
bool BleedField::may_raise(const Bleeder& b, const Reached& at, const ClearedPlace& place,
                           Refills& refills) const noexcept {
    if (place.latest > b.cleared) return true;
    const float beyond = beyond_of(b, surface_values_[at.vertex]);
    // Outside the reach of a source values are lower than this.
    const auto at_most = [&](double source) { return static_cast<float>(source) - at.distance; };
    if (std::min(at_most(b.source), place.limit) > beyond) return true;
    if (place.earliest > place.latest) return false;  // nothing was cleared there, so nothing has flowed since
    constexpr float rounding = 1e-4f;                 // mm; two flows may differ by less than their digits hold
    return at_most(refilled(b, place.earliest, refills)) > beyond - rounding;
}

/// How far the blood of a wound has come again since a clearing, mm.
double BleedField::refilled(const Bleeder& b, double cleared, Refills& refills) const noexcept {
    return refills.at(cleared,
                      [&] { return source_of(b, b.flowed - flow(wound_of(b), parameters_, cleared, strength_)); });
}

/// What the value of a wound has to be above to be put where `there` lies: of equal values that of the fresher blood
/// counts.
float BleedField::beyond_of(const Bleeder& b, const glm::vec2& there) noexcept {
    return b.clot < there.y ? std::nextafter(there.x, lowest) : there.x;
}

/// The larger value counts; of equal values that of the fresher blood.
void BleedField::put_value(Bleeder& b, const Reached& to, Layer& layer, Refills& refills) noexcept {
    glm::vec2& at = layer[to.vertex];
    const float value = std::max(value_at(b, to, refills, beyond_of(b, at), ever), dry_);
    if (value < at.x || (value == at.x && b.clot >= at.y)) return;
    at = {value, b.clot};
    if (&layer == &surface_values_) written_.push_back(to.vertex);
}

/// The value of one wound with what was cleared before a time; where it is not above `beyond`, any value that is
/// not is as good. A clearing caps earlier blood but not later flow. Notes when blood of the wound was removed.
float BleedField::value_at(Bleeder& b, const Reached& at, Refills& refills, float beyond,
                           double before) const noexcept {
    const auto value_of = [&](double source) {
        if (source <= 0.0) return dry_;
        const float reach = static_cast<float>(source), inside = reach - at.distance;
        return inside >= 0.0f ? inside : inside * steepness(reach, static_cast<float>(parameters_.noise_strength));
    };
    const float whole = value_of(b.source);
    if (!clearing_.any()) return whole;
    // From the latest clearing back: what has flowed since each one, below all that came after it.
    float value = std::numeric_limits<float>::lowest(), limit = std::numeric_limits<float>::max();
    const auto matters = [&] { return limit > value && value < whole && limit > beyond; };
    clearing_.from_latest(at.vertex, [&](const Clearing::Cap& cap) {
        if (!(cap.time < before)) return true;
        if (matters()) {
            const double since = refilled(b, cap.time, refills);
            // Outside its reach a value is lower than this: the division is saved.
            if (static_cast<float>(since) - at.distance > beyond)
                value = std::max(value, std::min(value_of(since), limit));
            limit = std::min(limit, cap.cap);
        }
        if (cap.cap < whole) b.cleared = std::max(b.cleared, cap.time);
        return matters() || cap.time > b.cleared;
    });
    return std::max(value, std::min(whole, limit));
}

void BleedField::publish() noexcept {
    for (const std::uint32_t v : written_) {
        bool changes = false;
        for (const std::uint32_t copy : surface_.vertices_at(v)) {
            if (values_[copy] == surface_values_[v]) continue;
            values_[copy] = surface_values_[v];
            changed_.mark(copy);
            changes = true;
        }
        if (changes) amount_.mark(v);
    }
    written_.clear();
}

BloodAmount BleedField::amount() const noexcept {
    return amount_.measure(surface_values_, parameters_);
}

}  // namespace lapfx::bleeding
