#include "match/fit/preview_curve.h"

#include <algorithm>
#include <future>

#include "lapfx/error.h"

namespace lapfx::match {

namespace {

constexpr int least_side = 16;  // px

/// Whether any of a grid of pixels shows the organ.
bool in_view(const Preview& preview, glm::ivec2 size) {
    constexpr int places = 32;  // of a side
    for (int y = 0; y < places; ++y)
        for (int x = 0; x < places; ++x)
            if (preview.pick((glm::dvec2(x, y) + 0.5) / double{places} * glm::dvec2(size), size)) return true;
    return false;
}

}  // namespace

glm::ivec2 preview_size(glm::dvec2 shape, double aspect) {
    shape = glm::max(shape, 1.0);
    if (aspect > 0.0) shape.x = aspect * shape.y;
    shape *= preview_side / std::max(shape.x, shape.y);
    return glm::max(glm::ivec2(glm::round(shape)), glm::ivec2(least_side));
}

PreviewCurve::PreviewCurve(std::shared_ptr<const PreparedOrgan> organ, PreviewOptions preview,
                           EstimatorOptions estimator, glm::ivec2 size)
    : organ_(std::move(organ)),
      preview_options_(std::move(preview)),
      estimator_options_(std::move(estimator)),
      size_(size) {
    estimator_options_.survey.reset();
}

void PreviewCurve::show(const Scene& scene, const Preset& preset) {
    if (preview_ && preview_->takes(scene)) {
        preview_->set_scene(scene);
        preview_->set_preset(preset);
    } else {
        preview_.reset();
        preview_ = std::make_unique<Preview>(scene, preset, organ_, preview_options_);
    }
}

std::optional<std::vector<FrameAmounts>> PreviewCurve::measure(const Scene& scene, const Preset& preset,
                                                               std::span<const double> times, const Progress& progress,
                                                               const FrameMeasured& measured) {
    Scene clear = scene;
    clear.events.clear();
    show(clear, preset);
    if (!in_view(*preview_, size_))
        throw Error(Failure::bad_input, Fault{.file = "", .place = "", .reason = "the organ is not in view"});
    Estimator estimator(preview_->image(0.0, size_), estimator_options_);
    preview_->set_contacts(scene.events);
    std::vector<Image> pictures(times.size());
    const auto drawn = [&](std::size_t i) -> Image& {
        if (pictures[i].pixels.empty()) pictures[i] = preview_->image(times[i], size_);
        return pictures[i];
    };
    const std::size_t surveyed = std::min<std::size_t>(surveyed_frames, times.size());
    for (std::size_t i = 0; i < surveyed; ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(times.size()))) return {};
        estimator.survey(drawn(i * times.size() / surveyed));
    }
    estimator.forget();
    std::vector<FrameAmounts> frames;
    std::future<void> measuring;  // one frame, while the next is drawn
    for (std::size_t i = 0; i < times.size(); ++i) {
        Image& picture = drawn(i);
        if (measuring.valid()) measuring.get();
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(times.size()))) return {};
        measuring = std::async(std::launch::async, [&, i, &picture = picture] {
            frames.push_back(estimator.measure(picture, times[i]));
            if (measured) measured(picture, &estimator, frames.back());
            picture = {};  // of a long scene there are many
        });
    }
    if (measuring.valid()) measuring.get();
    ++curves_;
    return frames;
}

}  // namespace lapfx::match
