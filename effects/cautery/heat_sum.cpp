#include "cautery/heat_sum.h"

#include <algorithm>
#include <cmath>

namespace lapfx::cautery {

HeatSum::State HeatSum::HeatPiece::at(double time, const Constants& constants) const {
    const double passed = std::clamp(time, from, to) - from;
    const double left = std::exp(-passed / constants.cooling_time);
    return {aim + (start.rise - aim) * left, heated ? start.stayed + passed : start.stayed * left};
}

HeatSum::HeatPiece HeatSum::HeatPiece::between(double first, double last, const Constants& constants) const {
    HeatPiece part = *this;
    part.start = at(first, constants);
    part.from = first;
    part.to = last;
    return part;
}

double HeatSum::HeatPiece::when(double wanted, bool falls, const Constants& constants) const {
    if (falls ? start.rise <= wanted : start.rise >= wanted) return from;
    if (falls ? !(aim < wanted) : !(aim > wanted)) return never;
    const double time = from + constants.cooling_time * std::log((aim - start.rise) / (aim - wanted));
    return time <= to ? time : never;
}

void HeatSum::add(std::span<const Source> sources, const Constants& constants) {
    double from = never;
    for (const Source& source : sources) {
        from = std::min(from, source.from);
        sources_.push_back(source);
    }
    if (from < never) rebuild(from, constants);
}

void HeatSum::remove_from(std::uint32_t contact, const Constants& constants) {
    double from = never;
    while (!sources_.empty() && sources_.back().contact >= contact) {
        from = std::min(from, sources_.back().from);
        sources_.pop_back();
    }
    if (from < never) rebuild(from, constants);
}

/// Makes the parts from this time on again.
void HeatSum::rebuild(double from, const Constants& constants) {
    while (!parts_.empty() && parts_.back().from >= from) parts_.pop_back();
    // Back to where the sources last changed, so that the result does not depend on what was there before.
    while (!parts_.empty() && !parts_.back().sources_change) parts_.pop_back();
    if (!parts_.empty()) {
        from = parts_.back().from;
        parts_.pop_back();
    }
    if (parts_.empty()) {
        from = never;
        for (const Source& s : sources_) from = std::min(from, s.from);
    }
    if (sources_.empty()) return;
    std::vector<const Source*> coming, near;
    std::vector<double> ends{from};
    for (const Source& s : sources_) {
        if (!(s.to > from)) continue;
        coming.push_back(&s);
        ends.push_back(std::max(s.from, from));
        ends.push_back(s.to);
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    ends.push_back(never);
    std::stable_sort(coming.begin(), coming.end(), [](const Source* a, const Source* b) { return a->from < b->from; });
    auto next = coming.begin();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        std::erase_if(near, [&](const Source* s) { return !(s->to > ends[i]); });
        // In the order of contacts, so that a sum is always added up alike.
        for (; next != coming.end() && (*next)->from <= ends[i]; ++next)
            near.insert(std::upper_bound(near.begin(), near.end(), *next), *next);
        double steady = 0.0, gentle = 0.0;
        for (const Source* s : near) (s->gentle ? gentle : steady) += s->rate;
        add_parts(ends[i], ends[i + 1], steady, gentle, constants);
    }
}

/// Parts of a time in which the same tools are near: U rises by all up to the top of the gentle ones, stays there if
/// the others do not hold it higher, or falls to it.
void HeatSum::add_parts(double from, double to, double steady, double gentle, const Constants& constants) {
    const double top = constants.gentle_top, low = steady * constants.cooling_time;
    const double high = (steady + gentle) * constants.cooling_time;
    HeatPiece part{.from = from, .to = to, .start = {}, .aim = high};
    part.heated = steady > 0.0 || gentle > 0.0;
    part.sources_change = true;
    if (!parts_.empty()) part.start = parts_.back().at(from, constants);
    const auto next = [&](double time, double aim) {
        const State start = part.at(time, constants);
        part.to = time;
        if (part.from < time) parts_.push_back(part);
        part = {
            .from = time, .to = to, .start = start, .aim = aim, .heated = part.heated, .sources_change = time == from};
    };
    if (gentle > 0.0) {
        const bool above = part.start.rise > top;
        if (above) part.aim = low;
        const double met = part.start.rise == top ? from : part.when(top, above, constants);
        if (met < to) {
            // At the top: held there where the gentle tools are both needed and enough.
            next(met, above ? std::min(top, high) : std::max(std::min(top, high), low));
            if (part.aim == top) part.start.rise = top;
        }
    }
    parts_.push_back(part);
}

std::size_t HeatSum::part_at(double time) const {
    const auto after = std::upper_bound(parts_.begin(), parts_.end(), time,
                                        [](double t, const HeatPiece& part) { return t < part.from; });
    return after == parts_.begin() ? parts_.size() : static_cast<std::size_t>(after - parts_.begin()) - 1;
}

HeatSum::State HeatSum::at(double time, const Constants& constants) const {
    const std::size_t part = part_at(time);
    return part < parts_.size() ? parts_[part].at(time, constants) : State{};
}

double HeatSum::reaches(double wanted, double from, double to, const Constants& constants) const {
    std::size_t i = part_at(from);
    if (i == parts_.size()) i = 0;
    for (; i < parts_.size() && parts_[i].from <= to; ++i) {
        const HeatPiece part = parts_[i].between(std::max(from, parts_[i].from), std::min(to, parts_[i].to), constants);
        if (const double time = part.when(wanted, false, constants); time < never) return time;
    }
    return never;
}

}  // namespace lapfx::cautery
