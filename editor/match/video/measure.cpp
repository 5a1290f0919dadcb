#include "match/video/measure.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "lapfx/error.h"
#include "match/picture/seen_frame.h"

namespace lapfx::match {

namespace {

constexpr double find_share = 0.25;  // of the progress: shots and baselines
constexpr double mostly = 0.5;
constexpr double told_overlay = 0.002;  // of the picture: less may also be tissue that stands still
constexpr std::size_t kept = 4;         // estimators: shots alternate
// Of SeenFrame::haze: what moves without smoke changes it by 0.034 over 5 s in the median of 50 clear clips, by 0.066
// in one of ten.
constexpr double course_noise = 0.03;
constexpr std::size_t told_shots = 5;  // notes of one kind
constexpr double least_found_again = 0.5;

Error refused(const std::string& place, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = "", .place = place, .reason = reason}};
}

void reach(const Progress& progress, double share) {
    if (progress && !progress(share))
        throw Error(Failure::runtime, Fault{.file = "", .place = "", .reason = "measuring was stopped"});
}

void check_time(const VideoReader& video, const char* place, double time) {
    if (time >= 0.0 && time <= video.info().duration) return;
    throw refused(place, seconds_text(time) + " is outside the video (allowed: 0 to " +
                             seconds_text(video.info().duration) + ")");
}

void check(const VideoReader& video, const MeasureOptions& options) {
    const double to = options.to.value_or(video.info().duration);
    check_time(video, "from", options.from);
    check_time(video, "to", to);
    if (to < options.from) throw refused("to", seconds_text(to) + " is before from, " + seconds_text(options.from));
    if (options.baseline) check_time(video, "baseline", *options.baseline);
    if (options.strokes) check_times(video, *options.strokes);
    if (options.every < 1) throw refused("every", std::to_string(options.every) + " is below the minimum 1");
    if (video.info().frames == 1)
        throw refused("", "has one frame; measuring compares frames with a clear one of the same view");
}

std::ptrdiff_t count_of(const Measurement& found, unsigned flag) {
    return std::count_if(found.frames.begin(), found.frames.end(),
                         [flag](const FrameAmounts& f) { return (f.flags & flag) != 0; });
}

/// What the flags of the frames say, one line each.
void tell_flags(Measurement& found) {
    for (const ToldRow& row : told_rows) {
        const std::ptrdiff_t count = count_of(found, row.bit);
        if (count == 0) continue;
        found.notes.push_back(std::to_string(count) + " of " + std::to_string(found.frames.size()) +
                              " frames: " + std::string(row.help));
    }
}

void tell_overlay(Measurement& found) {
    const cv::Mat& overlay = found.survey->overlay;
    if (overlay.empty()) return;
    const int pixels = cv::countNonZero(overlay);
    if (pixels < told_overlay * static_cast<double>(overlay.total())) return;
    found.notes.push_back("Burnt-in text or a logo is left out: " +
                          percent_text(pixels / static_cast<double>(overlay.total())) + " of the picture.");
}

void tell_strokes(Measurement& found) {
    if (!found.painted) return;
    const auto without = found.painted->without_blood;
    found.notes.push_back(
        "Blood is all in view that looks as the strokes of " +
        (found.painted->file.empty() ? "the scene" : found.painted->file) + " say; " +
        (without ? "the frame at " + seconds_text(*without) + " counts as without blood."
                 : "no frame without blood is known, so what is doubtful is not counted (without_blood names one)."));
    const PaintedBlood& blood = *found.painted->blood;
    if (blood.found_without() > most_found_without)
        found.notes.push_back("Of the frame without blood " + percent_text(blood.found_without()) +
                              " is taken for blood all the same: as much may be false in others.");
    if (blood.found_again() < least_found_again)
        found.notes.push_back("Only " + percent_text(blood.found_again()) +
                              " of what the strokes mark as blood looks alike enough to be found again: mark blood "
                              "where it is plain to see, in a clearer frame, or more of it.");
}

