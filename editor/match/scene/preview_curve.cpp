#include "match/scene/preview_curve.h"

#include <algorithm>
#include <future>
#include <opencv2/imgproc.hpp>

#include "lapfx/error.h"
#include "match/scene/view_share.h"

namespace lapfx::match {

namespace {

constexpr int least_side = 16;  // px

Image resized(const Image& image, glm::ivec2 size) {
    Image made{.width = size.x, .height = size.y, .pixels = {}, .name = image.name};
    made.pixels.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4U);
    const cv::Mat from(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));  // is read
    cv::Mat into(size.y, size.x, CV_8UC4, made.pixels.data());
    cv::resize(from, into, into.size(), 0.0, 0.0, cv::INTER_LINEAR);
    return made;
}

/// Whether any of a grid of pixels shows the organ.
bool in_view(const Preview& preview, glm::ivec2 size) {
    constexpr int places = 32;  // of a side
    for (int y = 0; y < places; ++y)
        for (int x = 0; x < places; ++x)
            if (preview.pick((glm::dvec2(x, y) + 0.5) / double{places} * glm::dvec2(size), size)) return true;
    return false;
}

}  // namespace

glm::ivec2 preview_size(glm::dvec2 shape, double aspect, int side) {
    shape = glm::max(shape, 1.0);
    if (aspect > 0.0) shape.x = aspect * shape.y;
    shape *= side / std::max(shape.x, shape.y);
    return glm::max(glm::ivec2(glm::round(shape)), glm::ivec2(least_side));
}

PreviewCurve::Options PreviewCurve::options_for(glm::dvec2 stored, double aspect, EstimatorOptions estimator,
                                                int side) {
    Options options{.size = preview_size(stored, aspect, side), .estimator = std::move(estimator)};
    const glm::ivec2 as_stored = preview_size(stored, 0.0, side);
    if (as_stored == options.size) return options;
    // Nothing of what is stored may be lost: blood and smoke are told by fine detail, too.
    const glm::dvec2 larger = glm::dvec2(as_stored) / glm::dvec2(options.size);
    options.size = glm::ivec2(glm::round(glm::dvec2(options.size) * std::max(larger.x, larger.y)));
    options.measured = as_stored;
    return options;
}

PreviewCurve::PreviewCurve(std::shared_ptr<const PreparedOrgan> organ, PreviewOptions preview, Options options,
                           RenderThread render)
    : organ_(std::move(organ)),
      preview_options_(std::move(preview)),
      options_(std::move(options)),
      render_(std::move(render)) {}

std::size_t PreviewCurve::memory() const {
    return preview_ ? preview_->memory_use().clips + preview_->memory_use().targets : 0;
}

void PreviewCurve::take(const Scene& scene, const Preset& preset) {
    if (preview_ && preview_->takes(scene)) {
        preview_->set_scene(scene);
        preview_->set_preset(preset);
    } else {
        preview_.reset();
        preview_ = std::make_unique<Preview>(scene, preset, organ_, preview_options_);
    }
}

/// The scene before any tool has touched it.
void PreviewCurve::show(const Scene& scene, const Preset& preset) {
    Scene clear = scene;
    clear.events.clear();
    take(clear, preset);
    if (!in_view(*preview_, options_.size))
        throw Error(Failure::bad_input, Fault{.file = "", .place = "", .reason = "the organ is not in view"});
}

std::optional<Image> PreviewCurve::picture(const Scene& scene, const Preset& preset, double time, glm::ivec2 size) {
    Image picture;
    const bool drawn = draw([&] {
        take(scene, preset);
        picture = preview_->image(time, size);
    });
    return drawn ? std::optional(std::move(picture)) : std::nullopt;
}

/// The picture of that time as it is measured.
Image PreviewCurve::to_measure(double time) const {
    Image drawn = preview_->image(time, options_.size);
    return options_.measured.x > 0 ? resized(drawn, options_.measured) : drawn;
}

/// The pictures of one curve. Those that the survey has seen are kept until they are measured.
class PreviewCurve::Pictures {
  public:
    Pictures(const PreviewCurve& curve, std::span<const double> times)
        : curve_(curve), times_(times), drawn_(times.size()) {}

    std::size_t count() const { return times_.size(); }
    std::size_t surveyed() const { return std::min<std::size_t>(surveyed_frames, count()); }
    /// Null: it was stopped.
    Image* picture(std::size_t i) {
        Image& picture = drawn_[i];
        if (!picture.pixels.empty()) return &picture;
        return curve_.draw([&] { picture = curve_.to_measure(times_[i]); }) ? &picture : nullptr;
    }

  private:
    const PreviewCurve& curve_;
    std::span<const double> times_;
    std::vector<Image> drawn_;
};

/// Whether it came to its end.
bool PreviewCurve::survey(Pictures& pictures, Estimator& estimator,
                          const std::function<bool(std::size_t surveyed)>& goes_on) {
    const std::size_t surveyed = pictures.surveyed();
    std::future<void> surveying;  // one picture, while the next is drawn
    for (std::size_t i = 0; i < surveyed; ++i) {
        if (!goes_on(i)) return false;
        const Image* const picture = pictures.picture(i * pictures.count() / surveyed);
        if (picture == nullptr) return false;
        if (surveying.valid()) surveying.get();
        surveying = std::async(std::launch::async, [&estimator, picture] { estimator.survey(*picture); });
    }
    if (surveying.valid()) surveying.get();
    estimator.forget();
    return true;
}

std::optional<std::vector<FrameAmounts>> PreviewCurve::measure(const Scene& scene, const Preset& preset,
                                                               std::span<const double> times, const CurveCalls& calls) {
    EstimatorOptions of_estimator = options_.estimator;
    of_estimator.survey.reset();
    if (scene.plate.use) of_estimator.held_blood = plate_blood_;
    const glm::dvec2 shape(options_.size);
    of_estimator.still = !scene.plate.use;
    if (!scene.plate.use) {  // else as it is
        of_estimator.round_view = round_view_of(scene.camera, shape.x / shape.y);
        if (options_.measured.x > 0) of_estimator.round_aspect = shape.x / shape.y;
    }
    Image baseline;
    const bool clear = draw([&] {
        show(scene, preset);
        baseline = to_measure(0.0);
        preview_->set_contacts(scene.events);
    });
    if (!clear) return {};
    Estimator estimator(baseline, of_estimator);
    Pictures pictures(*this, times);
    // Those that are surveyed count twice, so that what is told never goes back.
    const auto goes_on = [&](std::size_t done) {
        const std::size_t all = pictures.surveyed() + times.size();
        return !calls.progress || calls.progress(static_cast<double>(done) / static_cast<double>(all));
    };
    if (!survey(pictures, estimator, goes_on)) return {};
    std::vector<FrameAmounts> frames;
    std::future<void> measuring;  // one frame, while the next is drawn
    for (std::size_t i = 0; i < times.size(); ++i) {
        Image* const picture = pictures.picture(i);
        if (picture == nullptr) return {};
        if (calls.drawn && !draw([&] { calls.drawn(*preview_, times[i]); })) return {};
        if (measuring.valid()) measuring.get();
        if (!goes_on(pictures.surveyed() + i)) return {};
        measuring = std::async(std::launch::async, [&, i, picture] {
            frames.push_back(estimator.measure(*picture, times[i]));
            if (calls.measured) calls.measured(*picture, &estimator, frames.back());
            *picture = {};  // of a long scene there are many
        });
    }
    if (measuring.valid()) measuring.get();
    ++curves_;
    return frames;
}

}  // namespace lapfx::match
