// Makes the sample clips: solves smoke in 3-D and films it.
//
//     make_sample_clips --output samples/clips            all clips, about a quarter of an hour of one core
//     make_sample_clips --output /tmp/clips --quick       a coarse grid and few frames, for tests
//     make_sample_clips --output /tmp/clips --only haze_rolling --cells 64
//
// Needs the `ffmpeg` program with libx264. The same seed gives the same pictures on any number of threads;
// the bytes of the clips also depend on the versions of the C library (expf, logf), of the compiler and of
// x264.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>

#include "composite.h"
#include "noise.h"
#include "parallel.h"
#include "scene.h"

namespace {

using namespace clips;

constexpr int width = 720, height = 480, fps = 30;
constexpr int blend_frames = 21;
constexpr glm::vec3 black(0.0f), studio_green(0.0f, 177.0f, 64.0f);

struct Options {
    std::filesystem::path output = ".";
    std::uint32_t seed = 2010;
    int cells = 0;
    int threads = 0;
    bool quick = false;
    std::vector<std::string> only;

    bool wants(const std::string& name) const {
        return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
    }
    int frames(float seconds) const { return quick ? blend_frames + 3 : int(seconds * fps); }
    int grid(int full) const { return cells ? cells : quick ? 32 : full; }
};

/// Solves a scene and hands over its pictures as a loop. The warm-up lets smoke fill its path before the
/// first frame.
void film(Scene& scene, const Options& options, int frames, float warm_up, int substeps,
          const std::function<void(int, const Picture&)>& output) {
    Fluid fluid(scene.fluid());
    Forces forces(scene.fluid().cells);
    VolumeRenderer renderer(fluid.density, scene.light(), scene.view(), width, height);
    LoopBlend loop(frames, blend_frames, output);
    scene.start(fluid);
    const int first = -int((options.quick ? 0.3f : warm_up) * fps) - blend_frames;
    const float dt = 1.0f / float(fps * substeps);
    for (int frame = first; frame < frames; ++frame) {
        for (int step = 0; step < substeps; ++step) {
            const float time = float(frame * substeps + step) * dt;
            fluid.advect(dt);
            scene.emit(fluid, time, dt);
            forces.clear();
            scene.stir(fluid, forces, time);
            fluid.push(forces, dt);
        }
        if (frame >= -blend_frames) loop.add(frame, renderer.draw(fluid.density));
        if (isatty(2)) std::cerr << "\rframe " << frame + 1 << " of " << frames << "   " << std::flush;
    }
    if (isatty(2)) std::cerr << "\r                              \r";
}

void make_plume(const Options& options) {
    const float seconds = 5.0f;
    const int frames = options.frames(seconds);
    const auto scene = make_thick_plume({options.seed, options.grid(144), seconds});
    Encoder on_black(options.output / "plume_thick.mp4", width, height, fps,
                     "-crf 20 -preset slower -aq-mode 3");
    // Little bit rate and no deblocking: the noisy recording that keying has to cope with.
    Encoder on_green(options.output / "plume_green.mp4", width, height, fps,
                     "-crf 35 -preset medium -x264-params no-deblock=1");
    Encoder alpha(options.output / "plume_green_alpha.mp4", width, height, fps,
                  "-crf 17 -preset slower -aq-mode 3");
    film(*scene, options, frames, 2.5f, 1, [&](int frame, const Picture& picture) {
        on_black.write(over(picture, black));
        RgbFrame green = over(picture, studio_green);
        add_sensor_noise(green, 2.0f, hash(options.seed, std::uint32_t(frame)));
        on_green.write(green);
        alpha.write(alpha_as_grey(picture));
    });
    on_black.close();
    on_green.close();
    alpha.close();
}

void make_simple(const Options& options, const std::string& name, Scene& scene, int frames, float warm_up,
                 const std::string& quality) {
    Encoder encoder(options.output / (name + ".mp4"), width, height, fps, quality);
    film(scene, options, frames, warm_up, 1,
         [&](int, const Picture& picture) { encoder.write(over(picture, black)); });
    encoder.close();
}

void make_wisps(const Options& options) {
    const float seconds = 5.0f;
    const auto scene = make_thin_wisps({options.seed + 1, options.grid(144), seconds});
    make_simple(options, "wisps_thin", *scene, options.frames(seconds), 3.0f,
                "-crf 19 -preset slower -aq-mode 3");
}

void make_haze(const Options& options) {
    const float seconds = 6.0f;
    const auto scene = make_rolling_haze({options.seed + 2, options.grid(96), seconds});
    make_simple(options, "haze_rolling", *scene, options.frames(seconds), 3.0f,
                "-crf 18 -preset slower -aq-mode 3");
}

void parse(int argc, char** argv, Options& options, CLI::App& app) {
    app.add_option("--output", options.output, "folder that the clips go to")->check(CLI::ExistingDirectory);
    app.add_option("--seed", options.seed, "of all noise");
    app.add_option("--cells", options.cells, "velocity cells over the box's height, a multiple of 16")
        ->check(CLI::Range(16, 512));
    app.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, 64));
    app.add_flag("--quick", options.quick, "a coarse grid and few frames");
    app.add_option("--only", options.only, "clips to make")
        ->check(CLI::IsMember({"plume", "wisps_thin", "haze_rolling"}));
    app.parse(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Makes lapfx's sample clips of smoke");
    try {
        parse(argc, argv, options, app);
        thread_count = options.threads ? options.threads : int(std::thread::hardware_concurrency());
        const auto timed = [&](const std::string& name, void (*make)(const Options&)) {
            if (!options.wants(name)) return;
            const auto start = std::chrono::steady_clock::now();
            make(options);
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
            std::cerr << name << ": " << took.count() << " s\n";
        };
        timed("plume", make_plume);
        timed("wisps_thin", make_wisps);
        timed("haze_rolling", make_haze);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) ? 2 : 0;
    } catch (const std::exception& error) {
        std::cerr << "make_sample_clips: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