/// Why the baseline that was given does not serve a shot, and what does.
std::string other_text(const Measurement& found, const Shot& shot) {
    return "the baseline at " + seconds_text(*found.baseline) + " does not show its tissue; " +
           (shot.baseline ? "it is compared with the frame at " + seconds_text(*shot.baseline) +
                                (found.painted ? "" : ", and blood that is there already is not seen")
                          : std::string(row_of(shot.why).help));
}

/// What is said of shots, once of each baseline.
void tell_shots(Measurement& found) {
    std::vector<std::string> notes;
    for (const Shot& shot : found.shots) {
        if (shot.other || shot.why == WithoutBaseline::hazy)
            notes.push_back(seconds_text(shot.from) + " to " + seconds_text(shot.to) + ": " +
                            (shot.other ? other_text(found, shot) : std::string(row_of(shot.why).help)) + ".");
        if (!shot.baseline || !shot.hazy) continue;
        std::string note = "The baseline at " + seconds_text(*shot.baseline) +
                           " may be hazy itself: smoke is what is denser than there.";
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
    }
    const std::size_t more = notes.size() - std::min(notes.size(), told_shots);
    notes.resize(notes.size() - more);
    if (more > 0) notes.push_back("The same of " + std::to_string(more) + " other shots or baselines.");
    found.notes.insert(found.notes.end(), notes.begin(), notes.end());
}

std::string with_baseline(const Measurement& found) {
    return found.baseline ? " with the baseline at " + seconds_text(*found.baseline) : "";
}

/// Every frame of one that has a course.
const Shot* longest_course(const Measurement& found) {
    const Shot* longest = nullptr;
    for (const Shot& shot : found.shots)
        if (shot.why == WithoutBaseline::hazy &&
            (longest == nullptr || shot.last - shot.first > longest->last - longest->first))
            longest = &shot;
    return longest;
}

/// When the veil of that shot starts, rises and clears; how dense it is nobody knows.
void sum_up_course(Measurement& found, const Shot& shot) {
    std::vector<FrameAmounts> frames;
    for (const FrameAmounts& f : found.frames)
        if (f.time >= shot.from && f.time <= shot.to) frames.push_back(f);
    found.veil = episode_of(frames, Curve::course);
    found.veil.peak = found.veil.mean = found.veil.area = std::nullopt;
    found.course_only = true;
    if (!found.veil.peak_at)
        found.notes.push_back("Veil: no change between " + seconds_text(shot.from) + " and " + seconds_text(shot.to) +
                              " beyond the error of measuring.");
}

std::ptrdiff_t count_of(const Measurement& found, Curve curve) {
    return std::count_if(found.frames.begin(), found.frames.end(),
                         [curve](const FrameAmounts& f) { return measurable(f, curve); });
}

[[noreturn]] void refuse_all(const Measurement& found) {
    if (found.baseline)
        throw refused("", "has no frame that is measurable" + with_baseline(found) +
                              ": none shows its tissue; choose a baseline or a part of one view");
    std::string why;
    for (const ToldRow& row : told_rows)
        if (const auto count = count_of(found, row.bit); (row.bit & told::unmeasured) != 0 && count > 0)
            why += (why.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(row.key);
    throw refused("", "has no frame that is measurable (of " + std::to_string(found.frames.size()) + " frames " + why +
                          "); choose a baseline or a part of one view");
}

void sum_up(Measurement& found) {
    const std::ptrdiff_t veils = count_of(found, Curve::veil), courses = count_of(found, Curve::course);
    if (veils + courses == 0) refuse_all(found);
    tell_strokes(found);
    tell_shots(found);
    tell_flags(found);
    tell_overlay(found);
    const double most = mostly * static_cast<double>(found.frames.size());
    if (static_cast<double>(veils) >= most) {
        if (static_cast<double>(count_of(found, Curve::blood)) >= most)
            found.blood = episode_of(found.frames, Curve::blood);
        found.veil = episode_of(found.frames, Curve::veil);
        if (found.blood.peak && !found.blood.peak_at)
            found.notes.emplace_back("Blood: as its intervals go, it may not change at all.");
        if (!found.veil.peak_at) found.notes.emplace_back("Veil: as its intervals go, it may not change at all.");
    } else if (courses > veils) {
        sum_up_course(found, *longest_course(found));
    } else {
        found.notes.insert(found.notes.begin(), "Most of this video is not measurable" + with_baseline(found) +
                                                    ": no peak, mean, onset or decay is given. Choose a baseline or a "
                                                    "part of one view.");
    }
}

/// So many frames of shots, evenly spread.
std::vector<int> spread_over(const std::vector<const Shot*>& shots, int most) {
    int count = 0;
    for (const Shot* shot : shots) count += shot->last - shot->first + 1;
    std::vector<int> frames;
    const int steps = std::min(most, count);
    for (int i = 0; i < steps; ++i) {
        int at = static_cast<int>(static_cast<long long>(i) * count / steps);
        for (const Shot* shot : shots) {
            const int length = shot->last - shot->first + 1;
            if (at < length) {
                frames.push_back(shot->first + at);
                break;
            }
            at -= length;
        }
    }
    return frames;
}

void survey(VideoReader& video, Estimator& estimator, const std::vector<int>& frames, const Progress& progress) {
    Image image;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        reach(progress, static_cast<double>(i) / static_cast<double>(frames.size()));
        if (video.read(frames[i], image)) estimator.survey(image);
    }
    estimator.forget();
}

