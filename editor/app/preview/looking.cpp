#include "app/preview/looking.h"

#include <algorithm>

#include "app/preview/orbit.h"

namespace lapfx::app {

SceneCamera Looking::through(const SceneCamera& of_scene) const {
    if (endoscope) return of_scene;
    // The lamp is at the camera: nearer than the scene's the picture would burn out, and an endoscope turns it down,
    // too.
    const double nearer = nearness(of_scene, camera);
    SceneCamera seen = camera;
    seen.set_response(of_scene.response());
    seen.exposure *= std::clamp(nearer * nearer, 0.05, 4.0);
    seen.vignette = 0;
    return seen;
}

}  // namespace lapfx::app
