#include "match/picture/placement.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <optional>
#include <random>

#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

constexpr int most_points = 160;
constexpr double point_distance = 7.0, point_quality = 0.02;
constexpr int search_window = 21, search_levels = 3;
constexpr std::size_t least_points = 16;
constexpr double off_by = 1.5;  // px: a point that lies farther beside does not belong to the motion
constexpr int draws = 200;
constexpr double still_within = 0.5;                    // px
constexpr double strong_motion = 6.0;                   // px of the working size from one frame to the next
constexpr double better_by = 0.01;                      // likeness: less is noise
constexpr double by_chance = 0.1;                       // likeness of two pictures of other things, nearly at most
constexpr double doubtful = 0.4, surely_better = 0.03;  // likeness: where it is less than the first, less is noise
constexpr double surely_there = 0.9;                    // likeness
constexpr double largest_zoom = 1.6;
constexpr double cut_likeness = 0.12;   // of a frame with the one before it
constexpr double least_texture = 12.0;  // code values of texture_of, root mean square: less is a plain picture

/// How far the corners of a picture move between two places, px.
double distance(const cv::Matx33d& a, const cv::Matx33d& b, cv::Size size) {
    double most = 0.0;
    for (const cv::Point2d corner :
         {cv::Point2d{0, 0}, {size.width * 1.0, 0}, {0, size.height * 1.0}, {size.width * 1.0, size.height * 1.0}}) {
        const cv::Vec3d p = a * cv::Vec3d(corner.x, corner.y, 1), q = b * cv::Vec3d(corner.x, corner.y, 1);
        if (std::abs(p[2]) < 1e-6 || std::abs(q[2]) < 1e-6) return 1e9;
        most = std::max(most, std::hypot(p[0] / p[2] - q[0] / q[2], p[1] / p[2] - q[1] / q[2]));
    }
    return most;
}

/// How far a motion moves points, px: their mean. The corners of a picture lie beyond them, where a motion is a guess.
double distance(const cv::Matx33d& motion, const std::vector<cv::Point2f>& points) {
    if (points.empty()) return 0.0;
    double sum = 0.0;
    for (const cv::Point2f& point : points) {
        const cv::Vec3d to = motion * cv::Vec3d(point.x, point.y, 1.0);
        sum += std::hypot(to[0] - point.x, to[1] - point.y);
    }
    return sum / static_cast<double>(points.size());
}

bool plausible(const cv::Matx33d& place) {
    const double area = std::abs(place(0, 0) * place(1, 1) - place(0, 1) * place(1, 0));
    return std::isfinite(area) && area < largest_zoom * largest_zoom && area > 1.0 / (largest_zoom * largest_zoom);
}

using Points = std::vector<cv::Point2f>;

/// Shift, turn and zoom that lead from two points to two others.
cv::Matx33d motion_of_pair(const cv::Point2d& a, const cv::Point2d& b, const cv::Point2d& to_a,
                           const cv::Point2d& to_b) {
    const cv::Point2d across = b - a, to = to_b - to_a;
    const double length = across.dot(across), scale = across.dot(to) / length, turn = across.cross(to) / length;
    return {scale, -turn, to_a.x - scale * a.x + turn * a.y, turn, scale, to_a.y - turn * a.x - scale * a.y, 0, 0, 1};
}

std::vector<std::size_t> following(const cv::Matx33d& motion, const Points& from, const Points& to) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const cv::Vec3d place = motion * cv::Vec3d(from[i].x, from[i].y, 1.0);
        const double across = place[0] - to[i].x, down = place[1] - to[i].y;
        if (across * across + down * down <= off_by * off_by) all.push_back(i);
    }
    return all;
}

/// The affine motion that fits these points best.
cv::Matx33d fitted(const Points& from, const Points& to, const std::vector<std::size_t>& points) {
    cv::Mat places(static_cast<int>(points.size()), 3, CV_64F), wanted(static_cast<int>(points.size()), 2, CV_64F),
        rows;
    for (int i = 0; i < places.rows; ++i) {
        const std::size_t point = points[static_cast<std::size_t>(i)];
        places.at<double>(i, 0) = from[point].x;
        places.at<double>(i, 1) = from[point].y;
        places.at<double>(i, 2) = 1.0;
        wanted.at<double>(i, 0) = to[point].x;
        wanted.at<double>(i, 1) = to[point].y;
    }
    cv::solve(places, wanted, rows, cv::DECOMP_SVD);
    cv::Matx33d motion = cv::Matx33d::eye();
    for (int k = 0; k < 3; ++k) {
        motion(0, k) = rows.at<double>(k, 0);
        motion(1, k) = rows.at<double>(k, 1);
    }
    return motion;
}

/// RANSAC (Fischler and Bolles 1981): the motion that most points follow, if they are `least`. It draws with a fixed
/// seed: the same points give the same motion.
std::optional<cv::Matx33d> motion_of(const Points& from, const Points& to, std::size_t least) {
    std::mt19937 random(1);
    std::vector<std::size_t> best;
    for (int draw = 0; draw < draws; ++draw) {
        const std::size_t a = random() % from.size(), b = random() % from.size();
        if (cv::norm(from[a] - from[b]) < point_distance) continue;
        std::vector<std::size_t> found = following(motion_of_pair(from[a], from[b], to[a], to[b]), from, to);
        if (found.size() > best.size()) best = std::move(found);
    }
    if (best.size() < least) return {};
    return fitted(from, to, best);
}

