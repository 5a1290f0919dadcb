#include "cautery/bioheat.h"

#include <algorithm>
#include <cmath>

namespace lapfx::cautery {

namespace {

/// Radii of the tip beyond which its source, exp(-9), is left out.
constexpr double source_reach = 3.0;
constexpr std::size_t most_snapshots = 48;
/// Steps between two searches for points that have cooled.
constexpr std::int64_t cool_interval = 32;

double time_of(std::int64_t step) {
    return static_cast<double>(step) * Bioheat::step;
}
/// A time that differs from a step only by rounding counts as that step.
std::int64_t step_at_or_after(double time) {
    return static_cast<std::int64_t>(std::ceil(time / Bioheat::step - 1e-6));
}
/// Exact: which step a contact belongs to must not depend on rounding.
std::int64_t step_at_or_before(double time) {
    auto step = static_cast<std::int64_t>(std::floor(time / Bioheat::step));
    while (time_of(step) > time) --step;
    while (time_of(step + 1) <= time) ++step;
    return step;
}

/// The time at which a value passes `wanted`, when it goes from `before` to `after` in a step that begins at `from`.
double crossing(double before, double after, double wanted, double from) {
    return before >= wanted ? from : from + Bioheat::step * (wanted - before) / (after - before);
}

}  // namespace

Bioheat::Bioheat(const Surface& surface, const StrengthAt& strength_at, SealedAt sealed_at)
    : surface_(surface),
      strength_at_(strength_at),
      heat_(surface),
      peak_(surface.positions.size(), 0.0f),
      divided_(surface.positions.size(), 0.0f),
      recent_(most_undone),
      wounds_(std::move(sealed_at)),
      is_touched_(surface.positions.size(), false),
      is_changed_(surface.positions.size(), false) {}

void Bioheat::reset(const CauteryParameters& parameters) {
    parameters_ = parameters;
    heat_.clear();
    forget_marks();
    pending_.clear();
    snapshots_.clear();
    interval_ = 64;
    started_ = false;
    can_undo_ = 0;
    furthest_ = std::numeric_limits<std::int64_t>::min();
    wounds_.truncate(std::numeric_limits<std::int64_t>::min());
}

void Bioheat::changed_from(double time) {
    if (time == never) return;
    const std::int64_t sound = step_at_or_before(time);
    std::erase_if(snapshots_, [&](const Snapshot& s) { return s.step > sound; });
    if (started_ && step_ > sound) go_back(sound);
    if (furthest_ > sound) {
        furthest_ = sound;
        wounds_.truncate(sound + 1);
    }
}

void Bioheat::seek(const Track& track, double time) {
    at_ = time = std::clamp(time, -2e7, 2e7);  // farther away than any contact
    const auto stays = track.stays();
    if (surface_.triangles.empty() || stays.empty()) return;
    const std::int64_t wanted = step_at_or_after(time);
    const std::int64_t first = step_at_or_before(stays.front().contact.time);
    if (started_ && wanted < step_) go_back(wanted);
    if (!started_) {
        if (wanted <= first) return;
        step_ = first;
        furthest_ = std::max(furthest_, first);
        started_ = true;
    }
    const auto later =
        std::find_if(snapshots_.rbegin(), snapshots_.rend(), [&](const Snapshot& s) { return s.step <= wanted; });
    if (later != snapshots_.rend() && later->step > step_) restore(*later);
    while (step_ < wanted) {
        find_running(track, time_of(step_), time_of(step_ + 1));
        if (!heat_.field().points.empty() && cold_at(track, time_of(step_))) heat_.clear();
        if (heat_.field().points.empty() && running_.empty()) {
            // Nothing is warm and no contact runs: go to the next contact.
            const double now = time_of(step_);
            const auto next =
                std::partition_point(stays.begin(), stays.end(), [&](const Stay& s) { return s.contact.time < now; });
            const std::int64_t idle =
                next == stays.end() ? wanted : std::min(wanted, step_at_or_before(next->contact.time));
            pending_.clear();
            step_ = std::max(idle, step_ + 1);
            can_undo_ = 0;
            furthest_ = std::max(furthest_, step_);
            continue;
        }
        advance(track);
    }
}

void Bioheat::go_back(std::int64_t to) {
    if (to < step_ && step_ - to <= can_undo_) {
        can_undo_ -= step_ - to;
        while (step_ > to) {
            const Snapshot& before = recent(--step_);
            for (auto mark = before.marks.rbegin(); mark != before.marks.rend(); ++mark)
                set_mark(mark->point, mark->peak, mark->divided);
        }
        heat_.restore(recent(step_).field);
        pending_ = recent(step_).pending;
        return;
    }
    can_undo_ = 0;
    const auto before =
        std::find_if(snapshots_.rbegin(), snapshots_.rend(), [&](const Snapshot& s) { return s.step <= to; });
    if (before != snapshots_.rend()) {
        restore(*before);
        return;
    }
    heat_.clear();
    forget_marks();
    pending_.clear();
    started_ = false;
}

void Bioheat::restore(const Snapshot& snapshot) {
    heat_.restore(snapshot.field);
    forget_marks();
    for (const Mark& mark : snapshot.marks) set_mark(mark.point, mark.peak, mark.divided);
    pending_ = snapshot.pending;
    step_ = snapshot.step;
    can_undo_ = 0;
}

void Bioheat::keep_snapshot() {
    if (step_ % interval_ != 0) return;
    const auto at =
        std::partition_point(snapshots_.begin(), snapshots_.end(), [&](const Snapshot& s) { return s.step < step_; });
    if (at != snapshots_.end() && at->step == step_) return;
    Snapshot kept{.step = step_, .field = heat_.field(), .marks = {}, .pending = pending_};
    kept.marks.reserve(touched_.size());
    for (const std::uint32_t p : touched_) kept.marks.push_back({p, peak_[p], divided_[p]});
    snapshots_.insert(at, std::move(kept));
    while (snapshots_.size() > most_snapshots) {
        interval_ *= 2;
        std::erase_if(snapshots_, [&](const Snapshot& s) { return s.step % interval_ != 0; });
    }
}

void Bioheat::forget_marks() {
    for (const std::uint32_t p : touched_) {
        set_mark(p, 0.0f, 0.0f);
        is_touched_[p] = false;
    }
    touched_.clear();
}

void Bioheat::set_mark(std::uint32_t point, float peak, float divided) {
    if (peak_[point] == peak && divided_[point] == divided) return;
    if (!is_touched_[point]) {
        is_touched_[point] = true;
        touched_.push_back(point);
    }
    peak_[point] = peak;
    divided_[point] = divided;
    if (is_changed_[point]) return;
    is_changed_[point] = true;
    changed_.push_back(point);
}

void Bioheat::take_changed() {
    for (const std::uint32_t p : changed_) is_changed_[p] = false;
    changed_.clear();
}

/// Whether the last heating is so long ago that its remaining heat is negligible.
bool Bioheat::cold_at(const Track& track, double time) const {
    const auto stays = track.stays();
    const auto later =
        std::partition_point(stays.begin(), stays.end(), [&](const Stay& s) { return s.contact.time <= time; });
    return later == stays.begin() || time - (later - 1)->latest_hot > forgotten;
}

/// The contacts that run during a step, and where their tips are in the middle of their share of it.
void Bioheat::find_running(const Track& track, double from, double to) {
    const auto stays = track.stays();
    running_.clear();
    auto i = std::partition_point(stays.begin(), stays.end(), [&](const Stay& s) { return s.contact.time < to; });
    while (i != stays.begin() && (i - 1)->latest_end >= from) {
        --i;
        const ToolContact& contact = i->contact;
        if (contact.end() < from) continue;
        const double middle = 0.5 * (std::max(from, contact.time) + std::min(to, contact.end()));
        running_.push_back({static_cast<std::uint32_t>(i - stays.begin()), contact.tip(middle)});
    }
    std::reverse(running_.begin(), running_.end());
}

void Bioheat::advance(const Track& track) {
    const double from = time_of(step_), to = time_of(step_ + 1);
    Snapshot& before = recent(step_);
    before.field = heat_.field();
    before.pending = pending_;
    before.marks.clear();
    can_undo_ = std::min(can_undo_ + 1, most_undone);
    if (step_ % cool_interval == 0) heat_.drop_cool();
    ++step_;
    opened_.clear();
    for (const Running& running : running_) {
        const Stay& stay = track.stays()[running.stay];
        if (cold(stay.contact.action)) open_cold(stay, track, from, to);
        if (!stay.contact.hot()) continue;
        heat_under(stay, running.tip, from, to);
        if (divides(stay.contact.action) && stay.contact.time >= from && stay.contact.time < to)
            for (std::uint32_t p = stay.first_place; p < stay.end_place; ++p) pending_.push_back({p, running.stay});
    }
    heat_.step(step, parameters_.diffusivity, parameters_.perfusion);
    record_peaks();
    divide(track, from);
    if (step_ > furthest_) {
        std::sort(opened_.begin(), opened_.end(), opens_before);
        // A wound that is closed in a step does not count for one that opens in it, which can be closed in the next
        // step.
        close_wounds(track, from);
        for (const Division& division : opened_) wounds_.add(division, step_);
        furthest_ = step_;
    }
    keep_snapshot();
}

void Bioheat::heat_under(const Stay& stay, const glm::dvec3& tip, double from, double to) {
    const double share = (std::min(to, stay.contact.end()) - std::max(from, stay.contact.time)) / step;
    const double rate = rise_rate(stay.contact, parameters_) * share;
    if (!(rate > 0.0)) return;
    const SurfacePoint centre = surface_.closest_point(tip);
    if (!(centre.distance <= farthest_touch)) return;
    // Gentle heat holds its temperature: it heats only while the tissue under it is below.
    if (row_of(stay.contact.action).gentle && heat_.rise_at(centre, heat_.field().now) >= gentle_rise(parameters_))
        return;
    surface_.points_within(centre.position, source_reach * parameters_.tip_radius, near_);
    for (const std::uint32_t p : near_) {
        const double r = glm::distance(surface_.positions[p], centre.position) / parameters_.tip_radius;
        heat_.heat(p, rate * std::exp(-r * r));
    }
}

void Bioheat::record_peaks() {
    const Diffusion::Field& field = heat_.field();
    for (std::size_t i = 0; i < field.points.size(); ++i) {
        const std::uint32_t p = field.points[i];
        const auto rise = static_cast<float>(field.now[i]);
        if (!(rise > peak_[p])) continue;
        recent(step_ - 1).marks.push_back({p, peak_[p], divided_[p]});
        set_mark(p, rise, divided_[p]);
    }
}

/// Opens wounds at places under the tips that have become hot enough.
void Bioheat::divide(const Track& track, double from) {
    const double wanted = parameters_.cut_temperature - body_temperature;
    if (wanted > highest_rise(parameters_)) pending_.clear();
    std::size_t kept = 0;
    for (const Pending& pending : pending_) {
        const Place& place = track.places()[pending.place];
        const std::uint32_t chain = track.stays()[pending.stay].chain;
        const Running* tip = nullptr;
        for (const Running& running : running_)
            if (track.stays()[running.stay].chain == chain) tip = &running;
        if (!tip) continue;
        const bool under = glm::distance(tip->tip, place.tip) <= parameters_.tip_radius;
        if (!under && place.arrival < from) continue;
        const double after = under ? heat_.rise_at(place.point, heat_.field().now) : 0.0;
        if (!under || !(after >= wanted) || place.arrival > from + step) {
            pending_[kept++] = pending;
            continue;
        }
        const double before = heat_.rise_at(place.point, heat_.field().before);
        const ToolContact& contact = track.stays()[pending.stay].contact;
        surface_.points_within(place.point.position, parameters_.tip_radius, near_);
        for (const std::uint32_t p : near_) {
            const auto divided = static_cast<float>(
                divided_at(glm::distance(surface_.positions[p], place.point.position), contact.action, parameters_));
            if (!(divided > divided_[p])) continue;
            recent(step_ - 1).marks.push_back({p, peak_[p], divided_[p]});
            set_mark(p, peak_[p], divided);
        }
        if (!place.wound || step_ <= furthest_) continue;
        const double start = std::max(crossing(before, after, wanted, from), place.arrival);
        opened_.push_back({.wound = {.position = place.point.position,
                                     .start = start,
                                     .strength = wound_strength(contact, place.point.position, strength_at_)},
                           .tip = track.stays()[tip->stay].contact.tip(start),
                           .by_heat = true});
    }
    pending_.resize(kept);
}

void Bioheat::open_cold(const Stay& stay, const Track& track, double from, double to) {
    if (step_ <= furthest_) return;
    const auto places = track.places_of(stay);
    auto place = std::partition_point(places.begin(), places.end(), [&](const Place& p) { return p.arrival < from; });
    for (; place != places.end() && place->arrival < to; ++place)
        if (place->wound)
            opened_.push_back({.wound = {.position = place->point.position,
                                         .start = place->arrival,
                                         .strength = wound_strength(stay.contact, place->point.position, strength_at_)},
                               .tip = place->tip});
}

void Bioheat::close_wounds(const Track& track, double from) {
    const double wanted = parameters_.coagulation_temperature - body_temperature;
    const double cut = parameters_.cut_temperature - body_temperature;
    if (wanted > highest_rise(parameters_)) return;
    const glm::dvec3 reach(source_reach * parameters_.tip_radius + wound_spacing);
    for (const Running& running : running_) {
        const Stay& stay = track.stays()[running.stay];
        if (!stay.contact.hot() || !(rise_rate(stay.contact, parameters_) > 0.0)) continue;
        wounds_.find(running.tip - reach, running.tip + reach, near_);
        for (const std::uint32_t w : near_) {
            const Wound wound = wounds_.wounds()[w];
            if (wounds_.is_closed(w) || track.has_divided(stay, wounds_.burn_of(w), parameters_.tip_radius)) continue;
            const SurfacePoint place = surface_.closest_point(wound.position);
            const double after = heat_.rise_at(place, heat_.field().now);
            if (!(after >= wanted)) continue;
            // Tissue that is hot enough to part does not close.
            if (after >= cut && cut <= highest_rise(parameters_)) continue;
            const double before = heat_.rise_at(place, heat_.field().before);
            const double closed = std::max(crossing(before, after, wanted, from), stay.contact.time);
            wounds_.close(w, std::max(closed, wound.start), step_);
        }
    }
}

double Bioheat::peak(std::uint32_t point) const {
    return peak_[point];
}

double Bioheat::temperature(const SurfacePoint& place) const {
    if (!started_) return body_temperature;
    const double share = std::clamp((at_ - time_of(step_ - 1)) / step, 0.0, 1.0);
    const double before = heat_.rise_at(place, heat_.field().before), now = heat_.rise_at(place, heat_.field().now);
    return body_temperature + std::clamp(glm::mix(before, now, share), 0.0, highest_rise(parameters_));
}

}  // namespace lapfx::cautery
