#include "bench/measure/views.h"

#include <optional>

#include "commands/session.h"
#include "lapfx/authoring/prepared_scene.h"

namespace lapfx::bench {

namespace {

constexpr double duration = 10.0;  // s of a scene
constexpr int most_touches = 6;
constexpr double bloodless = 0.2, smokeless = 0.25, instrument_share = 0.5;
constexpr double jitter = 0.1;  // of an organ's colour

struct OrganRow {
    const char* label;
    const char* file;
    glm::dvec3 color, eye, target;
};
constexpr OrganRow organs[] = {{"stomach", "lagb.glb", {1.0, 1.0, 1.0}, {0, 40, 120}, {2, 2, 0}},
                               {"stomach, inflamed", "lagb.glb", {1.0, 0.72, 0.68}, {0, 40, 120}, {2, 2, 0}},
                               {"liver", "liver_lobe.glb", {1.0, 1.0, 1.0}, {0, 14, 72}, {0, 0, 0}},
                               {"liver, fatty", "liver_lobe.glb", {1.0, 0.92, 0.7}, {0, 14, 72}, {0, 0, 0}}};

struct LightRow {
    const char* label;
    glm::dvec3 color;
};
constexpr LightRow lights[] = {{"warm", {1.0, 0.92, 0.8}}, {"neutral", {1.0, 0.98, 0.95}}, {"cold", {0.9, 0.96, 1.0}}};

struct CameraRow {
    const char* label;
    double least, most;  // of the distance of the organ's own camera
};
constexpr CameraRow cameras[] = {{"near", 0.75, 0.88}, {"middle", 0.88, 1.01}, {"far", 1.01, 1.15}};

template <class Row, int count>
const Row& one_of(Random& random, const Row (&rows)[count]) {
    return rows[random.below(count)];
}

glm::dvec3 tint(Random& random, double strength) {
    return {random.in(1.0 - strength, 1.0), random.in(1.0 - strength, 1.0), random.in(1.0 - strength, 1.0)};
}

void draw_preset(Random& random, DrawnView& view) {
    constexpr const char* presets[] = {"gastric_banding", "brisk_bleed", "slow_ooze", "heavy_haze"};
    const std::string name = one_of(random, presets);
    view.preset = load_preset(commands::data_folder() / "presets" / (name + ".json"));
    BleedingParameters& blood = view.preset.bleeding;
    blood.speed = random.log_in(1.0, 12.0);
    blood.max_extent = random.log_in(4.0, 45.0);
    blood.noise_scale = random.in(2.5, 8.0);
    blood.rivulets = random.in(0.0, 1.0);
    SmokeParameters& smoke = view.preset.smoke;
    smoke.haze.accumulation = random.log_in(0.03, 0.8);
    smoke.haze.ventilation = random.in(0.0, 0.15);
    const double brightness = random.in(0.75, 1.35);
    smoke.haze.color *= brightness * tint(random, 0.12);
    smoke.plume.density = random.chance(0.2) ? 0.0 : random.in(0.1, 0.9);
    const double kind = random.in(0.0, 1.0);
    view.happens = {.blood = kind >= bloodless, .smoke = kind < bloodless || kind >= bloodless + smokeless};
    if (!view.happens.smoke) smoke.haze.accumulation = smoke.plume.density = 0.0;
}

}  // namespace

DrawnView draw_view(Random& random) {
    DrawnView view;
    view.scene = load_scene(commands::data_folder() / "samples/lagb.scene.json");
    Scene& scene = view.scene;
    scene.events.clear();
    scene.duration = duration;
    scene.seed = random.below(1'000'000);
    const OrganRow& organ = one_of(random, organs);
    const LightRow& light = one_of(random, lights);
    const CameraRow& camera = one_of(random, cameras);
    view.labels = {{"organ", organ.label}, {"light", light.label}, {"camera", camera.label}};
    scene.organ.file = organ.file;
    scene.organ.color = organ.color * tint(random, jitter);
    scene.camera.eye = organ.eye * random.in(camera.least, camera.most);
    scene.camera.eye += glm::dvec3{random.in(-30, 30), random.in(-20, 20), 0};
    scene.camera.target = organ.target + glm::dvec3{random.in(-10, 10), random.in(-8, 8), 0};
    scene.camera.exposure = random.log_in(1.1, 2.8);
    scene.camera.vignette = random.chance(1.0 / 3.0) ? 0 : 1;
    scene.light.color = light.color;
    scene.light.beam_angle = random.in(55, 95);
    draw_preset(random, view);
    return view;
}

std::vector<ToolContact> draw_touches(Random& random, const Preview& preview, const Happening& happens, glm::ivec2 size,
                                      bool clip) {
    std::vector<ToolContact> touches;
    const auto somewhere = [&] {
        return preview.pick({size.x * random.in(0.2, 0.8), size.y * random.in(0.2, 0.8)}, size);
    };
    const int count = 1 + random.below(most_touches);
    for (int i = 0; i < count; ++i) {
        const std::optional<OrganHit> hit = somewhere();
        if (!hit) continue;
        ToolContact touch;
        touch.action = random.chance(0.5) ? ToolAction::cut : ToolAction::cauterise;
        touch.time = random.in(0.0, 0.5 * duration);
        touch.duration = touch.action == ToolAction::cut ? random.in(0.2, 1.5) : random.in(0.5, 4.0);
        touch.position = hit->position;
        touch.to = hit->position + glm::dvec3{random.in(-6, 6), random.in(-6, 6), random.in(-2, 2)};
        touch.power = random.in(0.5, 1.0);
        touch.strength = random.in(0.5, 2.0);
        if (!happens.blood) touch.action = ToolAction::coagulate;
        touches.push_back(touch);
    }
    const bool instrument = clip && random.chance(instrument_share);
    const std::optional<OrganHit> from = somewhere();
    const std::optional<OrganHit> to = somewhere();
    if (instrument && from && to)
        touches.push_back({.action = ToolAction::cauterise,
                           .time = 0.0,
                           .duration = 1.2 * duration,
                           .position = from->position,
                           .to = to->position,
                           .power = 0.0,
                           .strength = 0.0});
    return touches;
}

std::shared_ptr<const PreparedOrgan> PreparedViews::of(const DrawnView& view) {
    const std::string& file = view.scene.organ.file;
    const VesselParameters& vessels = view.preset.vessels;
    for (const Prepared& prepared : prepared_)
        if (prepared.file == file && prepared.vessels == vessels) return prepared.organ;
    return prepared_.emplace_back(Prepared{file, vessels, prepare_organ(view.scene, vessels)}).organ;
}

}  // namespace lapfx::bench
