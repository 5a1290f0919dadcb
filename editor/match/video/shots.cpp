#include "match/video/shots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <string>

#include "lapfx/error.h"
#include "match/picture/colors.h"
#include "match/picture/instruments.h"
#include "match/picture/placement.h"
#include "match/picture/seen_frame.h"

namespace lapfx::match {

namespace {

constexpr int least_samples = 48;
constexpr double apart = 1.0;         // s between samples, as far as there are no more than
constexpr int most_samples = 1000;    // which take 100 MB
constexpr double same_view = 0.3;     // likeness of two samples between which no cut is looked for
constexpr double least_shot = 1.0;    // s, and
constexpr double least_share = 0.25;  // of a short video: a shot that is as long has a baseline of its own
constexpr float blood_redness = 3.0F;
constexpr std::size_t compared = 12;    // frames of a shot, with what may be their baseline
constexpr std::size_t candidates = 12;  // of a shot, for its baseline
constexpr double followed_likeness = 0.25;
constexpr int most_lost = 3;           // frames one after the other
constexpr double well_seen = 0.5;      // of the frames that are compared
constexpr double nearly_clear = 0.16;  // of clearness: as much as instruments on a sixth of the view take
constexpr double no_hazier = 0.01;     // SeenFrame::haze: no more than from one clear frame to the next
constexpr double enough_alike = 0.34;  // of them: for the baseline of another shot

// Haze of a clear frame (SeenFrame::haze, SeenFrame::reddest): 0.08 to 0.27 and below -0.75 in clear frames of four
// operations, 0.24 to 0.36 and above -0.6 in smoke. Pale tissue has much of the first, and still some red parts.
constexpr double hazy = 0.13, hazier = 0.04;  // the second: than the clearest of the same shot
constexpr double pale_haze = 0.20, pale_red = -0.70;
// The clearest frame of video01_295, of pale tissue and little smoke, has 0.267 and -0.516; those of 296, 289 and 297,
// in smoke, 0.289 to 0.315 and -0.48 to -0.43.
constexpr double too_pale_haze = 0.28, too_pale_red = -0.5;

struct Sample {
    int frame = 0;
    SeenFrame seen;
    double clear = -std::numeric_limits<double>::infinity();  // of what shows no tissue
};

bool is_tissue(const Sample& sample) {
    return sample.seen.in_view == InView::tissue;
}

void reach(const Progress& progress, double share) {
    if (progress && !progress(share))
        throw Error(Failure::runtime, Fault{.file = "", .place = "", .reason = "measuring was stopped"});
}

double share(const cv::Mat& part, const cv::Mat& whole) {
    return static_cast<double>(cv::countNonZero(part & whole)) / std::max(cv::countNonZero(whole), 1);
}

/// How good a baseline a frame would be: little haze, blood and instruments, much detail.
double clearness_of(const SeenFrame& seen) {
    cv::Mat luma, dx, dy, linear, redness;
    cv::cvtColor(seen.code, luma, cv::COLOR_BGR2GRAY);
    cv::Sobel(luma, dx, CV_32F, 1, 0);
    cv::Sobel(luma, dy, CV_32F, 0, 1);
    cv::magnitude(dx, dy, dx);
    to_linear(seen.code, linear);
    redness_of(linear, redness);
    const double detail = std::log(std::max(cv::mean(dx, seen.view)[0], 1.0));
    const double blood = share(redness > blood_redness, seen.view);
    const double instruments = share(instruments_of(seen.code, seen.view), seen.view);
    return 0.3 * detail - 4.0 * seen.haze - blood - instruments;
}

/// Frames spread evenly; those that the file cannot give are left out.
std::vector<Sample> samples_of(VideoReader& video, int first, int last, const Progress& progress) {
    const int count = last - first + 1;
    const double length = video.time_of(last) - video.time_of(first);
    const int steps = std::min(count, std::clamp(static_cast<int>(length / apart), least_samples, most_samples));
    std::vector<Sample> samples;
    Image image;
    for (int i = 0; i < steps; ++i) {
        reach(progress, static_cast<double>(i) / steps);
        const int frame = first + static_cast<int>(static_cast<long long>(i) * count / steps);
        if (!video.read(frame, image)) continue;
        Sample& sample = samples.emplace_back(Sample{.frame = frame, .seen = look_at(image)});
        if (samples.size() > 1) tell_smoke_from_bag(samples[samples.size() - 2].seen, sample.seen);
        if (is_tissue(sample)) sample.clear = clearness_of(sample.seen);
    }
    return samples;
}

/// A stretch that is no Shot yet.
struct Stretch {
    int first = 0;
    InView in_view = InView::dark;
    bool cut = false;
    std::vector<const Sample*> samples = {};
};

/// Where something else begins between two samples, frame by frame.
void find_starts(VideoReader& video, const Sample& from, const Sample& to, std::vector<Stretch>& found) {
    Image image;
    SeenFrame last = from.seen;
    double last_time = video.time_of(from.frame);
    for (int frame = from.frame + 1; frame <= to.frame; ++frame) {
        if (frame < to.frame && !video.read(frame, image)) continue;
        SeenFrame now = frame < to.frame ? look_at(image) : to.seen;
        tell_smoke_from_bag(last, now);
        const double time = video.time_of(frame);
        const bool cut = is_cut(last, now, time - last_time);
        if (cut || now.in_view != last.in_view) found.push_back({.first = frame, .in_view = now.in_view, .cut = cut});
        last = std::move(now);
        last_time = time;
    }
}

std::vector<Stretch> stretches_of(VideoReader& video, int first, const std::vector<Sample>& samples,
                                  const Progress& progress) {
    std::vector<Stretch> found = {{.first = first, .in_view = samples.front().seen.in_view}};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        reach(progress, static_cast<double>(i) / static_cast<double>(samples.size()));
        if (i > 0) {
            const Sample &a = samples[i - 1], &b = samples[i];
            if (a.seen.in_view != b.seen.in_view || likeness(a.seen, b.seen) < same_view)
                find_starts(video, a, b, found);
        }
        found.back().samples.push_back(&samples[i]);
    }
    return found;
}

/// At most so many, evenly spread.
std::vector<const Sample*> thinned(const std::vector<const Sample*>& samples, std::size_t most) {
    if (samples.size() <= most) return samples;
    std::vector<const Sample*> kept;
    for (std::size_t i = 0; i < most; ++i) kept.push_back(samples[i * samples.size() / most]);
    return kept;
}

/// The share of some frames that show the tissue of one.
double seen_of(const SeenFrame& seen, const std::vector<const Sample*>& samples) {
    const auto count = std::count_if(samples.begin(), samples.end(),
                                     [&seen](const Sample* sample) { return shows_tissue_of(seen, sample->seen); });
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(samples.size(), 1));
}