/// The estimators of the shots' baselines.
class Estimators {
  public:
    Estimators(VideoReader& video, const EstimatorOptions& options, const std::vector<Shot>& shots)
        : video_(video), options_(options), shots_(shots) {}

    /// Holds until the next call. `progress` is asked whether to go on.
    Estimator& of(double baseline, const Progress& progress) {
        for (auto& [time, estimator] : made_)
            if (time == baseline) return estimator;
        Image image;
        if (!video_.read(video_.frame_at(baseline), image))
            throw refused("baseline", "the video cannot give its frame at " + seconds_text(baseline));
        if (made_.size() == kept) made_.erase(made_.begin());
        Estimator& made = made_.emplace_back(baseline, Estimator(image, options_)).second;
        std::vector<const Shot*> served;
        for (const Shot& shot : shots_)
            if (shot.baseline == baseline) served.push_back(&shot);
        if (!options_.survey) survey(video_, made, spread_over(served, surveyed_frames), progress);
        return made;
    }

  private:
    VideoReader& video_;
    const EstimatorOptions& options_;
    const std::vector<Shot>& shots_;
    std::vector<std::pair<double, Estimator>> made_;
};

/// A frame that no baseline serves: why, and how hazy it looks where that is asked for.
FrameAmounts unserved(const SeenFrame& seen, double time, bool with_course) {
    FrameAmounts amounts{.time = time, .flags = flag_of(seen.in_view)};
    if (amounts.flags != 0) return amounts;
    amounts.flags = told::no_baseline;
    if (with_course) amounts.course = Amount{seen.haze, seen.haze - course_noise, seen.haze + course_noise};
    return amounts;
}

/// Hazes of one shot, as 0 for its least and 1 for its most.
void order_course(std::span<FrameAmounts> shot) {
    double least = 1.0, most = 0.0;
    for (const FrameAmounts& f : shot)
        if (f.course) least = std::min(least, f.course->value), most = std::max(most, f.course->value);
    const double length = std::max(most - least, 1e-3);
    for (FrameAmounts& f : shot)
        if (f.course)
            for (double* value : {&f.course->value, &f.course->low, &f.course->high})
                *value = (*value - least) / length;
}

/// The frames of a video, shot by shot.
class Frames {
  public:
    Frames(VideoReader& video, const MeasureOptions& options, Measurement& found, const Progress& progress)
        : video_(video),
          options_(options),
          found_(found),
          progress_(progress),
          estimators_(video, options.estimator, found.shots) {}

