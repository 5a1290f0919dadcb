#include "bench/measure/ranked_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/frame/estimator.h"

namespace lapfx::bench {

namespace {

namespace fs = std::filesystem;

constexpr double same_shape = 0.02;  // of the ratio of the sides

Error refused(const fs::path& file, std::string reason) {
    return {Failure::bad_input, Fault{.file = file.string(), .place = "", .reason = std::move(reason)}};
}

/// Digits by their number, all else by its letters: input_2 is before input_11.
bool before(const std::string& a, const std::string& b) {
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!digit(a[i]) || !digit(b[j])) {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i, ++j;
            continue;
        }
        std::string numbers[2];
        while (i < a.size() && digit(a[i])) numbers[0] += a[i++];
        while (j < b.size() && digit(b[j])) numbers[1] += b[j++];
        for (std::string& number : numbers) number.erase(0, number.find_first_not_of('0'));
        if (numbers[0].size() != numbers[1].size()) return numbers[0].size() < numbers[1].size();
        if (numbers[0] != numbers[1]) return numbers[0] < numbers[1];
    }
    return a.size() - i < b.size() - j;
}

std::vector<fs::path> recordings(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const fs::path& file = entry.path();
        if (is_named_as(Content::video, file) || is_named_as(Content::picture, file)) found.push_back(file);
    }
    if (error) throw refused(folder, "cannot be read: " + error.message());
    if (found.empty()) throw refused(folder, "has no pictures or videos");
    std::sort(found.begin(), found.end(), [](const fs::path& a, const fs::path& b) {
        return before(a.filename().string(), b.filename().string());
    });
    return found;
}

/// The light is learnt from a single frame: with care, therefore (haze_light.cpp). Nothing: the baseline is black.
std::optional<match::FrameAmounts> amounts(const Image& of, const Image& baseline) {
    try {
        match::Estimator estimator(baseline, {});
        estimator.survey(of);
        estimator.forget();
        return estimator.measure(of, 0.0);
    } catch (const Error& error) {
        if (error.failure() != Failure::bad_input) throw;
        return {};
    }
}

std::string size_text(glm::ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

void check_shapes(const fs::path& smoky, glm::ivec2 first, const fs::path& clear, glm::ivec2 second) {
    const double one = static_cast<double>(first.x) / first.y, other = static_cast<double>(second.x) / second.y;
    if (std::abs(one / other - 1.0) <= same_shape) return;
    throw refused(clear, "its pictures of " + size_text(second) + " have another shape than those of " +
                             smoky.string() + ", " + size_text(first));
}

RankedPair ranked(const fs::path& smoky, const fs::path& clear, int every) {
    VideoReader first(smoky), second(clear);
    check_shapes(smoky, first.info().size, clear, second.info().size);
    RankedPair pair{.smoky = smoky.filename().string(),
                    .clear = clear.filename().string(),
                    .smoky_frames = first.info().frames,
                    .clear_frames = second.info().frames};
    const int frames = std::min(pair.smoky_frames, pair.clear_frames);
    Image a, b;
    for (int i = 0; i < frames; i += every) {
        const bool read = first.read(i, a) && second.read(i, b);
        if (!read) {
            ++pair.missing;
            continue;
        }
        // A frame that is clearer than its baseline is no veil over it: one of the two may well not be measurable.
        const std::optional<match::FrameAmounts> of_smoky = amounts(a, b), of_clear = amounts(b, a);
        if (!of_smoky || !of_clear || (!of_smoky->measurable() && !of_clear->measurable())) {
            ++pair.not_measurable;
            continue;
        }
        pair.of_smoky += of_smoky->veil.value;
        pair.of_clear += of_clear->veil.value;
        ++pair.frames;
    }
    if (pair.frames == 0)
        throw refused(smoky, "has no frame to compare with " + clear.string() + ": " + std::to_string(pair.missing) +
                                 " cannot be read, " + std::to_string(pair.not_measurable) + " are not measurable");
    pair.of_smoky /= pair.frames;
    pair.of_clear /= pair.frames;
    return pair;
}

}  // namespace

std::vector<std::string> RankedPair::notes() const {
    std::vector<std::string> lines;
    const std::string both = smoky + " and " + clear + ": ";
    if (smoky_frames != clear_frames)
        lines.push_back(both + std::to_string(smoky_frames) + " and " + std::to_string(clear_frames) +
                        " frames; only the first " + std::to_string(std::min(smoky_frames, clear_frames)) +
                        " are compared");
    const std::string of_all = " of " + std::to_string(frames + missing + not_measurable) + " frames are left out: ";
    if (missing > 0) lines.push_back(both + std::to_string(missing) + of_all + "a file cannot give them");
    if (not_measurable > 0)
        lines.push_back(both + std::to_string(not_measurable) + of_all + "they are black or not of one view");
    return lines;
}

std::vector<RankedPair> rank_pairs(const fs::path& smoky, const fs::path& clear, int every, const Progress& progress) {
    const std::vector<fs::path> first = recordings(smoky), second = recordings(clear);
    if (first.size() != second.size())
        throw refused(clear, "has " + std::to_string(second.size()) + " pictures and videos; " + smoky.string() +
                                 " has " + std::to_string(first.size()) + ", and each needs its partner");
    std::vector<RankedPair> pairs;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(first.size())))
            throw Error(Failure::runtime, Fault{.file = "", .place = "", .reason = "measuring was stopped"});
        pairs.push_back(ranked(first[i], second[i], std::max(every, 1)));
    }
    return pairs;
}

}  // namespace lapfx::bench
