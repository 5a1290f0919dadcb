// A scene's organ and instrument, loaded and prepared on any thread (prepared_organ.h).
//
//     auto coming = std::async(std::launch::async, [=] {
//       return lapfx::prepare_organ(scene, preset.vessels, [&](double share) {
//         bar = share;
//         return !cancelled;
//     }); });
//     preview = lapfx::Preview(scene, preset, coming.get(), options);  // render thread
#pragma once

#include <filesystem>
#include <vector>

#include "lapfx/prepared_organ.h"
#include "lapfx/scene.h"

namespace lapfx {

/// The scene's organ, or the plate that stands in for it, and its instrument; everything else is as for an organ alone.
/// A plate needs the scene's reference, which is read here; its name says how it came about: "frame at 3.2 s of
/// operation.mp4, 9 frames blended". Throws Error (bad_input).
std::shared_ptr<const PreparedOrgan> prepare_organ(const Scene& scene, const VesselParameters& vessels = {},
                                                   const Progress& progress = {});

/// How its organ is loaded. Throws Error (bad_input) for a texture that its name leads nowhere.
OrganOptions organ_options(const Scene& scene);
/// Whether prepare_organ() gives the same for both if no file has changed: same organ and instrument, with the same
/// scale and rotation; or the same plate, for the same camera. Exposure and vignette may differ.
bool same_organ(const Scene& a, const Scene& b);
/// The same for the scene that it was prepared for.
bool made_for(const PreparedOrgan& organ, const Scene& scene);
/// Every file that was read or looked for: organ, textures, materials, the instrument.
std::vector<std::filesystem::path> files_of(const PreparedOrgan& organ);
/// The files that the instrument was read from, the mesh first.
std::vector<std::filesystem::path> tool_files_of(const PreparedOrgan& organ);

}  // namespace lapfx
