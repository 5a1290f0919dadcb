// An organ prepared for the effects: loaded, its surface joined, its vessels and fat found. That takes long and needs no
// OpenGL, so it can be done on another thread than the one that draws; then it has to be sent to the GPU. Textures that have
// been sent before are decoded once more; so are all for other vessels than it was prepared for.
//
//     auto coming = std::async(std::launch::async, [=] { return lapfx::prepare_organ(scene, preset.vessels); });
//     ...                                                       // the render thread continues with the previous organ
//     preview = lapfx::Preview(scene, preset, coming.get());    // render thread
//
// Never changes once it is made: any number of Effects and Previews on any threads may share one.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/progress.h"
#include "lapfx/scene.h"

namespace lapfx {

class PreparedOrgan {
  public:
    /// With its long triangles split (refine.h). Its images have their names and sizes but no pixels: these are kept until they
    /// have been sent to a GPU, and decoded again when they are needed.
    const Organ& organ() const;
    /// Every file that was read for it or looked for: organ, textures, materials, the instrument.
    std::vector<std::filesystem::path> files() const;
    /// The files that the instrument was read from, the mesh first.
    std::vector<std::filesystem::path> tool_files() const;
    /// Whether prepare_organ(scene) would make the same of files that have not changed since: organ and instrument are those, as
    /// large and turned the same way.
    bool made_for(const Scene& scene) const;
    std::size_t memory() const;  ///< bytes of main memory

    struct State;  ///< private
    explicit PreparedOrgan(std::unique_ptr<const State> state);
    ~PreparedOrgan();
    const State& state() const { return *state_; }

  private:
    std::unique_ptr<const State> state_;
};

/// The scene's organ and instrument. `vessels`: what densities are made for first; another preset may be set later. Throws Error
/// (bad_input); null when `progress` stopped it. Any thread.
std::shared_ptr<const PreparedOrgan> prepare_organ(const Scene& scene, const VesselParameters& vessels = {},
                                                   const Progress& progress = {});
/// An organ that the host has loaded itself.
std::shared_ptr<const PreparedOrgan> prepare_organ(Organ organ, const VesselParameters& vessels = {},
                                                   const Progress& progress = {});

}  // namespace lapfx
