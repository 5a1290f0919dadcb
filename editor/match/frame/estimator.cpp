#include "match/frame/estimator.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <utility>

#include "lapfx/error.h"
#include "match/frame/added_light.h"
#include "match/frame/blood.h"
#include "match/frame/interval.h"
#include "match/frame/painted_blood.h"
#include "match/frame/seen_through.h"
#include "match/frame/veil.h"
#include "match/frame/veil_model.h"
#include "match/picture/camera_gains.h"
#include "match/picture/colors.h"
#include "match/picture/dense_flow.h"
#include "match/picture/instruments.h"
#include "match/picture/overlay.h"
#include "match/picture/placement.h"
#include "match/picture/traps.h"
#include "match/picture/view.h"

namespace lapfx::match {

namespace {

constexpr double dark_view = 6.0;  // code value: a darker 95th percentile is a black picture
constexpr float redder = 1.15F, darker = 0.85F, dark_noise = 0.004F;
constexpr float white = 0.90F;              // linear: highlights say nothing of what is behind
constexpr double bleached_share = 0.25;     // of the view
constexpr float foreign_rest = 5.0F;        // residual in units of noise
constexpr double smoke_light_error = 0.25;  // standard deviation of what it is taken for, a share of it
constexpr double view_slack = 0.02;         // of the longer side, around the view of the baseline

// What makes a frame not measurable; found on real clips (tests/unit/match/video/real_frames_test.cpp).
constexpr double least_valid = 0.3, least_compared = 0.05;
constexpr double least_red = 0.35, most_foreign = 0.35, unlike = 0.35;
constexpr double well_placed = 0.6;  // likeness by the camera's motion from which single pixels are compared
constexpr double nowhere = 0.15;     // likeness of two pictures of other tissue: nothing is known of its place
constexpr double another = 0.25;     // likeness by the camera's motion alone: less may be another view
constexpr double surely_laid = 0.9;  // likeness beyond which there is nothing to gain
constexpr float metal_red = 1.3F;    // redness of instruments at most
constexpr float tissue_red = 1.18F;  // redness of tissue, also behind smoke

constexpr float clear_veil = 0.08F, lit = 0.06F;  // linear
constexpr double least_tint_share = 0.02, other_tint = 0.18;

const cv::Vec3f ungained(1.0F, 1.0F, 1.0F);
constexpr double least_gained = 0.02;  // of a channel: less is no change of the camera

constexpr int wide_passes = 3;
constexpr double telling_veil = 0.03;
constexpr float unexplained_rest = 1.2F;
constexpr double least_part = 0.01;  // of the picture, for the statistics of the veil

double share_of(const cv::Mat& part, const cv::Mat& whole) {
    const int all = cv::countNonZero(whole);
    return all == 0 ? 0.0 : static_cast<double>(cv::countNonZero(part & whole)) / all;
}

/// The code value below which 95 % of the pixels in `mask` are, by their brightest channel.
double bright_level(const cv::Mat& code, const cv::Mat& mask) {
    std::vector<int> counts(256, 0);
    int all = 0;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x) {
            if (mask.at<std::uint8_t>(y, x) == 0) continue;
            const cv::Vec3b& p = code.at<cv::Vec3b>(y, x);
            ++counts[std::max({p[0], p[1], p[2]})];
            ++all;
        }
    int so_far = 0;
    for (int level = 0; level < 256; ++level)
        if ((so_far += counts[static_cast<std::size_t>(level)]) * 20 >= all * 19) return level;
    return 255.0;
}

/// The disc around a view, and a little more: smoke shows dark hollows and rims, nothing beyond.
cv::Mat around(const cv::Mat& view) {
    std::vector<cv::Point> inside, hull;
    cv::findNonZero(view, inside);
    cv::convexHull(inside, hull);
    cv::Point2f middle;
    float radius = 0.0F;
    cv::minEnclosingCircle(hull, middle, radius);
    cv::Mat disc = cv::Mat::zeros(view.size(), CV_8U);
    const double slack = view_slack * std::max(view.cols, view.rows);
    cv::circle(disc, middle, static_cast<int>(std::lround(radius + slack)), 255, cv::FILLED);
    return disc;
}

[[noreturn]] void refuse(const std::string& place, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{.file = "", .place = place, .reason = reason});
}

}  // namespace

