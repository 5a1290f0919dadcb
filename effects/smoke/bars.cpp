#include "smoke/bars.h"

#include <algorithm>
#include <cmath>

#include "smoke/keying.h"

namespace lapfx::smoke {

namespace {

constexpr float unlike = 8.0f;  // code values within which a stretch of a bar has its colour
constexpr int deepest = 4;      // bars take at most this part of a side
constexpr int thinnest = 2;     // lines
constexpr int enough = 6;       // pictures that show what moves
constexpr float along = 0.9f;   // share of a line that differs from the bar where the picture's background begins
constexpr float coming = 0.5f;  // share of a line where smoke comes and goes behind a bar of the background's colour
constexpr float least_step = 2.0f;  // code values, mean along a line
constexpr float sharp = 0.75f;      // share of the difference behind a bar that is already there one line after it
constexpr int inside = 8;           // lines behind a bar that it is compared with

float difference(glm::vec3 a, glm::vec3 b) {
    return std::max(std::abs(luma(a) - luma(b)), glm::distance(chroma(a), chroma(b)));
}

}  // namespace

template <class PixelAt>
void BarSurvey::look(Side& side, int lines, int length, const PixelAt& pixel_at) {
    const int step = std::max(length / (stretches * 4), 1);  // four pixels tell the mean of a stretch
    if (pictures_ == 0) {
        side.lines.assign(static_cast<std::size_t>(lines), Line{});
        glm::vec3 sum(0.0f);
        int count = 0;
        for (int at = 0; at < length; at += step, ++count) sum += pixel_at(0, at);
        side.colour = sum / static_cast<float>(count);
    }
    for (int n = 0; n < lines; ++n) {
        std::array<float, stretches> sums{};
        std::array<int, stretches> counts{};
        for (int at = 0; at < length; at += step) {
            const auto stretch = static_cast<std::size_t>(static_cast<long>(at) * stretches / length);
            sums[stretch] += difference(pixel_at(n, at), side.colour);
            ++counts[stretch];
        }
        Line& line = side.lines[static_cast<std::size_t>(n)];
        for (std::size_t i = 0; i < stretches; ++i) {
            const float mean = counts[i] > 0 ? sums[i] / static_cast<float>(counts[i]) : 0.0f;
            line.least[i] = pictures_ == 0 ? mean : std::min(line.least[i], mean);
            line.most[i] = std::max(line.most[i], mean);
        }
    }
}

void BarSurvey::add(glm::ivec2 size, std::span<const std::uint8_t> rgb) {
    const auto pixel = [&](int x, int y) {
        const std::size_t at =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
        return glm::vec3(rgb[at], rgb[at + 1], rgb[at + 2]);
    };
    size_ = size;
    const glm::ivec2 deep = glm::max(size / deepest, 1);
    look(sides_[0], deep.x, size.y, [&](int n, int at) { return pixel(n, at); });
    look(sides_[1], deep.y, size.x, [&](int n, int at) { return pixel(at, n); });
    look(sides_[2], deep.x, size.y, [&](int n, int at) { return pixel(size.x - 1 - n, at); });
    look(sides_[3], deep.y, size.x, [&](int n, int at) { return pixel(at, size.y - 1 - n); });
    ++pictures_;
}

/// Lines to leave out.
double BarSurvey::width(const Side& side) const {
    const auto& lines = side.lines;
    const auto is_bar = [](const Line& line) {
        return std::all_of(line.most.begin(), line.most.end(), [](float apart) { return apart <= unlike; });
    };
    const auto first = static_cast<std::size_t>(std::find_if_not(lines.begin(), lines.end(), is_bar) - lines.begin());
    if (first < thinnest || first == lines.size()) return 0.0;
    /// How far a line differs: as a whole, or only where something comes and goes.
    const auto step = [&](std::size_t n) {
        const Line& line = lines[std::min(n, lines.size() - 1)];
        float all = 0.0f, moving = 0.0f;
        int differ = 0, move = 0;
        for (std::size_t i = 0; i < stretches; ++i) {
            if (line.most[i] > unlike) ++differ;
            all += line.most[i];
            if (line.most[i] - line.least[i] <= unlike) continue;
            moving += line.most[i];
            ++move;
        }
        const bool whole = static_cast<float>(differ) >= along * stretches;
        const bool comes = pictures_ >= enough && static_cast<float>(move) >= coming * stretches;
        return (whole ? all : comes ? moving : 0.0f) / stretches;
    };
    float behind = 0.0f;
    for (std::size_t n = 0; n < inside; ++n) behind += step(first + 3 + n) / inside;
    const float at = std::max(step(first + 1), step(first + 2));
    if (behind < least_step || at < sharp * behind) return 0.0;
    return static_cast<double>(first) + 2.0;  // one line is mixed with the bar, one more rings
}

ClipCrop BarSurvey::crop() const {
    if (pictures_ == 0) return {};
    return {.left = width(sides_[0]) / size_.x,
            .top = width(sides_[1]) / size_.y,
            .right = width(sides_[2]) / size_.x,
            .bottom = width(sides_[3]) / size_.y};
}

}  // namespace lapfx::smoke
