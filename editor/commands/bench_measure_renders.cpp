#include "commands/bench_measure_renders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <random>

#include "commands/scratch_folder.h"
#include "commands/session.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/video.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

constexpr glm::ivec2 size{360, 288};
constexpr double duration = 10.0;  // s of a scene
constexpr double clip_fps = 10.0;
constexpr int most_touches = 6;

/// Random numbers that are the same with every standard library.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0; }
    double log_in(double low, double high) { return low * std::pow(high / low, in(0, 1)); }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
    bool once_in(double times) { return in(0, 1) < 1.0 / times; }
    double normal() { return std::sqrt(-2.0 * std::log(in(1e-9, 1))) * std::cos(in(0, 6.283185307)); }

  private:
    std::mt19937 engine_;
};

/// A view and what spoils its pictures.
struct Drawn {
    Scene scene;
    Preset preset;
    double noise = 0.0;  // code values, standard deviation
    int quality = 90;    // of JPEG
};

glm::dvec3 tint(Random& random, double strength) {
    return {random.in(1.0 - strength, 1.0), random.in(1.0 - strength, 1.0), random.in(1.0 - strength, 1.0)};
}

Drawn draw_view(Random& random) {
    Drawn d;
    d.scene = load_scene(data_folder() / "samples/lagb.scene.json");
    Scene& scene = d.scene;
    scene.events.clear();
    scene.duration = duration;
    scene.seed = random.below(1'000'000);
    if (random.once_in(2)) {
        scene.organ.file = "liver_lobe.glb";
        scene.camera.eye = {0, 14, 72};
        scene.camera.target = {0, 0, 0};
    }
    scene.organ.color = tint(random, 0.3);
    scene.camera.eye *= random.in(0.75, 1.15);
    scene.camera.eye += glm::dvec3(random.in(-30, 30), random.in(-20, 20), 0);
    scene.camera.target += glm::dvec3(random.in(-10, 10), random.in(-8, 8), 0);
    scene.camera.exposure = random.log_in(1.1, 2.8);
    scene.camera.vignette = random.once_in(3) ? 0 : 1;
    scene.light.color = {1.0, random.in(0.9, 1.0), random.in(0.8, 1.0)};
    scene.light.beam_angle = random.in(55, 95);

    constexpr const char* presets[] = {"gastric_banding", "brisk_bleed", "slow_ooze", "heavy_haze"};
    d.preset = load_preset(data_folder() / "presets" / (std::string(presets[random.below(4)]) + ".json"));
    BleedingParameters& blood = d.preset.bleeding;
    blood.speed = random.log_in(1.0, 12.0);
    blood.max_extent = random.log_in(4.0, 45.0);
    blood.noise_scale = random.in(2.5, 8.0);
    blood.rivulets = random.in(0.0, 1.0);
    SmokeParameters& smoke = d.preset.smoke;
    smoke.haze.accumulation = random.once_in(6) ? 0.0 : random.log_in(0.03, 0.8);
    smoke.haze.ventilation = random.in(0.0, 0.15);
    smoke.haze.color *= random.in(0.75, 1.35) * tint(random, 0.12);
    smoke.plume.density = random.once_in(5) ? 0.0 : random.in(0.1, 0.9);
    d.noise = random.in(0.5, 4.0);
    d.quality = 60 + random.below(36);
    return d;
}

/// Cuts that bleed and burns that smoke, where the tissue is seen.
void draw_touches(Random& random, const Preview& preview, Scene& scene) {
    const int touches = 1 + random.below(most_touches);
    for (int i = 0; i < touches; ++i) {
        const glm::dvec2 pixel(size.x * random.in(0.2, 0.8), size.y * random.in(0.2, 0.8));
        const std::optional<OrganHit> hit = preview.pick(pixel, size);
        if (!hit) continue;
        ToolContact contact;
        contact.action = random.once_in(2) ? ToolAction::cut : ToolAction::cauterise;
        contact.time = random.in(0.0, 0.5 * duration);
        contact.duration = contact.action == ToolAction::cut ? random.in(0.2, 1.5) : random.in(0.5, 4.0);
        contact.position = hit->position;
        contact.to = hit->position + glm::dvec3(random.in(-6, 6), random.in(-6, 6), random.in(-2, 2));
        contact.power = random.in(0.5, 1.0);
        contact.strength = random.in(0.5, 2.0);
        scene.events.push_back(contact);
    }
}

