#include "match/frame/painted_blood.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "lapfx/error.h"
#include "match/picture/colors.h"

namespace lapfx::match {

namespace {

// Those of experiments on real labelled operations.
constexpr double strength = 0.1;  // of the regression: how much the examples count against small weights
constexpr int clear_examples = 1000;
constexpr int most_examples = 20'000;  // of a frame that was painted
constexpr std::uint32_t seed = 1;
constexpr double thresholds[] = {0.5, 0.6, 0.7, 0.8, 0.9};
constexpr double blur = 2.0;                                 // px of 256 on the longer side, as the areas
constexpr double least_piece = 100.0, largest_hole = 200.0;  // px of area

/// Turns pieces of `mask` (CV_8U, 0 and 255) whose area is below `area` to 0.
void drop_small(cv::Mat& mask, double area) {
    cv::Mat labels, figures, middles;
    const int count = cv::connectedComponentsWithStats(mask, labels, figures, middles, 8, CV_32S);
    std::vector<std::uint8_t> kept(static_cast<std::size_t>(count), 0);
    for (int label = 1; label < count; ++label)
        if (figures.at<int>(label, cv::CC_STAT_AREA) >= area) kept[static_cast<std::size_t>(label)] = 255;
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
            mask.at<std::uint8_t>(y, x) = kept[static_cast<std::size_t>(labels.at<int>(y, x))];
}

/// Adds to `blood` the pieces of what is none, smaller than `area`, that it touches.
void fill_holes(cv::Mat& blood, const cv::Mat& view, double area) {
    cv::Mat none = view & ~blood, near, labels, figures, middles;
    cv::dilate(blood, near, cv::Mat());
    const int count = cv::connectedComponentsWithStats(none, labels, figures, middles, 8, CV_32S);
    std::vector<std::uint8_t> touched(static_cast<std::size_t>(count), 0);
    const auto is_hole = [&](int y, int x) {
        const int label = labels.at<int>(y, x);
        return label > 0 && figures.at<int>(label, cv::CC_STAT_AREA) < area;
    };
    for (int y = 0; y < none.rows; ++y)
        for (int x = 0; x < none.cols; ++x)
            if (near.at<std::uint8_t>(y, x) != 0) touched[static_cast<std::size_t>(labels.at<int>(y, x))] = 1;
    for (int y = 0; y < none.rows; ++y)
        for (int x = 0; x < none.cols; ++x)
            if (is_hole(y, x) && touched[static_cast<std::size_t>(labels.at<int>(y, x))] != 0)
                blood.at<std::uint8_t>(y, x) = 255;
}

/// Whole pieces of what is likelier than `threshold`.
cv::Mat pieces_of(const cv::Mat& chance, const cv::Mat& view, double threshold) {
    const double area = std::pow(unit_of(chance.size()), 2);
    cv::Mat blood = (chance >= threshold) & view;
    drop_small(blood, least_piece * area);
    fill_holes(blood, view, largest_hole * area);
    return blood;
}

}  // namespace

/// A frame as it was painted.
struct PaintedBlood::Lesson {
    cv::Mat code, view, marks;  // of marks_of()
};

/// Rows of features with what they are.
struct PaintedBlood::Examples {
    std::vector<double> figures;
    std::vector<std::uint8_t> kinds;  // 1: blood

