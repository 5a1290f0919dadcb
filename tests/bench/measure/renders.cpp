#include "bench/measure/renders.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <optional>

#include "bench/measure/views.h"
#include "bench/scratch_folder.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/video.h"
#include "lapfx/clip_cache.h"
#include "match/picture/colors.h"
#include "match/scene/view_share.h"
#include "output/files.h"

namespace lapfx::bench {

namespace {

const cv::Size size(320, 256);
constexpr int shift_margin = 40;  // px around it that a shift brings into view
constexpr double shifted_share = 0.6;
constexpr double latest = 4.0, counted_from = 1.0;  // s after the baseline
constexpr int counted_each = 3;                     // pictures of a clip: those beside each other say the same
constexpr double clear_fps = 4.0, clear_seconds = 5.0;

/// The lens and the round view of shaders/post.frag, which stay where they are when the camera shakes: in linear light.
cv::Mat vignette() {
    cv::Mat factors(size, CV_32F);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double radius =
                2.0 * std::hypot(x + 0.5 - size.width / 2.0, y + 0.5 - size.height / 2.0) / size.height;
            const auto smooth = [radius](double from, double to) {
                const double t = std::clamp((radius - from) / (to - from), 0.0, 1.0);
                return t * t * (3.0 - 2.0 * t);
            };
            factors.at<float>(y, x) =
                static_cast<float>((1.0 - 0.45 * smooth(0.35, 1.15)) * (1.0 - smooth(1.11, 1.13)));
        }
    return factors;
}

void darken(cv::Mat& code, const cv::Mat& factors) {
    cv::Mat linear;
    match::to_linear(code, linear);
    const match::QuickCode quick_code;
    for (int y = 0; y < code.rows; ++y)
        for (int x = 0; x < code.cols; ++x)
            for (int k = 0; k < 3; ++k)
                code.at<cv::Vec3b>(y, x)[k] = cv::saturate_cast<std::uint8_t>(
                    quick_code(linear.at<cv::Vec3f>(y, x)[k] * factors.at<float>(y, x)));
}

cv::Mat bgr_of(const Image& image) {
    cv::Mat bgr;
    output::to_bgr(image, bgr);
    return bgr;
}

/// MPEG-4: the encoder for H.264 (x264 0.164) uses memory that it has not set, and gives other pictures each time.
cv::VideoWriter written(const std::filesystem::path& file, double rate) {
    cv::VideoWriter video(file.string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'), rate, size);
    if (!video.isOpened()) throw output::cannot_write(file, "OpenCV has no encoder for MPEG-4");
    return video;
}

/// As it wanders: a slow sway of some mm, in which each direction has its own beat.
class Wander {
  public:
    explicit Wander(Random& random) {
        for (Sway& sway : sways_) sway = {random.in(0.08, 0.3), random.in(0.0, 6.28)};
        for (double& extent : extents_) extent = random.in(1.5, 6.0);
        roll_ = random.in(0.5, 3.0);
    }
    /// `time`: s after the baseline, where it is `from`.
    SceneCamera at(SceneCamera from, double time) const {
        for (int k = 0; k < 3; ++k) {
            from.eye[k] += extents_[k] * sways_[k](time);
            from.target[k] += 0.7 * extents_[k + 3] * sways_[k + 3](time);
        }
        const double angle = glm::radians(roll_ * sways_[6](time));
        const glm::dvec3 ahead = glm::normalize(from.target - from.eye);
        from.up = from.up * std::cos(angle) + glm::cross(ahead, from.up) * std::sin(angle);
        return from;
    }

  private:
    struct Sway {
        double beat = 0.1, start = 0.0;  // per s; rad
        double operator()(double time) const { return std::sin(6.283 * beat * time + start) - std::sin(start); }
    };
    Sway sways_[7];
    double extents_[6];  // mm
    double roll_ = 0.0;  // degrees
};

}  // namespace

struct KnownRenders::State {
    State(std::uint32_t seed_, std::uint32_t first_part) : seed(seed_), first(first_part), lens(vignette()) {}

