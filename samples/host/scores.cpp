// A host that scores: it prints the amounts of a scene ten times a second. It draws nothing and links only
// lapfx::simulation, so it runs without OpenGL. Writes the table of `lapfx render --fps 10 --amounts`.
#include <lapfx/amounts.h>
#include <lapfx/prepared_organ.h>
#include <lapfx/preset.h>
#include <lapfx/scene.h>

#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: lapfx_scores SCENE PRESET\n");
        return 2;
    }
    try {
        const lapfx::Scene scene = lapfx::load_scene(argv[1]);
        const lapfx::Preset preset = lapfx::load_preset(argv[2]);
        const auto organ = lapfx::prepare_organ(
            lapfx::load_organ(scene.folder / scene.organ.file,
                              {scene.organ.scale, scene.organ.rotation,
                               scene.organ.texture.empty() ? "" : scene.folder / scene.organ.texture}),
            preset.vessels);
        lapfx::AmountsModel model(organ, {.gravity = scene.gravity});
        model.set(preset, scene.events, scene.curves);
        std::printf("time_s,blood_area_mm2,blood_volume_mm3,wounds,bleeding_wounds,haze,burnt_area_mm2,emission\n");
        for (int tenth = 0; tenth < std::ceil(10.0 * scene.duration - 1e-9); ++tenth) {
            const lapfx::Amounts a = model.at(tenth / 10.0);
            std::printf("%.4f,%.3f,%.3f,%d,%d,%.5f,%.3f,%.4f\n", tenth / 10.0, a.blood_area, a.blood_volume, a.wounds,
                        a.bleeding_wounds, a.haze, a.burnt_area, a.emission);
        }
    } catch (const lapfx::Error& error) {
        std::fprintf(stderr, "lapfx_scores: %s\n", error.what());
        return error.failure() == lapfx::Failure::bad_input ? 2 : 1;
    }
}