    /// `frame`: the first that is measured. Gives the first of the next shot.
    int measure(const Shot& shot, int frame) {
        if (frame > shot.last) return frame;
        const std::size_t before = found_.frames.size();
        Estimator* const estimator =
            shot.baseline ? &estimators_.of(*shot.baseline, [this](double) { return go_on(share_); }) : nullptr;
        if (estimator != nullptr) {
            estimator->forget(shot.start);
            if (shot.baseline == found_.baseline) found_.survey = estimator->surveyed();
        }
        held_ = shot.other && estimator != nullptr && !found_.painted ? estimator->as_red_as_blood() : 0.0;
        last_.reset();
        bool cut = shot.cut;
        for (; frame <= shot.last; frame += options_.every) {
            const int first = found_.shots.front().first, last = found_.shots.back().last;
            share_ = find_share + (1.0 - find_share) * (frame - first) / std::max(last - first, 1);
            reach(progress_, share_);
            FrameAmounts amounts = amounts_of(shot, estimator, frame);
            if (cut && (amounts.flags & told::missing) == 0) amounts.flags |= told::cut, cut = false;
            found_.frames.push_back(amounts);
            if (options_.measured) options_.measured(image_, estimator, amounts);
        }
        order_course(std::span(found_.frames).subspan(before));
        return frame;
    }

  private:
    bool go_on(double share) const { return !progress_ || progress_(share); }
    FrameAmounts amounts_of(const Shot& shot, Estimator* estimator, int frame) {
        const double time = video_.time_of(frame);
        if (!video_.read(frame, image_)) return {.time = time, .flags = told::missing};
        if (estimator != nullptr) {
            FrameAmounts amounts = estimator->measure(image_, time);
            amounts.blood.high = std::min(amounts.blood.high + held_, 1.0);
            return amounts;
        }
        SeenFrame seen = look_at(image_);
        if (last_) tell_smoke_from_bag(*last_, seen);
        FrameAmounts amounts = unserved(seen, time, shot.why == WithoutBaseline::hazy);
        if (last_ && is_cut(*last_, seen, time - last_time_)) amounts.flags |= told::cut;
        last_ = std::move(seen);
        last_time_ = time;
        return amounts;
    }

    VideoReader& video_;
    const MeasureOptions& options_;
    Measurement& found_;
    const Progress& progress_;
    Estimators estimators_;
    Image image_;
    std::optional<SeenFrame> last_;  // of the same shot, without an estimator
    double last_time_ = 0.0;
    double held_ = 0.0;  // share of the view: as much blood may be in the baseline of a shot that another was given for
    double share_ = find_share;
};

}  // namespace

double hazeness_of(const Image& image) {
    return look_at(image).haze;
}

void survey(VideoReader& video, Estimator& estimator, double from, double to, const Progress& progress) {
    const Shot whole{.first = video.frame_at(from), .last = video.frame_at(to)};
    survey(video, estimator, spread_over({&whole}, surveyed_frames), progress);
}

double suggest_baseline(VideoReader& video, double from, double to, const Progress& progress) {
    const std::vector<Shot> shots = find_shots(video, from, to, {}, progress);
    const Shot& shot = *main_shot(shots);
    if (shot.baseline) return *shot.baseline;
    if (shot.clear) return *shot.clear;
    throw refused("", "has no frame that is measurable: " + std::string(row_of(shot.why).help));
}

std::shared_ptr<const PaintedBlood> painted_blood(const Measurement& measurement) {
    return measurement.painted ? measurement.painted->blood : nullptr;
}

std::string without_episode(const Measurement& measurement, Curve curve) {
    const std::ptrdiff_t count = count_of(measurement, curve);
    if (count == 0 || !measurement.veil.peak) return "not measurable";  // of the veil, a note says why
    return "measurable in " + std::to_string(count) + " of " + std::to_string(measurement.frames.size()) +
           " frames, too few for a peak";
}

Measurement measure(VideoReader& video, const MeasureOptions& options, const Progress& progress) {
    check(video, options);
    Measurement found;
    found.shots = find_shots(video, options.from, options.to.value_or(video.info().duration), options.baseline,
                             [&progress](double share) { return !progress || progress(find_share * share); });
    found.suggested = !options.baseline;
    found.baseline = options.baseline ? options.baseline : main_shot(found.shots)->baseline;
    MeasureOptions learned = options;
    if (options.strokes) {
        found.painted = learn_blood(video, *options.strokes, found.baseline, options.estimator);
        learned.estimator.painted_blood = found.painted->blood;
    }
    Frames frames(video, learned, found, progress);
    int frame = found.shots.front().first;
    for (const Shot& shot : found.shots) frame = frames.measure(shot, frame);
    sum_up(found);
    return found;
}

}  // namespace lapfx::match