/// Looks for the tissue of one frame in others, in their order, from each to the next; not past a gap. Gives in how
/// many it is seen.
template <typename Forward>
int follow(Placement& placement, Forward from, Forward to) {
    int seen = 0, lost = 0;
    for (; from != to && lost < most_lost; ++from) {
        placement.follow((*from)->seen.texture);
        const bool there = placement.likeness() > followed_likeness;
        seen += there ? 1 : 0;
        lost = there ? 0 : lost + 1;
    }
    return seen;
}

/// Where the baseline lies in the first frame of its own shot.
cv::Matx33d start_of(const SeenFrame& baseline, int frame, const std::vector<const Sample*>& shot) {
    Placement placement(baseline.texture, baseline.view);
    const auto after = std::find_if(shot.rbegin(), shot.rend(), [frame](const Sample* s) { return s->frame <= frame; });
    const auto before = static_cast<int>(shot.rend() - after);
    if (before == 0 || follow(placement, after, shot.rend()) < well_seen * before) return cv::Matx33d::eye();
    const double width = baseline.texture.cols;
    return cv::Matx33d::diag({1 / width, 1 / width, 1}) * placement.place() * cv::Matx33d::diag({width, width, 1});
}

double least_haze(const std::vector<const Sample*>& samples, double otherwise) {
    for (const Sample* sample : samples) otherwise = std::min(otherwise, sample->seen.haze);
    return otherwise;
}

bool is_hazy(const SeenFrame& seen, const std::vector<const Sample*>& shot) {
    return seen.haze > std::max(hazy, least_haze(shot, seen.haze) + hazier) ||
           (seen.haze > pale_haze && seen.reddest > pale_red);
}

bool is_too_hazy(const SeenFrame& seen) {
    return seen.haze > too_pale_haze && seen.reddest > too_pale_red;
}

/// In which share of a shot's frames the tissue of one of them is found again.
double followed_share(const std::vector<const Sample*>& frames, std::size_t i) {
    const auto back = static_cast<std::ptrdiff_t>(frames.size() - i);
    Placement placement(frames[i]->seen.texture, frames[i]->seen.view);
    int all = follow(placement, frames.begin() + static_cast<std::ptrdiff_t>(i), frames.end());
    placement.forget();
    all += follow(placement, frames.rbegin() + back, frames.rend());
    return all / static_cast<double>(frames.size());
}

