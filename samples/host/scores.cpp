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
        std::fputs(lapfx::amounts_head().c_str(), stdout);
        for (int tenth = 0; tenth < std::ceil(10.0 * scene.duration - 1e-9); ++tenth)
            std::fputs(lapfx::amounts_line(tenth / 10.0, model.at(tenth / 10.0)).c_str(), stdout);
    } catch (const lapfx::Error& error) {
        std::fprintf(stderr, "lapfx_scores: %s\n", error.what());
        return error.failure() == lapfx::Failure::bad_input ? 2 : 1;
    }
}
