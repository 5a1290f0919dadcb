#include "match/use/measure_video.h"

#include <algorithm>
#include <utility>

namespace lapfx::match {

namespace {

constexpr std::size_t least_corners = 3;  // of a polygon

}  // namespace

BloodStrokes painted_strokes(const ReferenceMeasure& measure) {
    BloodStrokes made{.file = "", .place = "/reference/measure", .without_blood = {}, .strokes = measure.strokes};
    if (measure.without_blood >= 0.0) made.without_blood = measure.without_blood;
    return made;
}

bool paints_blood(const ReferenceMeasure& measure) {
    return std::ranges::any_of(measure.strokes, [](const BloodStroke& stroke) {
        return stroke.marks == StrokeMark::blood && !stroke.points.empty();
    });
}

std::optional<BloodStrokes> learned_strokes(const ReferenceMeasure& measure) {
    return paints_blood(measure) ? std::optional(painted_strokes(measure)) : std::nullopt;
}

MeasureOptions measure_options(const ReferenceMeasure& measure) {
    MeasureOptions options;
    const MeasuredRegion& region = measure.region;
    options.estimator.blood = measure.blood;
    options.estimator.region = {region.x, region.y, std::min(region.width, 1 - region.x),
                                std::min(region.height, 1 - region.y)};
    for (const LeftOutPart& part : measure.parts) {
        if (part.corners.size() < least_corners) continue;
        MaskPolygon& mask = options.estimator.masks.emplace_back();
        for (const PicturePlace& corner : part.corners) mask.emplace_back(corner.x, corner.y);
    }
    if (measure.baseline > 0) options.baseline = measure.baseline;
    options.from = measure.from;
    if (measure.to > 0) options.to = measure.to;
    options.strokes = learned_strokes(measure);
    return options;
}

MeasuredVideo measure_video(VideoReader& video, VideoMeasuring how, const Progress& progress) {
    PeakColors peaks;
    if (how.colors_of) peaks = PeakColors(how.colors_of->from, how.colors_of->to);
    const auto over_time = how.colors_over_time ? std::make_shared<ColorsOverTime>() : nullptr;
    if (how.colors_of || over_time)
        how.options.measured = [&, also = std::move(how.options.measured)](
                                   const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
            if (how.colors_of) peaks.add(frame, estimator, amounts);
            if (over_time) over_time->add(frame, estimator, amounts);
            if (also) also(frame, estimator, amounts);
        };
    Measurement found = measure(video, how.options, progress);
    return {.found = std::move(found), .colors = peaks.at_peak(), .colors_over_time = over_time};
}

MeasuredVideo measure_video(const std::filesystem::path& file, VideoMeasuring how, const Progress& progress,
                            const std::atomic<bool>* stop) {
    VideoReader video(file, stop);
    return measure_video(video, std::move(how), progress);
}

}  // namespace lapfx::match