/// The earliest frame that is nearly as clear as one that would do: blood grows, so the less of it is there already.
const Sample* earliest_like(const Sample* one, const std::vector<const Sample*>& frames) {
    std::size_t tried = 0;
    for (std::size_t i = 0; i < frames.size() && frames[i]->frame < one->frame && tried < candidates; ++i) {
        const SeenFrame& seen = frames[i]->seen;
        if (frames[i]->clear < one->clear - nearly_clear || seen.haze > one->seen.haze + no_hazier) continue;
        if (is_hazy(seen, frames) && !is_hazy(one->seen, frames)) continue;
        if (is_too_hazy(seen) && !is_too_hazy(one->seen)) continue;
        ++tried;
        if (followed_share(frames, i) >= well_seen) return frames[i];
    }
    return one;
}

/// The clearest frame whose tissue can be followed over most of the shot, or an earlier one that is nearly as clear;
/// where there is none such, the clearest of those that can be followed farthest. Null: the shot has no frame.
const Sample* clearest_of(const std::vector<const Sample*>& shot) {
    const std::vector<const Sample*> frames = thinned(shot, static_cast<std::size_t>(least_samples));
    std::vector<std::size_t> clear(frames.size());
    std::iota(clear.begin(), clear.end(), std::size_t{0});
    std::stable_sort(clear.begin(), clear.end(),
                     [&](std::size_t a, std::size_t b) { return frames[a]->clear > frames[b]->clear; });
    clear.resize(std::min(clear.size(), candidates));
    std::vector<double> seen;
    for (const std::size_t i : clear) {
        seen.push_back(followed_share(frames, i));
        if (seen.back() >= well_seen) return earliest_like(frames[i], frames);
    }
    if (seen.empty()) return nullptr;
    const double most = *std::max_element(seen.begin(), seen.end());
    const auto best = std::find_if(seen.begin(), seen.end(), [most](double share) { return share >= 0.8 * most; });
    return frames[clear[static_cast<std::size_t>(best - seen.begin())]];
}

WithoutBaseline reason_of(InView shown) {
    switch (shown) {
        case InView::bag:
            return WithoutBaseline::bag;
        case InView::trocar:
            return WithoutBaseline::trocar;
        case InView::dark:
            return WithoutBaseline::dark;
        case InView::tissue:
            break;
    }
    return WithoutBaseline::brief;
}

/// A frame that may serve shots.
struct Offer {
    int frame = 0;
    double time = 0.0;  ///< s
    const SeenFrame* seen = nullptr;
    bool suggested = true;
};

/// Shots and what is known of each, side by side.
struct ShotsSoFar {
    std::vector<Shot> shots;
    std::vector<std::vector<const Sample*>> samples;
    std::vector<const SeenFrame*> baselines;  ///< of the baseline; null without one

    void take(std::size_t i, const Offer& offer) {
        shots[i].baseline = offer.time;
        shots[i].suggested = offer.suggested;
        shots[i].other = shots[i].other && offer.suggested;
        shots[i].why = WithoutBaseline::has_one;
        shots[i].hazy = is_hazy(*offer.seen, samples[i]);
        if (shots[i].first <= offer.frame && offer.frame <= shots[i].last)
            shots[i].start = start_of(*offer.seen, offer.frame, samples[i]);
        baselines[i] = offer.seen;
    }
};

/// The clearest frame of each shot that is long enough, where it is clear enough.
void propose(VideoReader& video, double least, ShotsSoFar& found) {
    for (std::size_t i = 0; i < found.shots.size(); ++i) {
        Shot& shot = found.shots[i];
        if (shot.baseline || shot.why != WithoutBaseline::brief || shot.to - shot.from < least) continue;
        const Sample* const best = clearest_of(found.samples[i]);
        if (best == nullptr) continue;
        shot.clear = video.time_of(best->frame);
        if (is_too_hazy(best->seen))
            shot.why = WithoutBaseline::hazy;
        else
            found.take(i, {.frame = best->frame, .time = *shot.clear, .seen = &best->seen});
    }
}

/// A shot without a baseline, or with a hazy one, takes that of another shot that shows its tissue.
void share_baselines(const VideoReader& video, ShotsSoFar& found) {
    std::vector<Offer> offers;
    for (std::size_t i = 0; i < found.shots.size(); ++i)
        if (found.baselines[i] != nullptr)
            offers.push_back({.frame = video.frame_at(*found.shots[i].baseline),
                              .time = *found.shots[i].baseline,
                              .seen = found.baselines[i],
                              .suggested = found.shots[i].suggested});
    std::stable_sort(offers.begin(), offers.end(),
                     [](const Offer& a, const Offer& b) { return a.seen->haze < b.seen->haze; });
    for (std::size_t i = 0; i < found.shots.size(); ++i) {
        const Shot& shot = found.shots[i];
        const bool wants =
            shot.baseline ? shot.suggested : shot.why == WithoutBaseline::brief || shot.why == WithoutBaseline::hazy;
        if (!wants) continue;
        for (const Offer& offer : offers) {
            if (found.baselines[i] != nullptr && offer.seen->haze + hazier > found.baselines[i]->haze) break;
            if (seen_of(*offer.seen, thinned(found.samples[i], compared)) < enough_alike) continue;
            found.take(i, offer);
            break;
        }
    }
}

