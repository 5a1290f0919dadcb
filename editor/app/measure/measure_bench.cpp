#include "app/measure/measure_bench.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/preview/pick_color.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "match/frame/counted.h"
#include "match/picture/colors.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr int steady_frames = 3;  // so many frames on, the camera's way is still followed

constexpr double redness_share = 0.8, brightness_share = 1.2;  // factors on the picked colour: blood around it varies
constexpr double least_red = 1.4;                              // redness below which a colour is not red
constexpr double most_veil = 0.85;                             // what is behind more smoke than that is not seen

bool same_opened(const std::weak_ptr<const VideoReader>& a, const std::weak_ptr<const VideoReader>& b) {
    return !a.owner_before(b) && !b.owner_before(a);
}

}  // namespace

struct MeasureBench::Request {
    fs::path file;  ///< empty: nothing is to be shown
    std::weak_ptr<const VideoReader> opened;
    int frame = -1;
    double time = 0;
    ReferenceMeasure measure;
    std::shared_ptr<const match::Survey> survey;
    bool blood = true, smoke = true, left_out = true;
    std::optional<double> suggested;  ///< the baseline, where it is known already; changes nothing
    std::shared_ptr<const Image> image;
    bool good = true;  ///< the file could give it

    bool same_video(const Request& o) const { return file == o.file && same_opened(opened, o.opened); }
    /// All but the frame and the qualifier of the blood.
    bool same_estimator(const Request& o) const {
        ReferenceMeasure other = o.measure;
        other.blood = measure.blood;
        return same_video(o) && survey == o.survey && equal(measure_table(), &measure, &other);
    }
    bool same_measure(const Request& o) const {
        return same_video(o) && frame == o.frame && survey == o.survey && equal(measure_table(), &measure, &o.measure);
    }
    friend bool operator==(const Request& a, const Request& b) {
        return a.same_measure(b) && a.blood == b.blood && a.smoke == b.smoke && a.left_out == b.left_out;
    }
};

struct MeasureBench::Result {
    Image picture;
    std::shared_ptr<const Image> frame;
    match::FrameAmounts amounts;
    cv::Mat veil, light;  ///< CV_32F and CV_32FC3, at the estimator's size
    double baseline = 0;
    bool by_strokes = false;
    std::vector<Fault> stroke_faults;
};

/// The frame's own pixels, sampled as if it were of the size that is shown.
class MeasureBench::Pixels : public ui::PickSource {
  public:
    std::shared_ptr<const Image> frame;
    glm::ivec2 size{1};
    cv::Mat veil, light;

    glm::vec4 pixel(glm::ivec2 at) const override {
        if (!frame) return {};
        const glm::dvec2 scale = glm::dvec2(frame->width, frame->height) / glm::dvec2(size);
        return pixel_of(*frame, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
    }
    /// Without the smoke before it; sRGB, each 0..1.
    glm::dvec3 unveiled(glm::dvec3 color, glm::ivec2 at) const {
        if (veil.empty()) return color;
        const glm::dvec2 place = (glm::dvec2(at) + 0.5) / glm::dvec2(size);
        const glm::ivec2 cell = glm::clamp(glm::ivec2(place * glm::dvec2(veil.cols, veil.rows)), glm::ivec2(0),
                                           glm::ivec2(veil.cols - 1, veil.rows - 1));
        const double density = std::clamp(static_cast<double>(veil.at<float>(cell.y, cell.x)), 0.0, most_veil);
        const auto& smoke = light.at<cv::Vec3f>(cell.y, cell.x);
        const glm::dvec3 added = glm::dvec3(smoke[2], smoke[1], smoke[0]) * density;
        for (int c = 0; c < 3; ++c) {
            const double linear = match::linear_of(static_cast<float>(255 * color[c]));
            const double clear = std::clamp((linear - added[c]) / (1 - density), 0.0, 1.0);
            color[c] = match::code_of(static_cast<float>(clear)) / 255.0;
        }
        return color;
    }
};

/// What lies between a request and its picture; used by one thread at a time.
class MeasureWork {
  public:
    using Request = MeasureBench::Request;
    using Result = MeasureBench::Result;

