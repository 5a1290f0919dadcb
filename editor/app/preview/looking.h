// How the organ is looked at.
#pragma once

#include "lapfx/scene.h"
#include "lapfx/view.h"

namespace lapfx::app {

struct Looking {
    /// True: through the scene's camera, with its vignette, and fixed: what `lapfx render` shows. False: freely, by
    /// `camera`.
    bool endoscope = true;
    SceneCamera camera;
    Overlay overlay = Overlay::none;
    bool underlay = false;        ///< the reference lies in the view, translucent, to place the camera by
    double underlay_share = 0.5;  ///< the reference has this share of the picture in that

    /// The camera that the view shows the scene through.
    SceneCamera through(const SceneCamera& of_scene) const;
};

}  // namespace lapfx::app
