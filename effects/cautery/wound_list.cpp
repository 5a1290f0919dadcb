#include "cautery/wound_list.h"

#include <algorithm>
#include <tuple>

namespace lapfx::cautery {

bool opens_before(const Division& a, const Division& b) {
    const auto order = [](const Division& d) {
        const Wound& w = d.wound;
        return std::tuple(w.start, -w.strength, !d.by_heat, w.position.x, w.position.y, w.position.z, d.tip.x, d.tip.y,
                          d.tip.z);
    };
    return order(a) < order(b);
}

/// A wound stops when heat closes it or a clip seals it.
void WoundList::settle(std::uint32_t wound) {
    wounds_[wound].stop = std::min(beside_[wound].closed, wounds_[wound].sealed);
}

void WoundList::seal() {
    if (!sealed_at_) return;
    for (std::uint32_t i = 0; i < wounds_.size(); ++i) {
        wounds_[i].sealed = sealed_at_(wounds_[i].position);
        settle(i);
    }
}

bool WoundList::add(const Division& division, std::int64_t key) {
    const Wound& wound = division.wound;
    stands_for_ = none;
    if (!(wound.strength > 0.0)) return false;
    const glm::dvec3 reach(closest);
    grid_.find(wound.position - reach, wound.position + reach, near_);
    for (const std::uint32_t i : near_) {
        const Wound& other = wounds_[i];
        if (!(glm::distance(other.position, wound.position) < closest) || other.start > wound.start ||
            other.strength < wound.strength || wound.start >= other.stop)
            continue;
        stands_for_ = i;
        if (division.by_heat) {
            burnings_.push_back({key, i, beside_[i].burn});
            beside_[i].burn = {.time = wound.start, .tip = division.tip};
        }
        return false;
    }
    if (wounds_.size() == most) {
        left_out_.push_back(key);
        return false;
    }
    grid_.insert(static_cast<std::uint32_t>(wounds_.size()), wound.position, wound.position);
    wounds_.push_back(wound);
    beside_.push_back({.burn = division.by_heat ? Burn{.time = wound.start, .tip = division.tip} : Burn{},
                       .key = key,
                       .closed = wound.stop});
    if (sealed_at_) wounds_.back().sealed = sealed_at_(wound.position);
    settle(static_cast<std::uint32_t>(wounds_.size() - 1));
    ++version_;
    return true;
}

bool WoundList::close(std::uint32_t wound, double stop, std::int64_t key) {
    double& current = beside_[wound].closed;
    if (!(stop < current)) return false;
    closings_.push_back({key, wound, current});
    current = stop;
    settle(wound);
    ++version_;
    return true;
}

void WoundList::truncate(std::int64_t key) {
    while (!closings_.empty() && closings_.back().key >= key) {
        beside_[closings_.back().wound].closed = closings_.back().before;
        settle(closings_.back().wound);
        closings_.pop_back();
        ++version_;
    }
    while (!burnings_.empty() && burnings_.back().key >= key) {
        beside_[burnings_.back().wound].burn = burnings_.back().before;
        burnings_.pop_back();
    }
    while (!beside_.empty() && beside_.back().key >= key) {
        const glm::dvec3 place = wounds_.back().position;
        wounds_.pop_back();
        beside_.pop_back();
        grid_.remove(static_cast<std::uint32_t>(wounds_.size()), place, place);
        ++version_;
    }
    while (!left_out_.empty() && left_out_.back() >= key) left_out_.pop_back();
}

}  // namespace lapfx::cautery
