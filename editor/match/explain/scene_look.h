// Camera and look that one frame of the reference proposes: what has to be alike before amounts are compared. The disc
// of the view, exposure and white balance, and the colours of blood and haze where the frame shows them.
//
//     match::LookProposal found = match::propose_look(frame, preview, match::look_of(scene, preset));
//     if (found.possible) match::put_look(found.look, scene, preset);
//     for (const std::string& note : found.notes) show(note);
//
// Both pictures are of tissue; the preview is best one without blood and smoke. What the frame does not show stays as
// it is, and a note says so. Pure functions, any thread, no OpenGL.
#pragma once

#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lapfx/camera.h"
#include "lapfx/organ.h"
#include "lapfx/scene.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::match {

/// What of scene and preset a frame can say something about. Colours are sRGB.
struct SceneLook {
    double vignette = 1.0, exposure = 1.0;
    glm::dvec3 light{1.0}, organ{1.0};
    glm::dvec3 blood_thin{0.0}, blood_deep{0.0}, haze{0.0};
};
SceneLook look_of(const Scene& scene, const Preset& preset);
void put_look(const SceneLook& look, Scene& scene, Preset& preset);

struct LookProposal {
    bool possible = false;  ///< false: the first note says why, and `look` is as it was
    SceneLook look;
    std::vector<std::string> notes;  ///< what was found and what not, a sentence each
};
/// `preview`: drawn with `now`, of any size; `organ`: CV_8U of any size, where it shows the organ, which need not fill
/// the frame; empty: everywhere. Light and organ have 1 as their largest channel afterwards; the rest is in the
/// exposure, up to where the brightest tissue of the preview would be overexposed that is not in the video. Blood and
/// haze take over the hue and saturation that the frame shows, and keep their brightness, which a single frame does not
/// determine, unless the new exposure would bleach them. `response`: of the scene's camera, by which the preview was
/// drawn, and is to look as the video does.
LookProposal propose_look(const Image& reference, const Image& preview, const SceneLook& now, const cv::Mat& organ = {},
                          const CameraResponse& response = {});

}  // namespace lapfx::match
