#include "match/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lapfx/error.h"

namespace lapfx::match {

namespace {

constexpr double hazy_baseline = 0.13;  // dark channel; clear frames of dark tissue have 0.04 to 0.08
constexpr double hazier = 0.04;         // than the clearest frame that was surveyed: pale tissue is in all of them
constexpr double survey_share = 0.25;   // of the progress
constexpr double mostly = 0.5;
constexpr double told_overlay = 0.002;  // of the picture: less may also be tissue that stands still

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
    if (options.every < 1) throw refused("every", std::to_string(options.every) + " is below the minimum 1");
    if (video.info().frames == 1)
        throw refused("", "has one frame; measuring compares frames with a clear one of the same view");
}

/// What the flags of the frames say, one line each.
void tell_flags(Measurement& found) {
    for (const ToldRow& row : told_rows) {
        const auto count = std::count_if(found.frames.begin(), found.frames.end(),
                                         [&row](const FrameAmounts& f) { return (f.flags & row.bit) != 0; });
        if (count == 0) continue;
        found.notes.push_back(std::to_string(count) + " of " + std::to_string(found.frames.size()) +
                              " frames: " + std::string(row.help));
    }
}

void tell_overlay(Measurement& found) {
    const cv::Mat& overlay = found.survey->overlay;
    const int pixels = overlay.empty() ? 0 : cv::countNonZero(overlay);
    if (pixels < told_overlay * static_cast<double>(overlay.total())) return;
    char text[96];
    std::snprintf(text, sizeof text, "Burnt-in text or a logo is left out: %.1f %% of the picture.",
                  100.0 * pixels / static_cast<double>(overlay.total()));
    found.notes.emplace_back(text);
}

void sum_up(Measurement& found) {
    const auto measurable =
        std::count_if(found.frames.begin(), found.frames.end(), [](const FrameAmounts& f) { return f.measurable(); });
    if (measurable == 0)
        throw refused("", "has no frame that is measurable with the baseline at " + seconds_text(found.baseline) +
                              ": none shows its tissue; choose a baseline or a part of one view");
    tell_flags(found);
    tell_overlay(found);
    const auto all = static_cast<double>(found.frames.size());
    if (static_cast<double>(measurable) < mostly * all) {
        found.notes.insert(found.notes.begin(),
                           "Most of this video is not measurable with the baseline at " + seconds_text(found.baseline) +
                               ": no peak, mean, onset or decay is given. Choose a baseline or a part of one view.");
        return;
    }
    const auto with_blood = std::count_if(found.frames.begin(), found.frames.end(),
                                          [](const FrameAmounts& f) { return f.blood_measurable(); });
    if (static_cast<double>(with_blood) >= mostly * all) found.blood = episode_of(found.frames, Curve::blood);
    found.veil = episode_of(found.frames, Curve::veil);
    if (found.blood.peak && !found.blood.peak_at)
        found.notes.emplace_back("Blood: no change beyond the error of measuring.");
    if (!found.veil.peak_at) found.notes.emplace_back("Veil: no change beyond the error of measuring.");
}

}  // namespace

std::string seconds_text(double time) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", time);
    return text;
}

double survey(VideoReader& video, Estimator& estimator, double from, double to, const Progress& progress) {
    const int first = video.frame_at(from), last = video.frame_at(to), count = last - first + 1;
    const int steps = std::min(surveyed_frames, count);
    Image image;
    double least = 1.0;
    for (int i = 0; i < steps; ++i) {
        reach(progress, static_cast<double>(i) / steps);
        const int frame = first + static_cast<int>(static_cast<long long>(i) * count / steps);
        if (video.read(frame, image) && estimator.survey(image)) least = std::min(least, hazeness_of(image));
    }
    estimator.forget();
    return least;
}

Measurement measure(VideoReader& video, const MeasureOptions& options, const Progress& progress) {
    check(video, options);
    const double to = options.to.value_or(video.info().duration);
    Measurement found;
    found.suggested = !options.baseline;
    found.baseline =
        options.baseline ? *options.baseline : suggest_baseline(video, options.from, to, [&progress](double share) {
            return !progress || progress(0.5 * survey_share * share);
        });
    Image image;
    if (!video.read(video.frame_at(found.baseline), image))
        throw refused("baseline", "the video cannot give its frame at " + seconds_text(found.baseline));
    Estimator estimator(image, options.estimator);
    const double haze = hazeness_of(image);
    double clearest = haze;
    if (!options.estimator.survey)
        clearest = survey(video, estimator, options.from, to, [&progress](double share) {
            return !progress || progress(survey_share * (0.5 + 0.5 * share));
        });
    if (haze > std::max(hazy_baseline, clearest + hazier))
        found.notes.push_back("The baseline at " + seconds_text(found.baseline) +
                              " may be hazy itself: smoke is what is denser than there.");
    const int first = video.frame_at(options.from), last = video.frame_at(to);
    const int step = std::max(options.every, 1), count = (last - first) / step + 1;
    found.survey = estimator.surveyed();

    found.frames.reserve(static_cast<std::size_t>(count));
    Image drawn;  // a copy: what is drawn on is not read again
    for (int frame = first; frame <= last; frame += step) {
        reach(progress, survey_share + (1.0 - survey_share) * (frame - first) / std::max(last - first, 1));
        const bool good = video.read(frame, image);
        const double time = video.time_of(frame);
        const FrameAmounts amounts =
            good ? estimator.measure(image, time) : FrameAmounts{.time = time, .flags = told::missing};
        found.frames.push_back(amounts);
        if (options.measured) options.measured(drawn = image, estimator, amounts);
    }
    sum_up(found);
    return found;
}

}  // namespace lapfx::match