struct Estimator::State {
    EstimatorOptions options;
    cv::Size size;
    HazeLightSurvey light_survey;
    OverlaySurvey overlay_survey;
    Survey known;
    bool overlay_known = true;  ///< of all frames that were surveyed
    Placement placement;
    DenseFlow dense_flow;
    cv::Mat own_texture, placed_texture;
    cv::Rect box;       // around the view
    cv::Mat light_map;  // CV_32FC3

    // the baseline as it is, and as it lies over the frame
    cv::Mat code, wanted, whole, view, reach, instruments, counted;  // whole: the view, with what is not wanted of it
    cv::Mat laid_code, laid_linear, placed_code, placed_linear, placed_redness, placed_counted;
    cv::Vec3f gains{1.0F, 1.0F, 1.0F};  // of the camera, by which placed_* are multiplied and laid_code is not

    VeilSolver veil, free_veil;
    BloodFinder blood;
    cv::Mat clear_haze, held, all_blood;  // by a person's strokes: haze and blood of the baseline, blood of the frame
    AppearanceFinder appearance;
    SeenThrough through;
    AddedLightFinder added_light;
    AddedLight added;
    VeilFigures figures;
    std::vector<float> sorted_veil;
    cv::Mat frame_code, frame_linear, frame_redness, texture, last_texture, counts, rest, valid, foreign, white_part,
        aside, brighter, readable, bright_smoke, hazy;
    double likeness = 1.0;
    bool has_last = false, last_alike = false, laid = false;
    cv::Matx33d laid_at;

    State(const Image& baseline, const EstimatorOptions& given);
    cv::Mat round_view(const cv::Mat& of) const {
        return options.round_view ? disc_of(*options.round_view, size, options.round_aspect) : view_of(of);
    }
    void lay_over();
    void see_likeness();
    bool laid_well() const { return options.still || placement.likeness() >= well_placed; }
    void see_light(const HazeLight& found);
    void take(const Image& frame);
    void see_view();
    void see_overlay();
    void count();
    void find_foreign();
    void find_blood(const cv::Mat& within);
    const cv::Mat& counted_blood() const { return all_blood.empty() ? blood.blood() : all_blood; }
    void find_all_blood();
    void explain();
    FrameAmounts amounts_of(double time, bool moved);
    bool pale(double least) const;
    bool bleached() const { return share_of(white_part, view) > bleached_share; }
    bool dark() const { return bright_level(frame_code, view) < dark_view; }
    bool cut_from_last() const;
    void gain(const cv::Vec3f& by);
    std::optional<cv::Vec3f> gains_that_explain() const;
    void find_amounts();
    void see_veil();
    void see_added_light();
    double rest_share() const;
    double tint() const;
    void judge(FrameAmounts& amounts, bool moved) const;
};

Estimator::State::State(const Image& baseline, const EstimatorOptions& given)
    : options(given), size(working_size_of(baseline)) {
    shrink(baseline, size, code);
    wanted = wanted_part(size, options.region, options.masks);
    const int least = static_cast<int>(0.01 * static_cast<double>(size.area()));
    view = round_view(code);
    if (cv::countNonZero(view) < least && options.round_view) refuse("view", "leaves less than 1 % of the picture");
    if (cv::countNonZero(view) < least) refuse("baseline", "has no view to measure: it is black");
    reach = around(view);
    view &= wanted;
    if (cv::countNonZero(view) < least)
        refuse(options.masks.empty() ? "roi" : "mask",
               "leaves nothing of the view (less than 1 % of the picture), with the parts that are left out");
    instruments = instruments_of(code, view);
    HazeLight assumed;
    const double bright = linear_of(static_cast<float>(bright_level(code, view & ~instruments)));
    assumed.color *= std::clamp(bright / 0.4, 0.3, 1.6);
    light_survey = HazeLightSurvey(assumed);
    known.light = assumed;
    if (options.survey) known = *options.survey;
    if (known.brightest.empty()) code.copyTo(known.brightest);
    see_view();
    texture_of(code, own_texture);
    placement = Placement(own_texture, counted);
    lay_over();
    see_light(known.light);
    if (options.painted_blood) clear_haze = options.painted_blood->haze_of(code);
    if (options.held_blood) options.held_blood->find(code, options.held_blood->haze_of(code), held);
}

