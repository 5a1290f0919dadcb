#include "bleeding/clearing.h"

#include <algorithm>
#include <cmath>

#include "lapfx/parameter.h"

namespace lapfx::bleeding {

namespace {

constexpr double held_on = 0.1;      // s after its end within which a contact may continue (tool/recorder.h)
constexpr double draw_speed = 40.0;  // mm/s at which the reach grows when the tip starts

/// Vector from `point` to the nearest place of the path from a to b.
glm::dvec3 off_path(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 path = b - a, from = point - a;
    const double squared = glm::dot(path, path);
    return from - (squared > 0.0 ? std::clamp(glm::dot(from, path) / squared, 0.0, 1.0) : 0.0) * path;
}

std::array<double, tool_action_count> reaches_of(const BleedingParameters& parameters) {
    std::array<double, tool_action_count> reaches{};
    for (std::size_t i = 0; i < reaches.size(); ++i)
        if (tool_actions[i].clears != nullptr) reaches[i] = parameters.*tool_actions[i].clears;
    return reaches;
}

}  // namespace

Clearing::Clearing(const Surface& surface, glm::dvec3 down)
    : surface_(surface), down_(down), reaches_(reaches_of(BleedingParameters{})) {
    for (Layer* layer : {&over_, &running_}) layer->heads = organ::Zeroed<std::uint32_t>(surface.positions.size());
}

Clearing::Sweep Clearing::sweep_of(const ToolContact& contact, std::size_t piece) const {
    const bool water = row_of(contact.action).rinses;
    Sweep sweep{
        .contact = contact, .piece = piece, .reach = reaches_[static_cast<std::size_t>(contact.action)], .passed = {}};
    const glm::dvec3 path = contact.to - contact.position;
    const double squared = glm::dot(path, path), farthest = (water ? 1.5 : 1.0) * sweep.reach + rim;
    for (const std::uint32_t v : surface_.points_near(contact.position, contact.to, farthest)) {
        const glm::dvec3 off = off_path(surface_.positions[v], contact.position, contact.to);
        const double distance = glm::length(off);
        const double downhill = water ? std::max(0.0, glm::dot(off, down_)) / std::max(distance, 1e-9) : 0.0;
        const double stretch = 1.0 + 0.5 * downhill, zone = stretch * sweep.reach + rim;
        if (distance > zone) continue;
        // Shares of the path between which the tip is within the zone.
        const double share = squared > 0.0 ? glm::dot(surface_.positions[v] - contact.position, path) / squared : 0.0;
        const double half = squared > 0.0 ? std::sqrt((zone * zone - distance * distance) / squared) : 1.0;
        const double enter = std::clamp(share - half, 0.0, 1.0), leave = std::clamp(share + half, 0.0, 1.0);
        sweep.passed.push_back({v, static_cast<float>(stretch), contact.time + enter * contact.duration,
                                contact.time + leave * contact.duration});
    }
    return sweep;
}

void Clearing::set_parameters(const BleedingParameters& parameters, unsigned changed) {
    if ((changed & redo::clearing) == 0) return;
    reaches_ = reaches_of(parameters);
    reader_.forget();
}

bool Clearing::set(const tool::Log& log) {
    const std::size_t first = reader_.take(log);
    bool changed = false;
    for (; !sweeps_.empty() && sweeps_.back().piece >= first; sweeps_.pop_back()) {
        all_stale_ = all_stale_ || sweeps_.back().is_over;
        changed = true;
    }
    for (std::size_t i = first; i < log.pieces().size(); ++i) {
        const ToolContact& contact = log.pieces()[i].contact;
        if (row_of(contact.action).clears == nullptr || !(contact.duration > 0.0)) continue;
        sweeps_.push_back(sweep_of(contact, i));
        const double before = sweeps_.size() > 1 ? sweeps_[sweeps_.size() - 2].latest_end : contact.end();
        sweeps_.back().latest_end = std::max(before, contact.end());
        stale_from_ = std::min(stale_from_, contact.time);
        changed = true;
    }
    stale_ = stale_ || changed;
    return changed;
}

/// The time from which nothing changes a sweep. The last one may be growing: it then ends about now, and its next piece
/// replaces it.
double Clearing::over_at(const Sweep& sweep) const noexcept {
    return sweep.contact.end() + (&sweep == &sweeps_.back() ? held_on : 0.0);
}

/// A range of sweeps that includes all that start before `to` and have not ended by `from`.
std::span<Clearing::Sweep> Clearing::between(double from, double to) noexcept {
    const auto end =
        std::partition_point(sweeps_.begin(), sweeps_.end(), [&](const Sweep& s) { return s.contact.time < to; });
    auto begin = end;
    while (begin != sweeps_.begin() && (begin - 1)->latest_end + held_on > from) --begin;
    return {begin, end};
}

double Clearing::unfinished_since() const noexcept {
    double since = stale_from_;
    for (auto s = sweeps_.rbegin(); s != sweeps_.rend() && s->latest_end + held_on > updated_; ++s)
        if (!s->is_over) since = std::min(since, s->contact.time);
    return since;
}

bool Clearing::update(double time) noexcept {
    const double before = std::min(time, updated_), after = std::max(time, updated_);
    const std::span<const Sweep> reached = between(before, after);
    const bool changes =
        stale_ || (time != updated_ &&
                   std::any_of(reached.begin(), reached.end(), [&](const Sweep& s) { return before < over_at(s); }));
    if (time < updated_) all_stale_ = all_stale_ || changes;
    updated_ = time;
    changed_.clear();
    anew_ = all_stale_;
    if (!changes) return anew_ = false;
    changed_ = running_.vertices;
    running_.clear();
    if (all_stale_) {
        over_.clear();
        for (Sweep& sweep : sweeps_) sweep.is_over = false;
    }
    constexpr double ever = std::numeric_limits<double>::infinity();
    for (Sweep& sweep : between(all_stale_ ? -ever : std::min(before, stale_from_), time)) {
        if (sweep.is_over) continue;
        sweep.is_over = time >= over_at(sweep);
        lay(sweep, time, sweep.is_over ? over_ : running_);
    }
    stale_ = all_stale_ = false;
    stale_from_ = ever;
    return true;
}

void Clearing::lay(const Sweep& sweep, double time, Layer& layer) {
    const ToolContact& c = sweep.contact;
    const double held = std::min(time, c.end()) - c.time;
    const double drawn = std::min(1.0, held * draw_speed / std::max(sweep.reach, 1e-9));
    const glm::dvec3 tip = c.tip(time);
    for (const Passed& p : sweep.passed) {
        if (time <= p.enter) continue;
        const double distance = glm::length(off_path(surface_.positions[p.vertex], c.position, tip));
        const double outside = distance - drawn * static_cast<double>(p.stretch) * sweep.reach;
        if (outside > rim) continue;
        const double until = std::min(time, p.leave);
        layer.insert(p.vertex, until, static_cast<float>(cap_slope * outside));
        changed_.push_back(p.vertex);
    }
}

void Clearing::Layer::clear() noexcept {
    for (const std::uint32_t v : vertices) heads[v] = 0;
    vertices.clear();
    caps.clear();
}

/// Keeps the list of a vertex from the latest back, with falling caps: a cap is dropped when a later one is not above
/// it.
void Clearing::Layer::insert(std::uint32_t vertex, double time, float cap) {
    std::uint32_t* link = &heads[vertex];
    if (*link == 0) vertices.push_back(vertex);
    for (; *link != 0 && caps[*link - 1].time > time; link = &caps[*link - 1].next)
        if (cap >= caps[*link - 1].cap) return;
    std::uint32_t before = *link, free = 0;  // free: a link to a dropped one
    for (; before != 0 && caps[before - 1].cap >= cap; before = caps[before - 1].next) free = before;
    const std::uint32_t at = free != 0 ? free : static_cast<std::uint32_t>(caps.size()) + 1;
    *link = at;  // before the list grows, because the link may be inside it
    if (free == 0) caps.emplace_back();
    caps[at - 1] = {time, cap, before};
}

}  // namespace lapfx::bleeding
