#include "bleeding/clearing_cpu.h"

#include <algorithm>
#include <cmath>

namespace lapfx::bleeding {

namespace {

constexpr double draw_speed =
    40.0;  // mm/s at which blood is drawn to a suction tip, and rinsed away from an irrigating one

bool clears(const ToolContact& c) {
    if (c.action != ToolAction::suction && c.action != ToolAction::irrigation) return false;
    const double numbers[] = {c.time, c.duration, c.position.x, c.position.y, c.position.z, c.to.x, c.to.y, c.to.z};
    return std::all_of(std::begin(numbers), std::end(numbers), [](double n) { return std::isfinite(n); }) &&
           c.duration > 0.0;
}

bool same(const ToolContact& a, const ToolContact& b) {
    return a.action == b.action && a.time == b.time && a.duration == b.duration && a.position == b.position &&
           a.to == b.to;
}

}  // namespace

Clearing::Clearing(const Surface& surface, glm::dvec3 down) : surface_(surface), down_(down) {}

Clearing::Sweep Clearing::sweep_of(const ToolContact& contact) const {
    const bool water = contact.action == ToolAction::irrigation;
    const double radius = water ? irrigation_radius_ : suction_radius_;
    const glm::dvec3 path = contact.to - contact.position;
    const double length_squared = glm::dot(path, path);
    Sweep sweep{.contact = contact, .cleared = {}};
    for (const std::uint32_t v : surface_.points_near(contact.position, contact.to, water ? 1.5 * radius : radius)) {
        const glm::dvec3 from = surface_.positions[v] - contact.position;
        // Share of the path nearest to the vertex, and how far the reach goes along the path to both sides of it.
        const double share = length_squared > 0.0 ? std::clamp(glm::dot(from, path) / length_squared, 0.0, 1.0) : 0.0;
        const glm::dvec3 off = from - share * path;
        const double distance = glm::length(off);
        const double reach =
            water ? radius * (1.0 + 0.5 * std::max(0.0, glm::dot(off, down_)) / std::max(distance, 1e-9)) : radius;
        if (distance > reach) continue;
        const double half =
            length_squared > 0.0 ? std::sqrt((reach * reach - distance * distance) / length_squared) : 1.0;
        const double enters = contact.time + std::max(0.0, share - half) * contact.duration;
        const double leaves = contact.time + std::min(1.0, share + half) * contact.duration;
        const double first = enters + distance / draw_speed;
        if (first < leaves) sweep.cleared.push_back({v, first, leaves});
    }
    return sweep;
}

bool Clearing::set(std::span<const ToolContact> contacts, const BleedingParameters& parameters) {
    const bool same_reach =
        suction_radius_ == parameters.suction_radius && irrigation_radius_ == parameters.irrigation_radius;
    suction_radius_ = parameters.suction_radius;
    irrigation_radius_ = parameters.irrigation_radius;
    std::size_t count = 0;
    bool changed = false;
    for (const ToolContact& contact : contacts) {
        if (!clears(contact)) continue;
        if (count < sweeps_.size() && same_reach && same(sweeps_[count].contact, contact)) {
            ++count;
            continue;
        }
        changed = true;
        // Nothing of the old sweep may stay behind: its vertices are put back first.
        if (count < sweeps_.size()) {
            for (const Cleared& c : sweeps_[count].cleared) last_[c.vertex] = never;
            sweeps_[count] = sweep_of(contact);
        } else {
            sweeps_.push_back(sweep_of(contact));
        }
        ++count;
    }
    for (std::size_t i = count; i < sweeps_.size(); ++i) {
        changed = true;
        for (const Cleared& c : sweeps_[i].cleared) last_[c.vertex] = never;
    }
    sweeps_.resize(count);
    if (!sweeps_.empty() && last_.empty()) last_.assign(surface_.positions.size(), never);
    stale_ = stale_ || changed;
    return changed;
}

bool Clearing::update(double time) noexcept {
    const auto touched = [&](const Sweep& s) {  // between the two times
        return std::min(time, updated_) < s.contact.end() && std::max(time, updated_) > s.contact.time;
    };
    const bool changes = stale_ || (time != updated_ && std::any_of(sweeps_.begin(), sweeps_.end(), touched));
    updated_ = time;
    if (!changes) return false;
    stale_ = false;
    latest_ = never;
    for (const Sweep& sweep : sweeps_)
        for (const Cleared& c : sweep.cleared) last_[c.vertex] = never;
    for (const Sweep& sweep : sweeps_)
        for (const Cleared& c : sweep.cleared)
            if (time > c.first) {
                last_[c.vertex] = std::max(last_[c.vertex], std::min(time, c.last));
                latest_ = std::max(latest_, last_[c.vertex]);
            }
    return true;
}

}  // namespace lapfx::bleeding
