#include "cautery/wound_list.h"

#include <algorithm>

namespace lapfx::cautery {

double WoundList::closed_at(const Wound& wound) const {
    return sealed_at_ ? std::min(wound.stop, sealed_at_(wound.position)) : wound.stop;
}

bool WoundList::add(const Division& division, std::int64_t key) {
    const Wound& wound = division.wound;
    if (!(wound.strength > 0.0)) return false;
    const glm::dvec3 reach(closest);
    grid_.find(wound.position - reach, wound.position + reach, near_);
    for (const std::uint32_t i : near_) {
        const Wound& other = wounds_[i];
        if (!(glm::distance(other.position, wound.position) < closest) || other.start > wound.start ||
            other.strength < wound.strength || wound.start >= closed_at(other))
            continue;
        if (division.by_heat && chains_[i] != division.chain) {
            takings_.push_back({key, i, chains_[i]});
            chains_[i] = division.chain;
        }
        return false;
    }
    if (wounds_.size() == most) {
        left_out_.push_back(key);
        return false;
    }
    grid_.insert(static_cast<std::uint32_t>(wounds_.size()), wound.position, wound.position);
    wounds_.push_back(wound);
    chains_.push_back(division.chain);
    added_.push_back(key);
    ++version_;
    return true;
}

bool WoundList::close(std::uint32_t wound, double stop, const Heater& heater, std::int64_t key) {
    if (heater.divides && chains_[wound] == heater.chain) return false;
    double& current = wounds_[wound].stop;
    if (!(stop < current)) return false;
    closings_.push_back({key, wound, current});
    current = stop;
    ++version_;
    return true;
}

void WoundList::truncate(std::int64_t key) {
    while (!closings_.empty() && closings_.back().key >= key) {
        wounds_[closings_.back().wound].stop = closings_.back().before;
        closings_.pop_back();
        ++version_;
    }
    while (!takings_.empty() && takings_.back().key >= key) {
        chains_[takings_.back().wound] = takings_.back().before;
        takings_.pop_back();
    }
    while (!added_.empty() && added_.back() >= key) {
        const glm::dvec3 place = wounds_.back().position;
        wounds_.pop_back();
        chains_.pop_back();
        added_.pop_back();
        grid_.remove(static_cast<std::uint32_t>(wounds_.size()), place, place);
        ++version_;
    }
    while (!left_out_.empty() && left_out_.back() >= key) left_out_.pop_back();
}

}  // namespace lapfx::cautery
