#include "smoke/suggest_study.h"

#include <algorithm>

namespace lapfx::smoke {

namespace {

constexpr float same = 4.0f;                // code values within which a block's mean is the background's
constexpr float around = 16.0f;             // code values: between `same` and this a plain background has a gap
constexpr double least_share = 0.03;        // share of the clip that a background fills
constexpr double small_share = 0.15;        // a background with a smaller share has to stay at its place
constexpr int candidates = 5;               // number of colours that are tried as background
constexpr float still = 3.0f;               // code values within which a block's mean does not change
constexpr std::size_t enough_pictures = 6;  // to tell what stands still

/// The colour that most blocks are close to: found by a coarse histogram, then by the mean of closer and closer blocks.
/// Blocks within `around` of a colour in `but` do not count.
glm::vec3 crowded_colour(std::span<const Block> blocks, std::span<const glm::vec3> but) {
    const auto counts = [&](const Block& block) {
        return std::none_of(but.begin(), but.end(),
                            [&](glm::vec3 colour) { return difference(block.mean, colour) <= around; });
    };
    constexpr int cells = 32;  // a side: 8 code values each
    std::vector<float> histogram(cells * cells * cells);
    const auto at = [&](int r, int g, int b) -> float& {
        return histogram[static_cast<std::size_t>((r * cells + g) * cells + b)];
    };
    for (const Block& block : blocks) {
        if (!counts(block)) continue;
        const glm::ivec3 c = glm::min(glm::ivec3(block.mean / 8.0f), cells - 1);
        at(c.r, c.g, c.b) += block.weight;
    }
    float best = -1.0f;
    glm::vec3 colour(0.0f);
    for (int r = 0; r < cells; ++r)
        for (int g = 0; g < cells; ++g)
            for (int b = 0; b < cells; ++b) {
                float sum = 0.0f;  // of 2 x 2 x 2 cells, so that a border between them splits nothing
                for (int n = 0; n < 8; ++n)
                    sum += at(std::min(r + (n & 1), cells - 1), std::min(g + (n >> 1 & 1), cells - 1),
                              std::min(b + (n >> 2), cells - 1));
                if (sum > best) best = sum, colour = 8.0f * glm::vec3(r + 1, g + 1, b + 1);
            }
    for (const float radius : {16.0f, 12.0f, 8.0f, 6.0f, 4.0f, 3.0f, 3.0f}) {
        glm::vec3 sum(0.0f);
        float weight = 0.0f;
        for (const Block& block : blocks)
            if (difference(block.mean, colour) <= radius) sum += block.weight * block.mean, weight += block.weight;
        if (weight > 0.0f) colour = sum / weight;
    }
    return colour;
}

/// Marks the blocks similar to the colour that is tried as background, and finds how plain that is.
void mark_background(Study& s) {
    double total = 0.0, just = 0.0, like = 0.0;
    for (Block& block : s.all) {
        const float apart = difference(block.mean, s.background);
        block.background = apart <= same;
        total += 1.0;
        if (block.background) just += 1.0;
        if (apart <= around) like += 1.0;
    }
    s.share = just / std::max(total, 1.0);
    s.concentration = just / std::max(like, 1.0);
}

/// The share of the background that is always at the same place. Smoke that has one colour in many places moves.
double steadiness(const Study& s) {
    std::size_t always = 0, all = 0;
    for (std::size_t b = 0; b < s.blocks; ++b) {
        std::size_t here = 0;
        for (std::size_t p = 0; p < s.pictures(); ++p) here += s.at(p, b).background ? 1u : 0u;
        all += here;
        if (here == s.pictures()) always += here;
    }
    return static_cast<double>(always) / static_cast<double>(std::max<std::size_t>(all, 1));
}

/// How likely it is that the smoke was filmed before the colour that mark_background() has marked. Such a colour is
/// plain, in many places, more often at the border, always at the same places, and either coloured or at one end of the
/// lumas, because smoke is a mixture of it and grey. 0: it is not plain.
double likelihood(const Study& s) {
    if (s.concentration < 0.5 || s.share < least_share) return 0.0;
    double weight = 0.0, all = 0.0, lighter = 0.0, darker = 0.0;
    for (const Block& block : s.all) {
        all += static_cast<double>(block.weight);
        const float apart = luma(block.mean) - luma(s.background);
        if (block.background) weight += static_cast<double>(block.weight);
        if (apart > around) lighter += 1.0;
        if (apart < -around) darker += 1.0;
    }
    const double steady = steadiness(s);
    if (s.share < small_share && steady < 0.6) return 0.0;
    const double coloured = glm::length(chroma(s.background)) >= least_chroma ? 4.0 : 1.0;
    const double end = std::min(lighter, darker) <= 0.05 * (lighter + darker) ? 2.0 : 1.0;
    return weight / all * (0.1 + steady) * coloured * end;
}

/// Rectangles around blocks that belong together, which are at most one pitch apart.
struct Cluster {
    glm::ivec2 low, high;
    bool meets(const Cluster& o) const {
        return glm::all(glm::lessThanEqual(low, o.high)) && glm::all(glm::lessThanEqual(o.low, high));
    }
};

std::vector<Cluster> clusters_of_marks(const Study& s) {
    std::vector<Cluster> found;
    for (std::size_t b = 0; b < s.blocks; ++b) {
        if (s.kinds[b] != BlockKind::mark) continue;
        Cluster grown{s.corners[b] - s.pitch, s.corners[b] + s.edge + s.pitch};
        for (std::size_t i = 0; i < found.size();) {
            if (!found[i].meets(grown)) {
                ++i;
                continue;
            }
            grown = {glm::min(grown.low, found[i].low), glm::max(grown.high, found[i].high)};
            found[i] = found.back();
            found.pop_back();
            i = 0;  // it may touch others now
        }
        found.push_back(grown);
    }
    return found;
}

/// Whether mostly background is visible around it: otherwise it may be smoke at rest.
bool stands_alone(const Study& s, const Cluster& mark) {
    const Cluster ring{mark.low - s.pitch - s.edge, mark.high + s.pitch + s.edge};
    std::size_t all = 0, plain = 0;
    for (std::size_t b = 0; b < s.blocks; ++b) {
        const Cluster block{s.corners[b], s.corners[b] + s.edge};
        if (s.kinds[b] == BlockKind::mark || !block.meets(ring) || block.meets(mark)) continue;
        for (std::size_t p = 0; p < s.pictures(); ++p) all += 1, plain += s.at(p, b).background ? 1u : 0u;
    }
    return all > 0 && plain * 10 >= all * 6;
}

}  // namespace

void find_background(Study& s) {
    std::vector<glm::vec3> tried;
    double best = 0.0;
    glm::vec3 background(0.0f);
    for (int n = 0; n < candidates; ++n) {
        s.background = crowded_colour(s.all, tried);
        tried.push_back(s.background);
        mark_background(s);
        if (const double here = likelihood(s); here > best) best = here, background = s.background;
    }
    s.background = background;
    mark_background(s);
    s.plain = best > 0.0;
    if (s.plain) return;
    // Haze that fills the view, most likely filmed before black; or no clip for keying at all.
    s.background = glm::vec3(0.0f);
    mark_background(s);
}

/// What a block shows over time: always background, always the same other thing, or something that changes.
void find_kinds(Study& s) {
    s.kinds.assign(s.blocks, BlockKind::changing);
    for (std::size_t b = 0; b < s.blocks; ++b) {
        bool quiet = true, never = true;
        glm::vec3 low(255.0f), high(0.0f);
        for (std::size_t p = 0; p < s.pictures(); ++p) {
            const Block& block = s.at(p, b);
            (block.background ? never : quiet) = false;
            low = glm::min(low, block.mean), high = glm::max(high, block.mean);
        }
        const glm::vec3 range = high - low;
        if (quiet)
            s.kinds[b] = BlockKind::quiet;
        else if (never && s.pictures() >= enough_pictures && std::max({range.r, range.g, range.b}) <= still)
            s.kinds[b] = BlockKind::mark;
    }
    s.marks = static_cast<double>(std::count(s.kinds.begin(), s.kinds.end(), BlockKind::mark)) /
              static_cast<double>(std::max<std::size_t>(s.blocks, 1));
    // What fills much of the picture and hardly moves is smoke at rest; at least it is not a logo.
    if (s.marks > 0.1) {
        std::replace(s.kinds.begin(), s.kinds.end(), BlockKind::mark, BlockKind::changing);
        s.marks = 0.0;
    }
}

std::vector<ClipMask> masks_of(const Study& s) {
    std::vector<ClipMask> masks;
    for (const Cluster& mark : clusters_of_marks(s)) {
        if (!stands_alone(s, mark)) continue;
        const glm::dvec2 low = glm::dvec2(glm::max(mark.low, 0)) / glm::dvec2(s.size);
        const glm::dvec2 high = glm::dvec2(glm::min(mark.high, s.size)) / glm::dvec2(s.size);
        masks.push_back({low.x, low.y, high.x - low.x, high.y - low.y});
    }
    std::sort(masks.begin(), masks.end(),
              [](const ClipMask& a, const ClipMask& b) { return a.width * a.height > b.width * b.height; });
    if (masks.size() > most_masks) masks.resize(most_masks);
    return masks;
}

}  // namespace lapfx::smoke