/// How strong a picture of texture_of is within `view`, root mean square.
double strength_of(const cv::Mat& texture, const cv::Mat& view) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(texture, mean, deviation, view);
    return deviation[0];
}

void pyramid_of(const cv::Mat& texture, std::vector<cv::Mat>& pyramid) {
    cv::buildOpticalFlowPyramid(texture, pyramid, {search_window, search_window}, search_levels);
}

}  // namespace

Placement::Placement(cv::Mat texture, const cv::Mat& counts) : texture_(std::move(texture)), counts_(counts.clone()) {
    cv::goodFeaturesToTrack(texture_, points_, most_points, point_quality, point_distance, counts_);
    pyramid_of(texture_, pyramid_);
}

void Placement::forget(const cv::Matx33d& place) {
    place_ = place;
    last_.clear();
    lost_ = 0;
    still_ = texture_.empty() || distance(place_, cv::Matx33d::eye(), texture_.size()) <= still_within;
}

double likeness_of(const cv::Mat& a, const cv::Mat& b, const cv::Mat& counts) {
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (int y = 0; y < a.rows; ++y) {
        const auto *p = a.ptr<std::uint8_t>(y), *q = b.ptr<std::uint8_t>(y), *counted = counts.ptr<std::uint8_t>(y);
        for (int x = 0; x < a.cols; ++x) {
            if (counted[x] == 0) continue;
            const int i = p[x] - plain_texture, j = q[x] - plain_texture;
            ab += i * j, aa += i * i, bb += j * j;
        }
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

double Placement::likeness_at(const cv::Matx33d& place, const cv::Mat& texture) {
    cv::warpPerspective(texture_, warped_, place, texture.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT, plain_texture);
    cv::warpPerspective(counts_, warped_counts_, place, texture.size(), cv::INTER_NEAREST);
    return likeness_of(warped_, texture, warped_counts_);
}

bool Placement::find_points(const std::vector<cv::Mat>& before, const Points& points) {
    cv::calcOpticalFlowPyrLK(before, now_, points, moved_, found_, errors_, {search_window, search_window},
                             search_levels, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 20, 0.02},
                             cv::OPTFLOW_USE_INITIAL_FLOW);
    from_.clear();
    to_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (found_[i] == 0) continue;
        from_.push_back(points[i]);
        to_.push_back(moved_[i]);
    }
    return from_.size() >= least_points;
}

cv::Matx33d Placement::found_from(const cv::Matx33d& start) {
    if (points_.size() < least_points) return start;
    cv::perspectiveTransform(points_, moved_, start);
    return find_points(pyramid_, points_) ? motion_of(from_, to_, least_points).value_or(start) : start;
}

std::optional<cv::Matx33d> Placement::step() {
    if (points_.size() < least_points || last_.empty()) return {};
    cv::perspectiveTransform(points_, at_, place_);
    moved_ = at_;
    if (!find_points(last_, at_)) return {};
    return motion_of(from_, to_, std::max(least_points, from_.size() / 2));
}

void Placement::take(const cv::Matx33d& place, const cv::Mat& texture, double least) {
    if (!plausible(place) || distance(place, place_, texture.size()) <= still_within) return;
    const double there = likeness_at(place, texture);
    if (there <= least) return;
    place_ = place;
    likeness_ = there;
}

/// Where near and far tissue move apart, the baseline is little alike at its place, too, and hardly more than at any
/// other: only what surely is better takes it from there. Two frames, one after the other, are always alike: from one
/// to the next its place is known also where the baseline itself is not found.
bool Placement::follow(const cv::Mat& texture) {
    const cv::Matx33d before = place_, none = cv::Matx33d::eye();
    likeness_ = likeness_at(before, texture);
    // "Not moved" may be taken though it is a little less alike (better_by): that is there as well.
    const bool there = likeness_ > surely_there + better_by;
    if (!there) pyramid_of(texture, now_);
    const std::optional<cv::Matx33d> by = likeness_ < doubtful ? step() : std::nullopt;
    const bool moved = by && distance(*by, from_) > strong_motion;
    if (by) take(*by * before, texture, likeness_ - better_by);
    if (!still_)
        take(none, texture,
             likeness_ < doubtful ? std::max(likeness_ + surely_better, by_chance) : likeness_ - better_by);
    // Where nearly everything is there already, the search would only find noise.
    if (likeness_ <= surely_there) {
        // What is lost may come back where it was at first, too.
        lost_ = by && likeness_ < by_chance ? lost_ + 1 : 0;
        take(found_from(lost_ % 2 == 1 ? none : place_), texture,
             by ? std::max(likeness_ + better_by, by_chance) : likeness_ + better_by);
    }
    std::swap(last_, now_);
    if (there) last_.clear();
    likeness_ = std::max(likeness_, 0.0);
    still_ = distance(place_, none, texture.size()) <= still_within;
    return by ? moved : distance(place_, before, texture.size()) > strong_motion;
}

bool another_view(const cv::Mat& last, const cv::Mat& now, const cv::Mat& view) {
    if (strength_of(last, view) < least_texture || strength_of(now, view) < least_texture) return false;
    Placement before(last, view);
    before.follow(now);
    return before.likeness() < cut_likeness;
}

}  // namespace lapfx::match