/// Stretches that nothing can be said of become one with those beside them, under the reason of the longest.
std::vector<Shot> joined(const std::vector<Shot>& shots) {
    std::vector<Shot> made;
    int longest = 0;
    for (const Shot& shot : shots) {
        const int length = shot.last - shot.first;
        const auto says_nothing = [](const Shot& s) { return !s.baseline && s.why != WithoutBaseline::hazy; };
        if (made.empty() || !says_nothing(shot) || !says_nothing(made.back())) {
            made.push_back(shot);
            longest = length;
            continue;
        }
        made.back().last = shot.last;
        made.back().to = shot.to;
        if (length > longest) made.back().why = shot.why, made.back().other = shot.other;
        longest = std::max(longest, length);
    }
    return made;
}

ShotsSoFar shots_of(VideoReader& video, const std::vector<Stretch>& stretches, int last) {
    ShotsSoFar found;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const Stretch& stretch = stretches[i];
        const int end = i + 1 < stretches.size() ? stretches[i + 1].first - 1 : last;
        found.shots.push_back({.first = stretch.first,
                               .last = end,
                               .from = video.time_of(stretch.first),
                               .to = video.time_of(end),
                               .cut = stretch.cut,
                               .why = reason_of(stretch.in_view)});
        found.samples.push_back(stretch.samples);
        found.baselines.push_back(nullptr);
    }
    return found;
}

}  // namespace

const WithoutBaselineRow& row_of(WithoutBaseline why) {
    for (const WithoutBaselineRow& row : without_baseline_rows)
        if (row.why == why) return row;
    return without_baseline_rows[0];
}

std::vector<Shot> find_shots(VideoReader& video, double from, double to, std::optional<double> baseline,
                             const Progress& progress) {
    const int first = video.frame_at(from), last = video.frame_at(to);
    const auto part = [&progress](double start, double length) {
        return [&progress, start, length](double done) { return !progress || progress(start + length * done); };
    };
    const std::vector<Sample> samples = samples_of(video, first, last, part(0.0, 0.6));
    if (samples.empty() ||
        std::all_of(samples.begin(), samples.end(), [](const Sample& s) { return s.seen.in_view == InView::dark; }))
        throw Error(
            Failure::bad_input,
            Fault{.file = "", .place = "", .reason = "has no frame that shows anything: all are black or missing"});
    ShotsSoFar found = shots_of(video, stretches_of(video, first, samples, part(0.6, 0.4)), last);
    std::optional<SeenFrame> given;
    if (baseline) {
        Image image;
        const int frame = video.frame_at(*baseline);
        if (!video.read(frame, image))
            throw Error(Failure::bad_input,
                        Fault{.file = "",
                              .place = "baseline",
                              .reason = "the video cannot give its frame at " + seconds_text(*baseline)});
        given = look_at(image);
        const Offer offer{.frame = frame, .time = *baseline, .seen = &*given, .suggested = false};
        for (std::size_t i = 0; i < found.shots.size(); ++i) {
            Shot& shot = found.shots[i];
            const bool own = shot.first <= frame && frame <= shot.last, tissue = shot.why == WithoutBaseline::brief;
            if (own || (tissue && seen_of(*offer.seen, thinned(found.samples[i], compared)) >= enough_alike))
                found.take(i, offer);
            else
                shot.other = tissue;
        }
    }
    propose(video, std::min(least_shot, least_share * (video.time_of(last) - video.time_of(first))), found);
    share_baselines(video, found);
    return joined(found.shots);
}

const Shot* main_shot(const std::vector<Shot>& shots) {
    const auto weight = [](const Shot& shot) { return std::pair(shot.baseline.has_value(), shot.last - shot.first); };
    const auto longest = std::max_element(shots.begin(), shots.end(),
                                          [&](const Shot& a, const Shot& b) { return weight(a) < weight(b); });
    return longest == shots.end() ? nullptr : &*longest;
}

std::string seconds_text(double time) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", time);
    return text;
}

std::string percent_text(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
    return text;
}

}  // namespace lapfx::match
