#include "bench/measure/each.h"

#include "match/video/measure.h"

namespace lapfx::bench {

namespace {

constexpr double between = 0.1;  // s

}  // namespace

void measure_each(
    const KnownView& view, const match::EstimatorOptions& options,
    const std::function<void(const KnownPicture&, const match::Estimator&, const match::FrameAmounts&)>& measured) {
    match::EstimatorOptions of_view = options;
    of_view.round_view = view.round_view;
    match::Estimator estimator(view.baseline, of_view);
    std::vector<const KnownPicture*> counted;
    for (const KnownPicture& known : view.pictures)
        if (known.counted) counted.push_back(&known);
    const std::size_t step = (counted.size() + match::surveyed_frames - 1) / match::surveyed_frames;
    for (std::size_t i = 0; i < counted.size(); i += step) estimator.survey(counted[i]->picture);
    estimator.forget();
    double time = 0.0;
    for (const KnownPicture& known : view.pictures) {
        if (!view.in_order) estimator.forget();
        const match::FrameAmounts amounts = estimator.measure(known.picture, time);
        time += between;
        if (known.counted) measured(known, estimator, amounts);
    }
}

}  // namespace lapfx::bench
