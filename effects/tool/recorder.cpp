#include "tool/recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lapfx::tool {

namespace {

/// Number of samples of the path that are compared with the straight line: enough for a moving contact at 1 kHz; a
/// longer stay is thinned out evenly.
constexpr std::size_t most_points = 256;

bool usable(const ToolSample& s) {
    const glm::dvec3 size = glm::abs(s.position);
    // Comparisons are false for NaN.
    return std::abs(s.time) <= 1e7 && size.x <= 1e5 && size.y <= 1e5 && size.z <= 1e5 && s.power >= 0.0 &&
           std::isfinite(s.power) && s.strength >= 0.0 && std::isfinite(s.strength);
}

}  // namespace

void Recorder::set(std::span<const ToolContact> contacts) {
    const auto differ = std::mismatch(contacts.begin(), contacts.end(), contacts_.begin(), contacts_.end());
    same_ = std::min(same_, static_cast<std::size_t>(differ.first - contacts.begin()));
    shrunk_ = shrunk_ || differ.second != contacts_.end();
    contacts_.assign(contacts.begin(), contacts.end());
    running_ = any_ = false;
}

std::size_t Recorder::take_same() {
    shrunk_ = false;
    return std::exchange(same_, contacts_.size());
}

double Recorder::acting(double time) const {
    if (!running_) return time;
    const double end = contacts_.back().end();
    return time >= end && time - end <= longest_gap ? std::nextafter(end, contacts_.back().time) : time;
}

bool Recorder::add(const ToolSample& given) {
    if (!usable(given) || (any_ && given.time <= last_time_)) {
        ++dropped_;
        return false;
    }
    ToolSample sample = given;
    sample.power = std::min(sample.power, 1.0);
    const bool gap = any_ && sample.time - last_time_ > longest_gap;
    any_ = true;
    last_time_ = sample.time;
    if (gap) running_ = false;
    if (running_) {
        ToolContact& contact = contacts_.back();
        const bool same = sample.touching && sample.action == contact.action && sample.power == contact.power &&
                          sample.strength == contact.strength;
        if (same) {
            extend(sample);
            return true;
        }
        // The old action lasts until the sample with another action, at the place where the tip was last seen with the
        // old one.
        contact.duration = sample.time - contact.time;
        same_ = std::min(same_, contacts_.size() - 1);
        running_ = false;
    }
    if (sample.touching) begin(sample, {sample.time, sample.position});
    return true;
}

void Recorder::begin(const ToolSample& sample, const Point& from) {
    contacts_.push_back({.action = sample.action,
                         .time = from.time,
                         .duration = sample.time - from.time,
                         .position = from.position,
                         .to = sample.position,
                         .power = sample.power,
                         .strength = sample.strength});
    path_.assign(1, from);
    if (sample.time > from.time) path_.push_back({sample.time, sample.position});
    running_ = true;
}

void Recorder::extend(const ToolSample& sample) {
    const Point here{sample.time, sample.position};
    ToolContact& contact = contacts_.back();
    const bool moves = contact.to != contact.position || here.position != contact.position;
    if (!straight_to(here) || (moves && here.time - contact.time > longest_move)) {
        begin(sample, {contact.end(), contact.to});
        return;
    }
    same_ = std::min(same_, contacts_.size() - 1);
    contact.duration = here.time - contact.time;
    contact.to = here.position;
    if (path_.size() == most_points) {
        for (std::size_t i = 1; i < most_points / 2; ++i) path_[i] = path_[2 * i];
        path_.resize(most_points / 2);
    }
    path_.push_back(here);
}

bool Recorder::straight_to(const Point& end) const {
    const Point& start = path_.front();
    return std::all_of(path_.begin(), path_.end(), [&](const Point& p) {
        const double share = (p.time - start.time) / (end.time - start.time);
        return glm::distance(glm::mix(start.position, end.position, share), p.position) <= tolerance;
    });
}

}  // namespace lapfx::tool
