// Makes the sample reference: a surgery video to match, as if from another operation than that of the sample scene. It
// is rendered with another preset, camera and seed, half a second later, then passes through an endoscope's camera and
// an encoder with few bits.
//
//     make_sample_reference --output samples/reference/operation.mp4       about a minute on a software renderer
//     make_sample_reference --output /tmp/quick.mp4 --size 160x128 --frames 5
//
// It is a host of the core: it needs only lapfx/*.h, and the `ffmpeg` program with libx264. The bytes depend on the
// renderer and on the version of x264; the pictures hardly do.
#include <lapfx/authoring/preview.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "clips/noise.h"
#include "lapfx/authoring/command_line.h"
#include "reference/camera.h"

namespace {

constexpr int frames_per_second = 25;
constexpr double seconds = 8.0;
constexpr double later = 0.5;  // s, the offset of the scene's reference

struct Options {
    std::filesystem::path output, samples = "samples";
    int width = 640, height = 512;
    int frames = static_cast<int>(seconds * frames_per_second);
    std::string quality = "-crf 24 -preset slow";
};

/// Brisker than the sample scene's own, with more smoke.
lapfx::Preset another_preset(const std::filesystem::path& presets) {
    lapfx::Preset preset = lapfx::load_preset(presets / "gastric_banding.json");
    preset.bleeding = lapfx::load_preset(presets / "brisk_bleed.json").bleeding;
    preset.bleeding.speed = 8.5;
    preset.bleeding.max_extent = 22;
    preset.bleeding.noise_scale = 5;
    preset.bleeding.pulse_strength = 0.35;
    preset.smoke.plume = lapfx::load_preset(presets / "hook_cautery_plume.json").smoke.plume;
    preset.smoke.haze.accumulation = 0.08;
    preset.smoke.haze.ventilation = 0.08;
    return preset;
}

lapfx::Scene another_operation(const std::filesystem::path& samples) {
    lapfx::Scene scene = lapfx::load_scene(samples / "lagb.scene.json");
    scene.seed = 41;
    scene.camera.eye = {-24, 47, 108};
    scene.camera.target = {3, 1, 1};
    scene.camera.up = {0.09, 1, 0};
    scene.camera.field_of_view = 62;
    scene.camera.exposure = 2.15;
    scene.camera.vignette = 1;
    scene.light.color = {1.0, 0.95, 0.86};
    for (lapfx::ToolContact& event : scene.events) event.time += later;
    return scene;
}

clips::RgbFrame colors_of(const lapfx::Image& image) {
    clips::RgbFrame frame(image.width, image.height);
    for (std::size_t i = 0; i < frame.rgb.size(); ++i)
        frame.rgb[i] = static_cast<float>(image.pixels[i / 3 * 4 + i % 3]);
    return frame;
}

void make(const Options& o) {
    const lapfx::Context context = lapfx::Context::create(lapfx::Backend::automatic);
    lapfx::Preview preview(another_operation(o.samples), another_preset(o.samples / ".." / "presets"),
                           {.clip_folders = {o.samples / "clips"}, .wait_for_clips = true});
    clips::Encoder encoder(o.output, o.width, o.height, frames_per_second, o.quality);
    for (int i = 0; i < o.frames; ++i) {
        clips::RgbFrame frame = colors_of(preview.image(i / double{frames_per_second}, {o.width, o.height}));
        camera::film(frame, {.seed = clips::hash(static_cast<std::uint32_t>(i), 41)});
        encoder.write(frame);
        if (isatty(2)) std::cerr << "\rframe " << i + 1 << " of " << o.frames << "   " << std::flush;
    }
    if (isatty(2)) std::cerr << '\n';
    encoder.close();
}

void parse(int argc, char** argv, Options& o, CLI::App& app) {
    std::string size = "640x512";
    app.add_option("--output", o.output, "the video")->required();
    app.add_option("--samples", o.samples, "folder of the sample scene")->check(CLI::ExistingDirectory);
    app.add_option("--size", size, "WxH, both even");
    app.add_option("--frames", o.frames, "how many")->check(CLI::Range(1, 10000));
    app.add_option("--quality", o.quality, "x264's options, as ffmpeg takes them");
    app.parse(argc, argv);
    int end = 0;
    if (std::sscanf(size.c_str(), "%dx%d%n", &o.width, &o.height, &end) != 2 || end != static_cast<int>(size.size()) ||
        std::min(o.width, o.height) < 16 || std::max(o.width, o.height) > 4096 || o.width % 2 + o.height % 2 != 0)
        throw CLI::ValidationError("--size", "\"" + size + "\" is no size such as 640x512: even, 16 to 4096");
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Makes lapfx's sample reference video");
    try {
        parse(argc, argv, options, app);
        make(options);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) ? 2 : 0;
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults()) std::cerr << "make_sample_reference: " << fault.text() << '\n';
        return lapfx::exit_code(error.failure());
    } catch (const std::exception& error) {
        std::cerr << "make_sample_reference: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