    std::uint32_t seed, first;
    cv::Mat lens;  // CV_32F
    PreparedViews prepared;
    std::shared_ptr<ClipCache> clips = std::make_shared<ClipCache>();
    DrawnView drawn;
    glm::ivec2 drawn_size{0};  // with a margin around the picture, where it is to be shifted
    SceneCamera camera;        // of the baseline, with the margin in view
    std::unique_ptr<Preview> preview;

    /// Shows another view; nothing has happened in it.
    void begin(Random& random, bool clip) {
        drawn = draw_view(random);
        preview = std::make_unique<Preview>(
            drawn.scene, drawn.preset, prepared.of(drawn),
            PreviewOptions{.clip_folders = commands::clip_folders(), .wait_for_clips = true, .clip_cache = clips});
        drawn.scene.events = draw_touches(random, *preview, drawn.happens, {size.width, size.height}, clip);
        camera = drawn.scene.camera;
        camera.vignette = 0.0;
        const int margin = clip ? 0 : shift_margin;
        drawn_size = {size.width + 2 * margin, size.height + 2 * margin};
        const double wider = static_cast<double>(drawn_size.y) / size.height;
        camera.field_of_view =
            glm::degrees(2.0 * std::atan(wider * std::tan(glm::radians(camera.field_of_view) / 2.0)));
    }

    cv::Mat picture(double time) { return bgr_of(preview->image(time, drawn_size)); }

    /// What the camera sees when nothing happens but that the instrument moves.
    Shown baseline(double time, const SceneCamera& seen) {
        preview->set_camera(seen);
        std::vector<ToolContact> strokes;
        for (const ToolContact& stroke : drawn.scene.events)
            if (stroke.power == 0.0 && stroke.strength == 0.0) strokes.push_back(stroke);
        preview->set_contacts(strokes);
        return {.code = picture(time), .view = {}, .blood = {}, .veil = {}};
    }

    Shown shown(double time, const SceneCamera& seen) {
        preview->set_camera(seen);
        preview->set_contacts(drawn.scene.events);
        Shown now{.code = picture(time), .view = {}, .blood = {}, .veil = {}};
        Layers layers = preview->layers(time, drawn_size);
        const cv::Size whole(drawn_size.x, drawn_size.y);
        now.view = cv::Mat(whole, CV_8U, layers.view.data()).clone();
        now.blood = cv::Mat(whole, CV_8U, layers.blood.data()).clone();
        now.veil = cv::Mat(whole, CV_32F, layers.veil.data()).clone();
        return now;
    }

    /// Told, as a user does: before smoke lights it, the dark behind an organ looks like the surround.
    glm::dvec3 view() const {
        return match::round_view_of(drawn.scene.camera, static_cast<double>(size.width) / size.height);
    }

    /// What the picture's frame leaves of it.
    Shown framed(const Shown& whole, const Move& move) {
        Shown part = moved(whole, move, size);
        if (drawn.scene.camera.vignette == 0.0) return part;
        darken(part.code, lens);
        if (!part.view.empty()) part.view &= lens > 0.25F;
        return part;
    }