    void add(const BloodFeatures& features, int y, int x, bool blood) {
        for (const cv::Mat& feature : features) figures.push_back(feature.at<float>(y, x));
        kinds.push_back(blood ? 1 : 0);
    }
    void add(const Lesson& lesson, const cv::Mat& clear_haze) {
        const BloodFeatures features = blood_features(lesson.code, lesson.view, clear_haze);
        const int every = 1 + cv::countNonZero(lesson.marks) / most_examples;
        int number = 0;
        for (int y = 0; y < lesson.marks.rows; ++y)
            for (int x = 0; x < lesson.marks.cols; ++x)
                if (const std::uint8_t mark = lesson.marks.at<std::uint8_t>(y, x); mark != 0 && number++ % every == 0)
                    add(features, y, x, mark == value_of(StrokeMark::blood));
    }
    bool has(std::uint8_t kind) const { return std::ranges::find(kinds, kind) != kinds.end(); }
    cv::Mat rows() {
        return {static_cast<int>(kinds.size()), static_cast<int>(blood_feature_count), CV_64F, figures.data()};
    }
};

PaintedBlood::PaintedBlood(const BloodStrokes& strokes, std::span<const PaintedPicture> pictures,
                           const ClearPicture& clear, const LookedAt& part)
    : part_(part) {
    const auto refuse = [&strokes](const std::string& reason) {
        throw Error(Failure::bad_input,
                    Fault{.file = strokes.file, .place = strokes.place + "/strokes", .reason = reason});
    };
    cv::Mat clear_code, clear_haze;
    if (clear.picture != nullptr) {
        shrink(*clear.picture, working_size_of(*clear.picture), clear_code);
        clear_haze = haze_of(clear_code);
    }
    Examples examples;
    std::vector<Lesson> lessons;
    for (const PaintedPicture& painted : pictures) {
        lessons.push_back(lesson_of(painted, clear_haze, strokes));
        examples.add(lessons.back(), clear_haze);
    }
    if (!examples.has(1)) refuse("no stroke marks blood");
    without_blood_ = clear.picture != nullptr && clear.without_blood != WithoutBlood::no;
    if (without_blood_ && clear.without_blood == WithoutBlood::maybe) {
        without_blood_ = examples.has(0);  // else nothing says whether it has
        if (without_blood_) learned_ = Logistic::fit(examples.rows(), examples.kinds, strength);
        without_blood_ = without_blood_ && choose_threshold(clear_code, clear_haze) <= most_found_without;
    }
    if (without_blood_) add_some(examples, clear_code, clear_haze);
    if (!examples.has(0)) refuse("no stroke marks what is no blood, and no frame without blood is known");
    learned_ = Logistic::fit(examples.rows(), examples.kinds, strength);
    threshold_ = *std::rbegin(thresholds);
    if (without_blood_) found_without_ = choose_threshold(clear_code, clear_haze);
    found_again_ = found_in(lessons, clear_haze);
}

/// A picture of another size than the clear one is brought to its size.
PaintedBlood::Lesson PaintedBlood::lesson_of(const PaintedPicture& painted, const cv::Mat& clear_haze,
                                             const BloodStrokes& strokes) const {
    Lesson made;
    shrink(painted.picture, clear_haze.empty() ? working_size_of(painted.picture) : clear_haze.size(), made.code);
    made.view = view_in(made.code, part_);
    made.marks = marks_of(strokes, painted.strokes, made.view);
    return made;
}

double PaintedBlood::found_in(std::span<const Lesson> lessons, const cv::Mat& clear_haze) const {
    double marked = 0.0, found = 0.0;
    for (const Lesson& lesson : lessons) {
        cv::Mat blood;
        find(lesson.code, clear_haze, blood);
        const cv::Mat as_blood = lesson.marks == static_cast<double>(value_of(StrokeMark::blood));
        marked += cv::countNonZero(as_blood);
        found += cv::countNonZero(as_blood & blood);
    }
    return found / std::max(marked, 1.0);
}

void PaintedBlood::add_some(Examples& examples, const cv::Mat& code, const cv::Mat& clear_haze) const {
    const cv::Mat view = view_in(code, part_);
    std::vector<cv::Point> inside;
    cv::findNonZero(view, inside);
    if (inside.empty()) return;
    const BloodFeatures features = blood_features(code, view, clear_haze);
    std::mt19937 random(seed);
    for (int i = 0; i < clear_examples; ++i) {
        const cv::Point& at = inside[random() % inside.size()];
        examples.add(features, at.y, at.x, false);
    }
}

cv::Mat PaintedBlood::haze_of(const cv::Mat& code) const {
    const cv::Mat view = view_in(code, part_);
    cv::Mat haze = match::haze_of(code, view);
    haze.setTo(1.0F, view == 0);  // where other frames show more of the view, nothing is known of their haze
    return haze;
}

cv::Mat PaintedBlood::chance_in(const cv::Mat& code, const cv::Mat& view, const cv::Mat& clear_haze) const {
    const BloodFeatures features = blood_features(code, view, clear_haze);
    cv::Mat chance(code.size(), CV_32F, cv::Scalar(learned_.bias));
    for (std::size_t k = 0; k < features.size(); ++k) cv::scaleAdd(features[k], learned_.weights[k], chance, chance);
    for (int y = 0; y < chance.rows; ++y)
        for (float* p = chance.ptr<float>(y); p != chance.ptr<float>(y) + chance.cols; ++p)
            *p = static_cast<float>(Logistic::chance(*p));
    return Neighbourhood(view, blur * unit_of(code.size())).mean(chance);
}

/// The lowest at which hardly anything of a frame is taken for blood; the highest where there is none. Gives the share
/// of the view that is taken for blood by it.
double PaintedBlood::choose_threshold(const cv::Mat& code, const cv::Mat& clear_haze) {
    const cv::Mat view = view_in(code, part_), chance = chance_in(code, view, clear_haze);
    double share = 0.0;
    for (const double threshold : thresholds) {
        threshold_ = threshold;
        share = cv::countNonZero(pieces_of(chance, view, threshold)) / std::max(1.0 * cv::countNonZero(view), 1.0);
        if (share <= most_found_without) break;
    }
    return share;
}

void PaintedBlood::find(const cv::Mat& code, const cv::Mat& clear_haze, cv::Mat& blood) const {
    const cv::Mat view = view_in(code, part_);
    blood = pieces_of(chance_in(code, view, clear_haze), view, threshold_);
}

}  // namespace lapfx::match
