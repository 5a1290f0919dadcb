// An organ prepared for the effects: its surface joined, its vessels and fat found. That takes long and needs no
// OpenGL, so it can be done on another thread than the one that draws; then it has to be sent to the GPU. Textures that
// have been sent before are decoded once more; so are all for other vessels than it was prepared for.
//
//     auto coming = std::async(std::launch::async,
//                              [=] { return lapfx::prepare_organ(lapfx::load_organ("liver.glb"), preset.vessels); });
//     ...                                                       // the render thread continues with the previous organ
//     effects = lapfx::Effects(coming.get(), preset, options);  // render thread
//
// Never changes once it is made: any number of Effects on any threads may share one.
#pragma once

#include <memory>

#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/progress.h"

namespace lapfx {

class PreparedOrgan {
  public:
    /// With its long triangles split (refine.h). Its images have their names and sizes but no pixels: these are kept
    /// until they have been sent to a GPU, and decoded again when they are needed.
    const Organ& organ() const;
    std::size_t memory() const;  ///< bytes of main memory

    ~PreparedOrgan();

  private:
    struct State;
    friend class Effects;
    friend class AmountsModel;
    friend struct PreparedOrganAccess;  // the core's own
    explicit PreparedOrgan(std::unique_ptr<const State> state);
    const State& state() const { return *state_; }

    std::unique_ptr<const State> state_;
};

/// An organ that the host has loaded. `vessels`: what densities are made for first; another preset may be set later.
/// Null when `progress` stopped it. Any thread.
std::shared_ptr<const PreparedOrgan> prepare_organ(Organ organ, const VesselParameters& vessels = {},
                                                   const Progress& progress = {});

}  // namespace lapfx
