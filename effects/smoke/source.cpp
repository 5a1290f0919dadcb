// Finds where the smoke of a file starts: decoding and keying for find_source.h.
#include <algorithm>

#include "lapfx/authoring/keying.h"
#include "lapfx/authoring/suggest.h"
#include "smoke/find_source.h"

namespace lapfx {

namespace {

constexpr int cells_high = 48;
constexpr int looked_at = 16;      // pictures over the whole clip
constexpr double a_moment = 0.12;  // s, in which smoke moves by a few cells
constexpr int at_first = 24;       // pictures of the beginning
constexpr double beginning = 2.5;  // s: smoke that comes later was cut in

smoke::OpacityGrid reduced(const std::vector<float>& opacity, glm::ivec2 size) {
    const int high = std::min(cells_high, size.y);
    const int wide = std::clamp(high * size.x / size.y, 1, size.x);
    smoke::OpacityGrid grid{{wide, high}, std::vector<float>(static_cast<std::size_t>(wide * high))};
    std::vector<int> counts(grid.cells.size());
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto cell = static_cast<std::size_t>(static_cast<long>(y) * high / size.y * wide +
                                                       static_cast<long>(x) * wide / size.x);
            grid.cells[cell] +=
                opacity[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
            ++counts[cell];
        }
    for (std::size_t i = 0; i < counts.size(); ++i) grid.cells[i] /= static_cast<float>(std::max(counts[i], 1));
    return grid;
}

}  // namespace

SourceSuggestion suggest_source(const std::filesystem::path& file, const std::atomic<bool>* stop) {
    SmokeClip clip;
    suggest_keying(file, stop).apply(clip);
    clip.edge_fade = 0.0;  // the fade is for drawing: smoke that enters at an edge starts there
    KeyingReader reader(file, stop);
    KeyingFrame frame;
    std::vector<float> opacity;
    const auto read = [&](double time, std::vector<smoke::OpacityGrid>& into) {
        reader.read(reader.frame_at(time), frame, stop);
        keyed_opacity(frame, clip.keying, clip, opacity);
        into.push_back(reduced(opacity, frame.size));
    };
    std::vector<smoke::OpacityGrid> pictures, later, first;
    const double duration = reader.report().duration;
    for (int i = 0; i < at_first; ++i) read(std::min(beginning, duration) * i / at_first, first);
    for (int i = 0; i < looked_at; ++i) {
        const double time = duration * (i + 0.5) / looked_at;
        read(time, pictures);
        read(std::min(time + a_moment, duration), later);
    }
    const smoke::FoundSource found = smoke::find_source(pictures, later, first);
    return {.place = found.place, .found = found.found, .begins = found.begins};
}

}  // namespace lapfx
