#include "bench/measure/by_strokes.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "bench/measure/figures.h"
#include "match/picture/view.h"

namespace lapfx::bench {

namespace {

// px of a picture of 256 on its longer side
constexpr double blood_radius = 2.0, other_radius = 3.0, beside = 4.0;
constexpr double shortest = 5.0, longest_blood = 20.0, longest_other = 40.0;

/// A straight stroke that stays within `part`, of its picture's px; nothing where that is empty.
void add_stroke(Random& random, const cv::Mat& part, StrokeMark marks, double radius, double longest,
                match::BloodStrokes& strokes) {
    std::vector<cv::Point> inside;
    cv::findNonZero(part, inside);
    if (inside.empty()) return;
    const cv::Point from = inside[static_cast<std::size_t>(random.below(static_cast<int>(inside.size())))];
    const double angle = random.in(0.0, 6.283185307), length = random.in(shortest, longest);
    const cv::Rect whole({}, part.size());
    cv::Point to = from;
    for (double gone = 1.0; gone <= length; gone += 1.0) {
        const cv::Point next(from.x + static_cast<int>(std::lround(gone * std::cos(angle))),
                             from.y + static_cast<int>(std::lround(gone * std::sin(angle))));
        if (!whole.contains(next) || part.at<std::uint8_t>(next) == 0) break;
        to = next;
    }
    BloodStroke stroke{.time = 0.0, .marks = marks, .radius = radius / part.cols};
    for (const cv::Point& at : {from, to})
        stroke.points.push_back({(at.x + 0.5) / part.cols, (at.y + 0.5) / part.rows});
    strokes.strokes.push_back(std::move(stroke));
}

match::PaintedPicture painted(const KnownPicture& known, Random& random, match::BloodStrokes& strokes) {
    const double unit = match::unit_of(known.view.size());
    const auto px = [unit](double length) { return static_cast<int>(std::lround(length * unit)); };
    cv::Mat inner, outer;
    cv::erode(known.blood_area, inner, match::disc(px(blood_radius)));
    if (cv::countNonZero(inner) == 0) inner = known.blood_area;
    cv::dilate(known.blood_area, outer, match::disc(px(beside)));
    const std::size_t before = strokes.strokes.size();
    for (int i = 0; i < strokes_of_blood; ++i)
        add_stroke(random, inner, StrokeMark::blood, blood_radius * unit, longest_blood * unit, strokes);
    for (int i = 0; i < strokes_of_other; ++i)
        add_stroke(random, known.view & ~outer, StrokeMark::other, other_radius * unit, longest_other * unit, strokes);
    match::PaintedPicture made{.picture = known.picture, .strokes = {}};
    for (std::size_t i = before; i < strokes.strokes.size(); ++i) made.strokes.push_back(i);
    return made;
}

}  // namespace

PaintedView painted_view(const KnownView& view, Random& random, int frames) {
    PaintedView made{.view = view, .blood = {}};
    std::vector<KnownPicture*> bloody;
    for (KnownPicture& known : made.view.pictures)
        if (known.blood > next_to_nothing) bloody.push_back(&known);
    if (bloody.size() < 3) return made;
    std::vector<KnownPicture*> chosen{bloody[1]};
    if (frames > 1) chosen.push_back(bloody[std::min<std::size_t>(3, bloody.size() - 1)]);
    match::BloodStrokes strokes{.file = "drawn", .without_blood = {}, .strokes = {}};
    std::vector<match::PaintedPicture> pictures;
    for (KnownPicture* known : chosen) {
        pictures.push_back(painted(*known, random, strokes));
        known->counted = false;
    }
    made.blood = std::make_shared<const match::PaintedBlood>(
        strokes, pictures, match::ClearPicture{.picture = &view.baseline, .without_blood = match::WithoutBlood::yes},
        match::LookedAt{});
    KnownPicture before;
    before.picture = view.baseline;
    before.blood_area = cv::Mat::zeros(view.baseline.height, view.baseline.width, CV_8U);
    made.view.pictures.insert(made.view.pictures.begin(), std::move(before));
    return made;
}

}  // namespace lapfx::bench