void Estimator::State::see_light(const HazeLight& found) {
    known.light = found;
    light_map = found.over(size, box);
}

void Estimator::State::lay_over() {
    if (laid && placement.place() == laid_at) {
        if (gains != ungained) gain(ungained);
        return;
    }
    laid = true;
    laid_at = placement.place();
    if (placement.still()) {
        code.copyTo(laid_code);
        counted.copyTo(placed_counted);
    } else {
        cv::warpPerspective(code, laid_code, placement.place(), size, cv::INTER_LINEAR);
        cv::warpPerspective(counted, placed_counted, placement.place(), size, cv::INTER_NEAREST);
        placed_counted &= view;
    }
    gain(ungained);
}

void Estimator::State::gain(const cv::Vec3f& by) {
    gains = by;
    if (by == ungained) {
        laid_code.copyTo(placed_code);
    } else {
        cv::Mat table(1, 256, CV_8UC3);
        for (int c = 0; c < 256; ++c)
            for (int k = 0; k < 3; ++k)
                table.at<cv::Vec3b>(0, c)[k] =
                    cv::saturate_cast<std::uint8_t>(code_of(by[k] * linear_of(static_cast<float>(c))));
        cv::LUT(laid_code, table, placed_code);
    }
    to_linear(placed_code, placed_linear);
    redness_of(placed_linear, placed_redness);
}

/// Whether the tissue of the baseline is there, though it moved otherwise than the camera. Amounts are looked for where
/// the camera's motion lays it: the flow would draw what bled wider than it was, as if it had grown with the tissue.
void Estimator::State::see_likeness() {
    likeness = placement.likeness();
    if (likeness > surely_laid) return dense_flow.forget();
    cv::warpPerspective(own_texture, placed_texture, placement.place(), size, cv::INTER_LINEAR, cv::BORDER_CONSTANT,
                        plain_texture);
    if (dense_flow.find(placed_texture, placed_counted, texture, likeness)) likeness = dense_flow.likeness();
}

void Estimator::State::take(const Image& frame) {
    shrink(frame, size, frame_code);
    to_linear(frame_code, frame_linear);
    texture_of(frame_code, texture);
    redness_of(frame_linear, frame_redness);
}

/// Hollows that are black in the clear frame show when smoke is in them; the surround stays black.
void Estimator::State::see_view() {
    whole = round_view(known.brightest);
    view = whole & wanted;
    if (!known.overlay.empty()) view &= ~known.overlay;
    counted = view & ~instruments;
    box = cv::boundingRect(whole);
    laid = false;
}

void Estimator::State::see_overlay() {
    if (std::exchange(overlay_known, true)) return;
    known.overlay = overlay_survey.found(size);
    see_view();
}

void Estimator::State::count() {
    counts.create(size, CV_32F);
    readable.create(size, CV_8U);
    white_part.create(size, CV_8U);
    aside.create(size, CV_8U);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const cv::Vec3f &b = placed_linear.at<cv::Vec3f>(y, x), &f = frame_linear.at<cv::Vec3f>(y, x);
            const bool bright = std::max({b[0], b[1], b[2], f[0], f[1], f[2]}) >= white;
            white_part.at<std::uint8_t>(y, x) = std::min({f[0], f[1], f[2]}) >= white ? 255 : 0;
            // Smoke makes nothing redder: what is redder than the baseline was is blood.
            const bool red = frame_redness.at<float>(y, x) > redder * placed_redness.at<float>(y, x);
            // Nor does it make anything darker than both tissue and smoke are.
            const cv::Vec3f& h = light_map.at<cv::Vec3f>(y, x);
            bool dark = false;
            for (int k = 0; k < 3; ++k) dark = dark || f[k] < darker * std::min(b[k], h[k]) - dark_noise;
            aside.at<std::uint8_t>(y, x) = red || dark ? 255 : 0;
            const bool read = placed_counted.at<std::uint8_t>(y, x) != 0 && !bright;
            readable.at<std::uint8_t>(y, x) = read ? 255 : 0;
            counts.at<float>(y, x) = read ? 1.0F : 0.0F;
        }
    cv::dilate(aside, aside, cv::Mat());
    counts.setTo(0.0F, aside);
}