    /// Throws Error.
    Result run(const Request& request, Job& job) {
        prepare(request, job);
        if (!done_ || !done_->same_measure(request)) {
            const bool steady =
                done_ && done_->same_estimator(request) && std::abs(done_->frame - request.frame) <= steady_frames;
            if (!steady) estimator_->forget();
            estimator_->set_blood(request.measure.blood);
            amounts_ = estimator_->measure(*request.image, request.time);
        }
        done_ = request;
        done_->image.reset();
        return {.picture = composed(request),
                .frame = request.image,
                .amounts = amounts_,
                .veil = estimator_->veil().clone(),
                .light = estimator_->light().clone(),
                .baseline = baseline_,
                .by_strokes = painted_ != nullptr,
                .stroke_faults = stroke_faults_};
    }

    int decoded() const { return decoded_; }  ///< frames of baselines

  private:
    void prepare(const Request& request, Job& job) {
        if (estimator_ && done_ && done_->same_estimator(request)) return;
        done_.reset();
        estimator_.reset();
        if (!reader_ || !same_opened(opened_, request.opened)) {
            reader_.emplace(request.file, &job.stop());
            opened_ = request.opened;
            suggested_.reset();
            learnt_.reset();
            clear_ = {};
        }
        find_baseline(request, job);
        find_clear(request, job);
        make_estimator(request, *clear_.image, job);
    }
    /// The baseline's frame is decoded once: not where it is the one that is shown, nor for another region or part.
    void find_clear(const Request& request, Job& job) {
        const int frame = reader_->frame_at(baseline_);
        if (clear_.image && clear_.frame == frame) return;
        if (request.frame == frame && request.good) {
            clear_ = {frame, request.image};
            return;
        }
        auto image = std::make_shared<Image>();
        const bool good = reader_->read(frame, *image, &job.stop());
        clear_ = {good ? frame : -1, std::move(image)};
        ++decoded_;
    }
    /// What one knows about the video holds for other regions and parts, too.
    void make_estimator(const Request& request, const Image& clear, Job& job) {
        const ReferenceMeasure& measure = request.measure;
        match::EstimatorOptions options = match::measure_options(measure).estimator;
        const bool learnt =
            learnt_ && learnt_->baseline == baseline_ && learnt_->from == measure.from && learnt_->to == measure.to;
        options.survey = request.survey || !learnt ? request.survey : learnt_->survey;
        learn_blood(measure, options);
        options.painted_blood = painted_;
        estimator_.emplace(clear, options);
        if (options.survey) return;
        match::survey(*reader_, *estimator_, measure.from, end_of(measure), progress_of(job));
        learnt_ = {baseline_, measure.from, measure.to, estimator_->surveyed()};
    }
    /// One who paints sees the picture all the while, also before the first strokes are enough to learn from.
    void learn_blood(const ReferenceMeasure& measure, const match::EstimatorOptions& options) {
        painted_.reset();
        stroke_faults_.clear();
        const std::optional<match::BloodStrokes> strokes = match::learned_strokes(measure);
        if (!strokes) return;
        try {
            painted_ = match::learn_blood(*reader_, *strokes, baseline_, options).blood;
        } catch (const Error& error) {
            stroke_faults_ = error.faults();
        }
    }
    double end_of(const ReferenceMeasure& measure) const {
        return measure.to > 0 ? measure.to : reader_->info().duration;
    }
    static Progress progress_of(Job& job) {
        return [&job](double share) {
            job.set_progress(share);
            return !job.cancelled();
        };
    }
    void find_baseline(const Request& request, Job& job) {
        const ReferenceMeasure& measure = request.measure;
        if (measure.baseline > 0) {
            baseline_ = measure.baseline;
            return;
        }
        if (!suggested_ || suggested_->from != measure.from || suggested_->to != measure.to) {
            suggested_ = {measure.from, measure.to,
                          request.suggested
                              ? *request.suggested
                              : match::suggest_baseline(*reader_, measure.from, end_of(measure), progress_of(job))};
        }
        baseline_ = suggested_->time;
    }

    Image composed(const Request& request) const {
        Image picture = *request.image;
        match::draw_counted(picture, *estimator_, amounts_,
                            {.blood = request.blood, .veil = request.smoke, .left_out = request.left_out});
        return picture;
    }