    void through_encoder(KnownView& view) const {
        const ScratchFolder folder;
        const std::filesystem::path file = folder.path() / "known.mp4";
        {
            cv::VideoWriter video = written(file, static_cast<double>(view.pictures.size()) / latest);
            video.write(bgr_of(view.baseline));
            for (const KnownPicture& known : view.pictures) video.write(bgr_of(known.picture));
        }
        VideoReader reader(file);
        reader.read(0, view.baseline);
        int i = 0;
        for (KnownPicture& known : view.pictures) reader.read(++i, known.picture);
    }
};

KnownRenders::KnownRenders(std::uint32_t seed, std::uint32_t first_part)
    : state_(std::make_unique<State>(seed, first_part)) {}
KnownRenders::~KnownRenders() = default;

KnownView KnownRenders::still(int number) {
    State& s = *state_;
    Random random(s.seed, s.first + 1, static_cast<std::uint32_t>(number));
    s.begin(random, false);
    const double time = random.in(0.3, 1.0) * s.drawn.scene.duration, noise = draw_noise(random);
    const Move move = draw_move(random, shifted_share);
    KnownView view{
        .baseline = filmed(random, s.framed(s.baseline(0.0, s.camera), {}).code, cv::Scalar::all(1.0), noise),
        .pictures = {},
        .labels = s.drawn.labels,
        .round_view = s.view()};
    const Shown shown = s.framed(s.shown(time, s.camera), move);
    KnownPicture picture = known(shown);
    picture.picture = filmed(random, shown.code, draw_gains(random), noise);
    picture.shifted = move.any();
    compress(random, view.baseline);
    compress(random, picture.picture);
    view.pictures.push_back(std::move(picture));
    return view;
}

KnownView KnownRenders::clip(int number, int count) {
    State& s = *state_;
    Random random(s.seed, s.first + 2, static_cast<std::uint32_t>(number));
    s.begin(random, true);
    const double start = random.in(0.05, 0.6) * s.drawn.scene.duration, noise = draw_noise(random);
    const Wander wander(random);
    const cv::Scalar gains = draw_gains(random);  // they drift to these
    KnownView view{
        .baseline = filmed(random, s.framed(s.baseline(start, s.camera), {}).code, cv::Scalar::all(1.0), noise),
        .pictures = {},
        .labels = s.drawn.labels,
        .round_view = s.view(),
        .moves = true,
        .in_order = true};
    for (int i = 0; i < count; ++i) {
        const double later = latest * i / count;
        const SceneCamera seen = wander.at(s.camera, later);
        const bool counted = later >= counted_from && i % counted_each == 0;
        Shown shown{.code = {}, .view = {}, .blood = {}, .veil = {}};
        if (counted)
            shown = s.framed(s.shown(start + later, seen), {});
        else {
            s.preview->set_camera(seen);
            s.preview->set_contacts(s.drawn.scene.events);
            shown = s.framed({.code = s.picture(start + later), .view = {}, .blood = {}, .veil = {}}, {});
        }
        KnownPicture picture = counted ? known(shown) : KnownPicture{};
        picture.counted = counted;
        picture.picture = filmed(random, shown.code, drifted(gains, later / latest), noise);
        view.pictures.push_back(std::move(picture));
    }
    s.through_encoder(view);
    return view;
}

KnownView KnownRenders::course(int number, int count) {
    State& s = *state_;
    Random random(s.seed, s.first + 5, static_cast<std::uint32_t>(number));
    s.begin(random, true);
    const double noise = draw_noise(random);
    const cv::Scalar gains = draw_gains(random);  // they drift to these
    KnownView view{
        .baseline = filmed(random, s.framed(s.baseline(0.0, s.camera), {}).code, cv::Scalar::all(1.0), noise),
        .pictures = {},
        .labels = s.drawn.labels,
        .round_view = s.view(),
        .in_order = true};
    for (int i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / count;
        const Shown shown = s.framed(s.shown(share * s.drawn.scene.duration, s.camera), {});
        KnownPicture picture = known(shown);
        picture.picture = filmed(random, shown.code, drifted(gains, share), noise);
        view.pictures.push_back(std::move(picture));
    }
    s.through_encoder(view);
    return view;
}

void KnownRenders::write_clear(int number, const std::filesystem::path& file) {
    State& s = *state_;
    Random random(s.seed, s.first + 4, static_cast<std::uint32_t>(number));
    s.begin(random, true);
    const double noise = 0.3 * draw_noise(random);  // the encoder's is added, and that of the composites
    const Wander wander(random);
    cv::VideoWriter video = written(file, clear_fps);
    for (int i = 0; i <= clear_seconds * clear_fps; ++i) {
        Shown shown = s.baseline(i / clear_fps, wander.at(s.camera, i / clear_fps));
        video.write(bgr_of(filmed(random, s.framed(shown, {}).code, cv::Scalar::all(1.0), noise)));
    }
}

}  // namespace lapfx::bench