/// Instruments that came into view: what no veil before the baseline explains, and is not red. Dense smoke is not quite
/// as bright and of the same tint as it is taken for, and is no instrument for that; nor is what tissue is seen
/// through.
void Estimator::State::find_foreign() {
    veil.residual(placed_linear, frame_linear, light_map, smoke_light_error, rest);
    foreign.create(size, CV_8U);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            foreign.at<std::uint8_t>(y, x) =
                rest.at<float>(y, x) > foreign_rest && blood.redness().at<float>(y, x) < metal_red ? 255 : 0;
    foreign &= placed_counted;
    through.find(placed_linear, frame_linear, foreign);
    foreign.setTo(0, through.smoke());
    const cv::Mat small = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
    cv::morphologyEx(foreign, foreign, cv::MORPH_OPEN, small);
    cv::morphologyEx(foreign, foreign, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}));
}

void Estimator::State::find_blood(const cv::Mat& within) {
    blood.find(placed_linear, placed_redness, frame_linear, veil.veil(), light_map, within, options.blood,
               {.well = laid_well(), .likeness = likeness, .tissue = placed_counted});
}

/// A camera that changes makes neither smoke nor blood: then both are looked for over the baseline as it would be now.
void Estimator::State::explain() {
    find_amounts();
    const std::optional<cv::Vec3f> found = gains_that_explain();
    if (!found) return;
    gain(*found);
    find_amounts();
}

/// The gains of the camera's channels, if they explain more of the frame than a whole map of veil does.
std::optional<cv::Vec3f> Estimator::State::gains_that_explain() const {
    if (!laid_well()) return {};
    const cv::Vec3f found = camera_gains(placed_linear, frame_linear, readable);
    if (cv::norm(found, ungained, cv::NORM_INF) < least_gained) return {};
    if (misfit_of_gains(placed_linear, found, frame_linear, readable) >=
        veil.misfit(placed_linear, frame_linear, readable, light_map))
        return {};
    return found;
}

/// Veil and blood depend on each other: blood is no smoke, and its colour shows without the smoke. First what
/// most of the picture says about the veil; then what is red behind that, unless a veil of its own explains it as well.
/// The mean veil is the model's, before blood is looked for behind it; but bright smoke that tissue is seen through is
/// no haze, and tells its own.
void Estimator::State::find_amounts() {
    count();
    figures = {};
    foreign.create(size, CV_8U);
    foreign.setTo(0);
    veil.solve_wide(placed_linear, frame_linear, counts, light_map, wide_passes);
    find_blood(placed_counted);
    find_foreign();
    free_veil.solve_narrow(placed_linear, frame_linear, counts, light_map, veil.veil());
    free_veil.residual(placed_linear, frame_linear, light_map, 0.0, rest);
    aside = (blood.redder() | blood.blood()) & (rest > unexplained_rest);
    cv::dilate(aside | foreign, aside, cv::Mat());
    counts.setTo(0.0F, aside);
    veil.refine(placed_linear, frame_linear, counts, light_map);
    valid = placed_counted & ~foreign;
    bright_smoke = through.smoke() & valid;
    hazy = valid & ~bright_smoke;
    if (cv::countNonZero(hazy) > 0) {
        see_veil();
        const VeilModel& model = options.veil_model ? *options.veil_model : VeilModel::shipped();
        veil.scale_to(model.veil_of(figures), hazy);
    }
    veil.put(through.veil(), bright_smoke);
    find_blood(valid);
}

/// Whether the frame has neither the texture nor the colour of tissue. Dense smoke hides the texture as well, but some
/// of the colour comes through.
bool Estimator::State::pale(double least) const {
    return likeness < least && share_of(frame_redness >= tissue_red, placed_counted) < least_red;
}

/// Where both frames show the baseline, the camera moved.
bool Estimator::State::cut_from_last() const {
    return has_last && (!last_alike || placement.likeness() < another) && another_view(last_texture, texture, view);
}

/// Light that is left over the valid view without blood, in shares of its light. Bright smoke has another light than
/// haze, over which nothing is left.
double Estimator::State::rest_share() const {
    double off = 0.0, all = 1e-6;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            if (counts.at<float>(y, x) <= 0.0F || hazy.at<std::uint8_t>(y, x) == 0) continue;
            const cv::Vec3f &b = placed_linear.at<cv::Vec3f>(y, x), &f = frame_linear.at<cv::Vec3f>(y, x);
            const cv::Vec3f gone = f - b - (light_map.at<cv::Vec3f>(y, x) - b) * veil.veil().at<float>(y, x);
            off += std::sqrt(gone.dot(gone));
            all += std::sqrt(f.dot(f));
        }
    return off / all;
}