void add_noise(Random& random, double strength, Image& image) {
    for (std::uint8_t& value : image.pixels)
        value = static_cast<std::uint8_t>(std::clamp(std::lround(value + strength * random.normal()), 0L, 255L));
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
}

void compress(int quality, Image& image) {
    cv::Mat bgr;
    output::to_bgr(image, bgr);
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", bgr, bytes, {cv::IMWRITE_JPEG_QUALITY, quality});
    cv::Mat rgba(image.height, image.width, CV_8UC4, image.pixels.data());
    cv::cvtColor(cv::imdecode(bytes, cv::IMREAD_COLOR), rgba, cv::COLOR_BGR2RGBA);
}

/// The pixels that the camera shows at all.
std::vector<bool> seen_in(const Image& image) {
    std::vector<bool> seen(image.pixels.size() / 4);
    for (std::size_t i = 0; i < seen.size(); ++i)
        seen[i] = image.pixels[4 * i] + image.pixels[4 * i + 1] + image.pixels[4 * i + 2] > 0;
    return seen;
}

}  // namespace

struct KnownRenders::State {
    explicit State(std::uint32_t seed) : random(seed) {}

    Random random;
    Drawn drawn;
    std::map<std::string, std::shared_ptr<const PreparedOrgan>> organs;  // by file
    std::unique_ptr<Preview> preview;
    std::vector<bool> seen;

    Image begin() {
        drawn = draw_view(random);
        preview = std::make_unique<Preview>(drawn.scene, drawn.preset,
                                            PreviewOptions{.clip_folders = clip_folders(), .wait_for_clips = true});
        draw_touches(random, *preview, drawn.scene);
        Image clear = preview->image(0.0, size);
        seen = seen_in(clear);
        preview->set_contacts(drawn.scene.events);
        return clear;
    }
    KnownFrame frame(double time) {
        KnownFrame known{.picture = preview->image(time, size)};
        const Layers layers = preview->layers(time, size);
        double all = 0.0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (!seen[i]) continue;
            all += 1.0;
            known.blood += layers.blood[i] != 0 ? 1.0 : 0.0;
            known.veil += static_cast<double>(layers.veil[i]);
        }
        known.blood /= std::max(all, 1.0);
        known.veil /= std::max(all, 1.0);
        add_noise(random, drawn.noise, known.picture);
        return known;
    }
};

KnownRenders::KnownRenders(std::uint32_t seed) : state_(std::make_unique<State>(seed)) {}
KnownRenders::~KnownRenders() = default;

KnownView KnownRenders::still() {
    State& s = *state_;
    KnownView view{.baseline = s.begin(), .frames = {}};
    view.frames.push_back(s.frame(s.random.in(0.3 * duration, duration)));
    add_noise(s.random, s.drawn.noise, view.baseline);
    compress(s.drawn.quality, view.baseline);
    compress(s.drawn.quality, view.frames.front().picture);
    return view;
}

KnownView KnownRenders::clip(int count) {
    State& s = *state_;
    KnownView view{.baseline = s.begin(), .frames = {}};
    for (int i = 0; i < count; ++i) view.frames.push_back(s.frame(duration * (i + 0.5) / count));
    add_noise(s.random, s.drawn.noise, view.baseline);
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "known.mp4";
    {
        output::VideoFile video(file, clip_fps, {size.x, size.y});
        video.add(view.baseline);
        for (const KnownFrame& frame : view.frames) video.add(frame.picture);
        video.finish();
    }
    VideoReader reader(file);
    reader.read(0, view.baseline);
    for (int i = 0; i < count; ++i) reader.read(i + 1, view.frames[static_cast<std::size_t>(i)].picture);
    return view;
}

}  // namespace lapfx::commands