    struct Suggested {
        double from, to, time;
    };
    struct Clear {
        int frame = -1;  ///< -1: to be looked for again
        std::shared_ptr<const Image> image = nullptr;
    };
    std::optional<VideoReader> reader_;
    std::weak_ptr<const VideoReader> opened_;
    struct Learnt {
        double baseline, from, to;
        std::shared_ptr<const match::Survey> survey;
    };
    Clear clear_;  ///< the frame of the baseline
    std::atomic<int> decoded_ = 0;
    std::optional<Suggested> suggested_;
    std::optional<Learnt> learnt_;
    std::optional<match::Estimator> estimator_;
    std::optional<Request> done_;  ///< what amounts_ is of
    match::FrameAmounts amounts_;
    double baseline_ = 0;
    std::shared_ptr<const match::PaintedBlood> painted_;  ///< of the scene's strokes
    std::vector<Fault> stroke_faults_;
};

MeasureBench::MeasureBench(document::Document& document, const Reference& reference, const Measuring& measuring,
                           Jobs& jobs, ui::ImageStore& images, Notices& notices, bool exact)
    : document_(document),
      reference_(reference),
      measuring_(measuring),
      jobs_(jobs),
      images_(images),
      notices_(notices),
      exact_(exact),
      work_(std::make_shared<MeasureWork>()),
      requested_(std::make_unique<Request>()),
      pixels_(std::make_unique<Pixels>()) {}

MeasureBench::~MeasureBench() {
    if (image_ != 0) images_.remove(image_);
}

const MeasureBench::Request& MeasureBench::request() const {
    Request& wanted = *requested_;
    const VideoReader* video = reference_.video();
    wanted.frame = reference_.shown_frame();
    if (video == nullptr || wanted.frame < 0) {
        wanted.file.clear();
        return wanted;
    }
    wanted.good = reference_.good();
    wanted.file = reference_.file();
    wanted.opened = reference_.opened();
    wanted.time = video->time_of(std::min(wanted.frame, video->info().frames - 1));
    wanted.measure = document_.scene().reference.measure;
    const bool over = look.tool != MeasureTool::pick_blood;  // a colour is chosen from the picture as it is
    wanted.blood = look.blood && over, wanted.smoke = look.smoke && over, wanted.left_out = look.left_out && over;
    const match::Measurement* const found = measuring_.stale() ? nullptr : measuring_.found();
    wanted.survey.reset(), wanted.suggested.reset();
    if (found != nullptr) wanted.survey = found->survey;
    if (found != nullptr && found->suggested) wanted.suggested = found->baseline;
    return wanted;
}

bool MeasureBench::stale() const {
    return !job_ && (!shown_ || !asked_ || !(*asked_ == request()));
}

void MeasureBench::update() {
    if (job_ && job_->cancelled()) {  // whoever lists jobs can cancel it; its thread may still be at work
        job_.reset();
        work_ = std::make_shared<MeasureWork>();
        given_up_ = true;
        ready_ = false;  // the picture is of the frame before
    }
    if (!same_opened(opened_, reference_.opened())) {  // a stroke would be over a frame of the video before
        opened_ = reference_.opened();
        lay_down();
        ready_ = false;
    }
    shown_ = std::exchange(wanted_, false);
    if (!shown_) lay_down();
    if (job_) return;
    if (!shown_) return let_go();
    const Request& wanted = request();
    if (asked_ && *asked_ == wanted) return;
    start(wanted);
}

int MeasureBench::baselines_decoded() const {
    return work_->decoded();
}

void MeasureBench::measure_again() {
    asked_.reset();
}

/// While the panel is not seen, the video is not kept open and no picture is kept.
void MeasureBench::let_go() {
    if (!asked_) return;
    asked_.reset();
    work_ = std::make_shared<MeasureWork>();
    ready_ = given_up_ = by_strokes_ = false;
    faults_.clear(), stroke_faults_.clear();
    if (image_ != 0) images_.remove(std::exchange(image_, 0));
    *pixels_ = {};
}

void MeasureBench::start(const Request& request) {
    asked_ = std::make_unique<Request>(request);
    given_up_ = false;
    if (request.file.empty()) {
        ready_ = false;
        faults_.clear();
        return;
    }
    Request served = request;
    served.image = reference_.shared_image();
    const auto fail = [this](const std::vector<Fault>& faults) {
        job_.reset();
        ready_ = false;
        faults_ = faults;
    };
    if (exact_) {
        Job job("Measuring the frame");
        try {
            Result result = work_->run(served, job);
            take(result);
        } catch (const Error& error) {
            fail(error.faults());
        }
        return;
    }
    const auto result = std::make_shared<Result>();
    job_ = jobs_.start(
        "Measuring the frame",
        [=, work = work_, this](Job& job) -> Jobs::Apply {
            *result = work->run(served, job);
            return [=, this] {
                job_.reset();
                take(*result);
            };
        },
        fail);
}

void MeasureBench::take(Result& result) {
    faults_.clear();
    amounts_ = result.amounts;
    baseline_ = result.baseline;
    by_strokes_ = result.by_strokes;
    stroke_faults_ = std::move(result.stroke_faults);
    frame_ = asked_->frame;
    pixels_->frame = std::move(result.frame);
    pixels_->light = std::move(result.light);
    pixels_->veil = std::move(result.veil);
    const Image& image = result.picture;
    const glm::ivec2 size(image.width, image.height);
    if (image_ == 0)
        image_ = images_.add(size, image.pixels);
    else
        images_.update(image_, size, image.pixels);
    ready_ = true;
}

/// In the aspect that the scene gives the reference.
ui::Picture MeasureBench::picture() const {
    if (!ready_) return {};
    const ui::Picture whole = reference_.shown().whole();
    pixels_->size = whole.size.x > 0 ? whole.size : glm::ivec2(pixels_->frame->width, pixels_->frame->height);
    return {.image = image_, .size = pixels_->size, .pixels = pixels_.get()};
}

// --- tuning ----------------------------------------------------------------------------------------------------------

void MeasureBench::pick_blood(glm::ivec2 at) {
    lay_down();
    if (!ready_) return;
    const ui::Color picked = color_around(*pixels_, pixels_->size, at);
    const glm::dvec3 color = pixels_->unveiled(glm::dvec3(picked.r, picked.g, picked.b) / 255.0, at);
    const double redness = match::redness_of_code(255 * color.r, 255 * color.g, 255 * color.b);
    const Table& rows = *measure_table().find("blood");
    const auto within = [&](const char* key, double value) {
        const Parameter& row = *rows.find_row(key);
        return std::clamp(std::round(100 * value) / 100, row.minimum, row.maximum);
    };
    document_.change("Pick blood", [&](document::Content& c) {
        BloodQualifier& blood = c.scene.reference.measure.blood;
        blood.redness = within("redness", redness_share * redness);
        blood.brightness = within("brightness", brightness_share * color.r);
    });
    if (redness < least_red)
        notices_.add({.kind = ui::ToastKind::warning,
                      .text = "The picked colour is hardly red: much else may count as blood, too"});
}

void MeasureBench::lay_down() {
    look.tool = MeasureTool::none;
    look.drawn.clear();
    look.stroke.reset();
}

void MeasureBench::take_tool(MeasureTool tool) {
    const bool held = look.tool == tool;
    lay_down();
    if (!held) look.tool = tool;
}

void MeasureBench::add_stroke() {
    std::optional<BloodStroke> stroke = std::exchange(look.stroke, {});
    if (!stroke) return;
    std::size_t points = stroke->points.size();
    const std::vector<BloodStroke>& all = document_.scene().reference.measure.strokes;
    for (const BloodStroke& each : all) points += each.points.size();
    if (all.size() >= most_blood_strokes || points > match::most_points)
        return notices_.add(
            {.kind = ui::ToastKind::warning, .text = "No more strokes: there are as many as a scene can have"});
    document_.change(stroke->marks == StrokeMark::blood ? "Paint blood" : "Paint what is no blood",
                     [&](document::Content& c) { c.scene.reference.measure.strokes.push_back(std::move(*stroke)); });
}

void MeasureBench::close_part() {
    std::vector<PicturePlace> corners = std::move(look.drawn);
    lay_down();
    if (corners.size() < 3 || document_.scene().reference.measure.parts.size() >= most_left_out_parts) return;
    document_.change("Add part", [&](document::Content& c) {
        c.scene.reference.measure.parts.push_back({.corners = std::move(corners)});
    });
}

}  // namespace lapfx::app