/// How far the colours of bright tissue behind little smoke have gone apart from the baseline's, the smoke's own colour
/// removed: natural logarithm of the largest ratio between two channels.
double Estimator::State::tint() const {
    cv::Vec3d before(0, 0, 0), now(0, 0, 0);
    int pixels = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const cv::Vec3f &b = placed_linear.at<cv::Vec3f>(y, x), &f = frame_linear.at<cv::Vec3f>(y, x);
            const float density = veil.veil().at<float>(y, x);
            if (counts.at<float>(y, x) <= 0.0F || density > clear_veil || b[2] < lit) continue;
            before += b * (1.0F - density);
            now += f - light_map.at<cv::Vec3f>(y, x) * density;
            ++pixels;
        }
    if (pixels < least_tint_share * size.area()) return 0.0;
    double least = 1e9, most = -1e9;
    for (int k = 0; k < 3; ++k) {
        const double gain = std::log(gains[k] * std::max(now[k], 1e-6) / std::max(before[k], 1e-6));
        least = std::min(least, gain);
        most = std::max(most, gain);
    }
    return most - least;
}

void Estimator::State::judge(FrameAmounts& amounts, bool moved) const {
    if (moved) amounts.flags |= told::motion;
    if (cut_from_last()) amounts.flags |= told::cut;
    if (tint() > other_tint) amounts.flags |= told::tinted;
    if (bleached()) amounts.flags |= told::bleached;
    if (dark()) {
        amounts.flags |= told::dark;
        return;
    }
    const InView shown = trap_of(frame_code, whole);
    // Smoke may become so dense that no red is left; the tissue is still seen behind then.
    if (shown == InView::trocar || (shown == InView::bag && amounts.likeness < unlike)) {
        amounts.flags |= flag_of(shown);
        return;
    }
    const bool covered = share_of(valid, placed_counted) < least_valid || share_of(counted, view) < least_valid ||
                         cv::countNonZero(counts) < least_compared * cv::countNonZero(placed_counted);
    const bool strange =
        pale(unlike) || (amounts.likeness < unlike && share_of(foreign, placed_counted) > most_foreign);
    if (strange || covered || amounts.valid < 0.05) amounts.flags |= told::not_measurable;
    if (amounts.measurable() && amounts.likeness < nowhere) amounts.flags |= told::unregistered;
    if (amounts.measurable() && amounts.veil.value > dense_veil) amounts.flags |= told::dense;
}

/// Over what is neither blood nor an instrument, nor bright smoke.
void Estimator::State::see_veil() {
    aside = hazy & ~blood.blood();
    const cv::Scalar light = cv::mean(light_map, aside);
    figures.map = cv::mean(veil.veil(), aside)[0];
    figures.likeness = placement.likeness();  // the map compares pixels as the camera's motion lays them
    if (cv::countNonZero(aside) < least_part * size.area()) {  // too little is left to compare
        figures.statistics.fill(figures.map);
        return;
    }
    figures.statistics = statistics_of(appearance.find(placed_code, aside), appearance.find(frame_code, aside),
                                       {light[0], light[1], light[2]});
}

void Estimator::State::find_all_blood() {
    if (options.painted_blood)
        options.painted_blood->find(frame_code, clear_haze, all_blood);
    else if (!held.empty())
        cv::bitwise_or(blood.blood(), held, all_blood);
}

/// The densest of bright smoke is as foreign to the model of the veil as an instrument.
void Estimator::State::see_added_light() {
    aside = placed_counted & ~blood.blood();
    to_linear(laid_code, laid_linear);
    added = added_light.find(laid_linear, frame_linear, light_map, aside);
}

