#include "match/explain/strokes.h"

#include <algorithm>
#include <numeric>

#include "lapfx/authoring/strokes.h"

namespace lapfx::match {

std::vector<std::vector<std::size_t>> strokes_of(std::span<const ToolContact> events,
                                                 bool (*counts)(const ToolContact& contact)) {
    std::vector<std::size_t> order(events.size()), stroke_of(events.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return events[a].time < events[b].time; });
    std::vector<std::vector<std::size_t>> strokes;
    std::vector<char> continued(order.size(), 0);
    for (std::size_t n = 0; n < order.size(); ++n) {
        if (!counts(events[order[n]])) continue;
        const auto before = goes_on_from(
            n, [&](std::size_t i) -> const ToolContact& { return events[order[i]]; },
            [&](std::size_t i) { return continued[i] != 0; });
        stroke_of[n] = before ? stroke_of[*before] : strokes.size();
        if (before)
            continued[*before] = 1;
        else
            strokes.emplace_back();
        strokes[stroke_of[n]].push_back(order[n]);
    }
    return strokes;
}

}  // namespace lapfx::match
