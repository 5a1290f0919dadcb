// Makes the sample clips: solves smoke in 3-D and films it.
//
//     make_sample_clips --output samples/clips            all clips, about ten minutes of one core
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
    int only_frames = 0;
    bool quick = false;
    std::vector<std::string> only;

    bool wants(const std::string& name) const {
        return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
    }
    int frames(float seconds) const {
        return only_frames ? only_frames : quick ? blend_frames + 3 : int(seconds * fps);
    }
    int grid(int full) const { return cells ? cells : quick ? 32 : full; }
};

/// How a scene is filmed.
struct Take {
    float seconds;
    float warm_up;  ///< seconds in which smoke fills its path before the first frame
    int cells;      ///< over the box's height
    int substeps;   ///< per frame: 2 where smoke moves several cells a frame
};
constexpr Take plume_take{5.0f, 2.5f, 112, 2};
constexpr Take wisps_take{5.0f, 4.0f, 96, 2};
constexpr Take haze_take{6.0f, 3.0f, 80, 1};

SceneOptions scene_options(const Options& options, const Take& take, std::uint32_t salt) {
    return {options.seed + salt, options.grid(take.cells), take.seconds};
}

/// Solves a scene and gives its pictures as a loop.
void film(Scene& scene, const Options& options, const Take& take,
          const std::function<void(int, const Picture&)>& output) {
    Fluid fluid(scene.fluid());
    Forces forces(scene.fluid().cells);
    VolumeRenderer renderer(fluid.density, scene.light(), scene.view(), width, height);
    const int frames = options.frames(take.seconds);
    LoopBlend loop(frames, blend_frames, output);
    scene.start(fluid);
    const int first = -int((options.quick ? 0.3f : take.warm_up) * fps) - blend_frames;
    const float dt = 1.0f / float(fps * take.substeps);
    for (int frame = first; frame < frames; ++frame) {
        for (int step = 0; step < take.substeps; ++step) {
            const float time = float(frame * take.substeps + step) * dt;
            fluid.advect(dt, scene.eddies(time));
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
    const auto scene = make_thick_plume(scene_options(options, plume_take, 0));
    Encoder on_black(options.output / "plume_thick.mp4", width, height, fps, "-crf 16 -preset slow -aq-mode 3");
    // Few bits, no deblocking, with sensor noise: a poor recording that keying must handle.
    Encoder on_green(options.output / "plume_green.mp4", width, height, fps,
                     "-crf 26 -preset medium -tune grain -x264-params no-deblock=1");
    Encoder alpha(options.output / "plume_green_alpha.mp4", width, height, fps, "-crf 15 -preset slow -aq-mode 3");
    film(*scene, options, plume_take, [&](int frame, const Picture& picture) {
        on_black.write(over(picture, black));
        RgbFrame green = over(picture, studio_green);
        add_sensor_noise(green, 5.0f, hash(options.seed, std::uint32_t(frame)));
        on_green.write(green);
        alpha.write(alpha_as_grey(picture));
    });
    on_black.close();
    on_green.close();
    alpha.close();
}

void make_on_black(const std::string& name, Scene& scene, const Options& options, const Take& take,
                   const std::string& quality) {
    Encoder encoder(options.output / (name + ".mp4"), width, height, fps, quality);
    film(scene, options, take, [&](int, const Picture& picture) { encoder.write(over(picture, black)); });
    encoder.close();
}

void make_wisps(const Options& options) {
    const auto scene = make_thin_wisps(scene_options(options, wisps_take, 1));
    make_on_black("wisps_thin", *scene, options, wisps_take, "-crf 16 -preset slow -aq-mode 3");
}

void make_haze(const Options& options) {
    const auto scene = make_rolling_haze(scene_options(options, haze_take, 2));
    make_on_black("haze_rolling", *scene, options, haze_take, "-crf 18 -preset slow -aq-mode 3");
}

void parse(int argc, char** argv, Options& options, CLI::App& app) {
    app.add_option("--output", options.output, "folder that the clips go to")->check(CLI::ExistingDirectory);
    app.add_option("--seed", options.seed, "of all noise");
    app.add_option("--cells", options.cells, "velocity cells over the box's height, a multiple of 16")
        ->check(CLI::Range(16, 512));
    app.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, 64));
    app.add_option("--frames", options.only_frames, "length of the clips; 0: their own")
        ->check(CLI::Range(blend_frames, 1000));
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
