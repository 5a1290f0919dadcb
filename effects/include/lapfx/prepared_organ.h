// An organ prepared for the effects: its surface is joined, and its vessels and fat are found. That takes long and
// needs no OpenGL, so another thread than the drawing one can do it; mip levels and sending the organ to the GPU
// remain. Textures that were sent before are decoded again, and so are all textures when a preset has other vessel
// parameters than the organ was prepared with.
//
//     auto coming = std::async(std::launch::async,
//                              [=] { return lapfx::prepare_organ(lapfx::load_organ("liver.glb"), preset.vessels); });
//     ...                                   // the render thread continues with the previous organ
//     effects.set_organ(coming.get());      // render thread, once it is ready; a part of it in each seek()
//
// The first organ of all is for the constructor of Effects. A PreparedOrgan never changes: any number of Effects on any
// threads may share one.
#pragma once

#include <memory>

#include "lapfx/api.h"
#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/progress.h"

namespace lapfx {

class LAPFX_API PreparedOrgan {
  public:
    /// The organ with its long triangles split (refine.h). Its images have names and sizes but no pixels: those are
    /// kept until they have been sent to a GPU, and decoded again when they are needed.
    const Organ& organ() const;
    std::size_t memory() const;  ///< bytes of main memory

    ~PreparedOrgan();

  private:
    struct LAPFX_HIDDEN State;
    friend class Effects;
    friend class AmountsModel;
    friend struct PreparedOrganAccess;  // the core's own
    LAPFX_HIDDEN explicit PreparedOrgan(std::unique_ptr<const State> state);
    const State& state() const { return *state_; }

    std::unique_ptr<const State> state_;
};

/// Prepares an organ that the host has loaded. Densities are made for `vessels` first; another preset may be set later.
/// Null when `progress` stopped it. Any thread.
LAPFX_API std::shared_ptr<const PreparedOrgan> prepare_organ(Organ organ, const VesselParameters& vessels = {},
                                                             const Progress& progress = {});

}  // namespace lapfx
