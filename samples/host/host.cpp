// A minimal host: what a simulator does to have lapfx in its picture, with nothing but the public headers. It renders one
// frame of a scene to a binary PPM on standard output; tests/e2e compares it with `lapfx render`, pixel for pixel.
//
//     lapfx_host samples/lagb.scene.json 6 320 256 samples/clips > frame.ppm
#include <lapfx/preview.h>
#include <cstdio>
#include <cstdlib>

namespace {

void write_ppm(const lapfx::Image& image) {
    std::printf("P6\n%d %d\n255\n", image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) std::fwrite(&image.pixels[i], 1, 3, stdout);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fprintf(stderr, "usage: lapfx_host SCENE SECONDS WIDTH HEIGHT CLIP_FOLDER > frame.ppm\n");
        return 2;
    }
    try {
        const lapfx::Scene scene = lapfx::load_scene(argv[1]);
        const lapfx::Preset preset = lapfx::load_preset(scene.folder / scene.preset);
        const lapfx::Context context = lapfx::Context::create(lapfx::Backend::osmesa);
        lapfx::Preview preview(scene, preset, {.clip_folders = {argv[5]}, .wait_for_clips = true});
        write_ppm(preview.image(std::atof(argv[2]), {std::atoi(argv[3]), std::atoi(argv[4])}));
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults()) std::fprintf(stderr, "lapfx_host: %s\n", fault.text().c_str());
        return static_cast<int>(error.failure());
    }
    return 0;
}
