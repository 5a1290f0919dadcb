#include "media/camera_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "media/opencv.h"

namespace lapfx::media {

namespace {

constexpr int most_places = 400;
constexpr int coarse_side = 180;         // px of the longer side, at which motion is first looked for
constexpr int coarse_reach = 24;         // px of that: an eighth of the picture
constexpr int patch = 8;                 // px on each side of a place that are compared
constexpr double coarse_likeness = 0.6;  // correlation, -1..1
constexpr double likeness = 0.75;
constexpr int tries = 500;
constexpr double near = 0.0025;      // share of the longer side by which a place may miss the motion
constexpr std::size_t least = 16;    // places that have to follow it
constexpr double least_share = 0.4;  // of all that were found again
constexpr double farthest = 0.3;     // share of the longer side that a corner may move

struct Match {
    glm::dvec2 from, to;
};

/// The place of the highest value, between pixels: of the parabola through its neighbours.
glm::dvec2 peak_of(const cv::Mat1f& values, double& height) {
    cv::Point at;
    cv::minMaxLoc(values, nullptr, &height, nullptr, &at);
    const auto between = [](float before, float here, float after) {
        const double bend = 2.0 * here - before - after;
        return bend > 1e-6 ? std::clamp(0.5 * (after - before) / bend, -0.5, 0.5) : 0.0;
    };
    glm::dvec2 peak(at.x, at.y);
    if (at.x > 0 && at.x + 1 < values.cols)
        peak.x += between(values(at.y, at.x - 1), values(at), values(at.y, at.x + 1));
    if (at.y > 0 && at.y + 1 < values.rows)
        peak.y += between(values(at.y - 1, at.x), values(at), values(at.y + 1, at.x));
    return peak;
}

/// Where the patch around `place` is found again within `reach` pixels of `guess`.
std::optional<glm::dvec2> found_again(const cv::Mat1b& from, const cv::Mat1b& to, cv::Point place, cv::Point guess,
                                      int reach, double least_likeness) {
    const cv::Rect all(0, 0, from.cols, from.rows);
    const cv::Rect around(place.x - patch, place.y - patch, 2 * patch + 1, 2 * patch + 1);
    const int wide = patch + reach;
    const cv::Rect searched = cv::Rect(guess.x - wide, guess.y - wide, 2 * wide + 1, 2 * wide + 1) & all;
    if ((around & all) != around || searched.width < around.width || searched.height < around.height)
        return std::nullopt;
    cv::Mat1f alike;
    cv::matchTemplate(to(searched), from(around), alike, cv::TM_CCOEFF_NORMED);
    double height = 0.0;
    const glm::dvec2 peak = peak_of(alike, height);
    if (!(height >= least_likeness)) return std::nullopt;
    return peak + glm::dvec2(searched.x + patch, searched.y + patch);
}

cv::Mat1b mask_of(const ValidView& view, cv::Size size) {
    cv::Mat1b mask(size, 0);
    mask(cv::Rect(view.from.x, view.from.y, view.to.x - view.from.x, view.to.y - view.from.y)) = 255;
    if (view.disc) {
        cv::Mat1b round(size, 0);
        const ViewDisc& disc = *view.disc;
        cv::ellipse(round, cv::Point2d(disc.center.x, disc.center.y),
                    cv::Size2d(0.95 * disc.radius.x, 0.95 * disc.radius.y), 0.0, 0.0, 360.0, 255, cv::FILLED);
        mask &= round;
    }
    return mask;
}

std::vector<Match> matches_of(const cv::Mat1b& from, const cv::Mat1b& to, const cv::Mat1b& mask) {
    const double scale = std::min(1.0, static_cast<double>(coarse_side) / std::max(from.cols, from.rows));
    cv::Mat1b small_from, small_to;
    cv::resize(from, small_from, {}, scale, scale, cv::INTER_AREA);
    cv::resize(to, small_to, {}, scale, scale, cv::INTER_AREA);
    std::vector<cv::Point2f> places;
    cv::goodFeaturesToTrack(from, places, most_places, 0.003, std::max(from.cols, from.rows) / 60.0, mask);
    std::vector<Match> matches;
    for (const cv::Point2f& feature : places) {
        const cv::Point place(cvRound(feature.x), cvRound(feature.y));
        const cv::Point coarse(static_cast<int>(place.x * scale), static_cast<int>(place.y * scale));
        const auto guess = found_again(small_from, small_to, coarse, coarse, coarse_reach, coarse_likeness);
        if (!guess) continue;
        const glm::dvec2 shift = (*guess - glm::dvec2(coarse.x, coarse.y)) / scale;
        const cv::Point near_to(place.x + static_cast<int>(std::lround(shift.x)),
                                place.y + static_cast<int>(std::lround(shift.y)));
        const int reach = static_cast<int>(std::ceil(1.5 / scale)) + 1;
        if (const auto there = found_again(from, to, place, near_to, reach, likeness))
            matches.push_back({.from = {place.x, place.y}, .to = *there});
    }
    return matches;
}

/// The homography that is nearest to all matches: the direct linear transform (Hartley 1997), about the middle and in
/// units of the picture.
std::optional<glm::dmat3> homography(std::span<const Match> matches, glm::dvec2 size) {
    const glm::dvec2 middle = size / 2.0;
    const double unit = std::max(size.x, size.y) / 2.0;
    cv::Mat1d rows(static_cast<int>(2 * matches.size()), 9);
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const glm::dvec2 a = (matches[i].from - middle) / unit, b = (matches[i].to - middle) / unit;
        const std::array<std::array<double, 9>, 2> two{{{a.x, a.y, 1, 0, 0, 0, -b.x * a.x, -b.x * a.y, -b.x},
                                                        {0, 0, 0, a.x, a.y, 1, -b.y * a.x, -b.y * a.y, -b.y}}};
        for (int r = 0; r < 2; ++r)
            for (int c = 0; c < 9; ++c)
                rows(static_cast<int>(2 * i) + r, c) = two[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
    cv::Mat1d solved;
    cv::SVD::solveZ(rows, solved);
    glm::dmat3 found;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) found[c][r] = solved(3 * r + c);
    if (std::abs(found[2][2]) < 1e-9) return std::nullopt;
    const glm::dmat3 to_unit(1 / unit, 0, 0, 0, 1 / unit, 0, -middle.x / unit, -middle.y / unit, 1);
    const glm::dmat3 whole = glm::inverse(to_unit) * (found / found[2][2]) * to_unit;
    return whole / whole[2][2];
}

std::vector<Match> followers(const glm::dmat3& motion, const std::vector<Match>& matches, double within) {
    std::vector<Match> found;
    for (const Match& match : matches)
        if (glm::distance(moved(motion, match.from), match.to) <= within) found.push_back(match);
    return found;
}

/// A camera that moves a little turns no picture over and moves no corner far.
bool is_small(const glm::dmat3& motion, glm::dvec2 size) {
    for (const glm::dvec2 corner : {glm::dvec2(0), {size.x, 0}, {0, size.y}, size}) {
        const glm::dvec3 to = motion * glm::dvec3(corner, 1.0);
        if (!(to.z > 0.2) || glm::distance(glm::dvec2(to) / to.z, corner) > farthest * std::max(size.x, size.y))
            return false;
    }
    return true;
}

}  // namespace

std::optional<glm::dmat3> camera_motion(const Image& from, const Image& to, const ValidView& view) {
    const glm::dvec2 size(from.width, from.height);
    const cv::Mat1b grey = grey_of(from);
    const std::vector<Match> matches = matches_of(grey, grey_of(to), mask_of(view, grey.size()));
    if (matches.size() < least) return std::nullopt;
    const double within = std::max(1.0, near * std::max(size.x, size.y));
    std::mt19937 random(1);
    std::vector<Match> best;
    for (int i = 0; i < tries; ++i) {
        std::array<Match, 4> four;
        for (Match& match : four) match = matches[random() % matches.size()];
        const std::optional<glm::dmat3> motion = homography(four, size);
        if (!motion || !is_small(*motion, size)) continue;
        if (std::vector<Match> found = followers(*motion, matches, within); found.size() > best.size())
            best = std::move(found);
    }
    if (best.size() < least || static_cast<double>(best.size()) < least_share * static_cast<double>(matches.size()))
        return std::nullopt;
    std::optional<glm::dmat3> motion;
    for (int i = 0; i < 2 && best.size() >= least; ++i) {  // those that follow the better one, again
        motion = homography(best, size);
        if (!motion) return std::nullopt;
        best = followers(*motion, matches, within);
    }
    return motion && is_small(*motion, size) ? motion : std::nullopt;
}

}  // namespace lapfx::media