FrameAmounts Estimator::State::amounts_of(double time, bool moved) {
    FrameAmounts amounts;
    amounts.time = time;
    const double area = cv::countNonZero(valid);
    amounts.valid = area / size.area();
    amounts.likeness = likeness;
    amounts.rest = rest_share();
    amounts.hidden = share_of(blood.hidden(), valid);
    if (area > 0.0) {
        amounts.blood.value = share_of(counted_blood(), valid);
        amounts.veil.value = cv::mean(veil.veil(), valid)[0];
    }
    judge(amounts, moved);
    if (amounts.measurable() && laid_well()) {
        amounts.plume = Amount{.value = standing_out(veil.veil(), valid, sorted_veil)};
        set_plume_interval(*amounts.plume);
    }
    set_intervals(amounts);
    set_camera_intervals(amounts, added);
    if (options.painted_blood && amounts.measurable()) set_painted_interval(amounts.blood);
    // Where other tissue is compared its colour is another: that widened the intervals, and tells nothing of the
    // camera.
    if (!laid_well()) amounts.flags &= ~told::tinted;
    return amounts;
}

Estimator::Estimator(const Image& baseline, const EstimatorOptions& options)
    : state_(std::make_unique<State>(baseline, options)) {}
Estimator::Estimator(Estimator&&) noexcept = default;
Estimator& Estimator::operator=(Estimator&&) noexcept = default;
Estimator::~Estimator() = default;

void Estimator::set_blood(const BloodQualifier& blood) {
    state_->options.blood = blood;
}

bool Estimator::survey(const Image& frame) {
    State& s = *state_;
    if (s.options.survey) return false;
    s.take(frame);
    s.placement.follow(s.texture);
    s.lay_over();
    s.likeness = s.placement.likeness();  // the flow makes also what is foreign a little alike
    s.count();
    // What no veil explains says nothing yet: the light of the veil is what is looked for.
    if (s.dark() || s.bleached() || s.pale(another)) return false;
    s.overlay_survey.add(frame);
    s.overlay_known = false;
    cv::max(s.known.brightest, s.frame_code, s.brighter);
    s.brighter.copyTo(s.known.brightest, s.reach);
    s.see_view();
    s.lay_over();
    s.count();
    s.veil.solve_wide(s.placed_linear, s.frame_linear, s.counts, s.light_map, 2);
    if (cv::mean(s.veil.veil(), s.placed_counted)[0] < telling_veil) return true;  // too little smoke to learn from
    s.light_survey.add(s.placed_linear, s.frame_linear, s.counts, s.box);
    s.see_light(s.light_survey.found());
    return true;
}

std::shared_ptr<const Survey> Estimator::surveyed() const {
    State& s = *state_;
    if (s.options.survey) return s.options.survey;
    s.see_overlay();
    Survey found = s.known;
    found.brightest = s.known.brightest.clone();  // which the next frame changes
    return std::make_shared<const Survey>(std::move(found));
}

double Estimator::as_red_as_blood() const {
    const State& s = *state_;
    cv::Mat linear, redness;
    to_linear(s.code, linear);
    cv::GaussianBlur(linear, linear, {3, 3}, 0);
    redness_of(linear, redness);
    return share_of(redness >= s.options.blood.redness, s.counted);
}

FrameAmounts Estimator::measure(const Image& frame, double time) {
    State& s = *state_;
    s.see_overlay();
    s.take(frame);
    const bool moved = s.placement.follow(s.texture);
    s.lay_over();
    s.see_likeness();
    s.explain();
    s.see_added_light();
    s.find_all_blood();
    const FrameAmounts amounts = s.amounts_of(time, moved);
    s.texture.copyTo(s.last_texture);
    s.has_last = true;
    s.last_alike = s.placement.likeness() >= another;
    return amounts;
}

void Estimator::forget(const cv::Matx33d& place) {
    const double width = state_->size.width;
    state_->placement.forget(cv::Matx33d::diag({width, width, 1}) * place *
                             cv::Matx33d::diag({1 / width, 1 / width, 1}));
    state_->dense_flow.forget();
    state_->has_last = false;
}

cv::Size Estimator::working_size() const {
    return state_->size;
}
const cv::Mat& Estimator::blood() const {
    return state_->counted_blood();
}
const cv::Mat& Estimator::veil() const {
    return state_->veil.veil();
}
const cv::Mat& Estimator::valid() const {
    return state_->valid;
}
const cv::Mat& Estimator::light() const {
    return state_->light_map;
}
const cv::Mat& Estimator::baseline() const {
    return state_->placed_code;
}
const VeilFigures& Estimator::veil_figures() const {
    return state_->figures;
}

}  // namespace lapfx::match
