// What happens in the box: where smoke comes from, what stirs it, how it fades, how it is lit and framed.
//
// Every scene is driven by noise that repeats after the length of the clip. The flow itself is chaotic and does not
// repeat, but it has the same rhythm when the clip starts over, so that a short cross-fade hides the jump.
#pragma once

#include <memory>
#include <string>

#include "fluid.h"
#include "volume_renderer.h"

namespace clips {

struct SceneOptions {
    std::uint32_t seed = 1;
    int cells_high = 144;  ///< velocity cells over the box's height, a multiple of 16
    float length = 5.0f;   ///< seconds until the driving noise repeats
};

class Scene {
  public:
    virtual ~Scene() = default;

    virtual FluidSettings fluid() const = 0;
    virtual LightSettings light() const = 0;
    virtual ViewSettings view() const = 0;

    /// Sets the state at the start of the warm-up.
    virtual void start(Fluid&) {}
    /// Adds smoke, heat and speed for a step, and lets smoke fade.
    virtual void emit(Fluid& fluid, float time, float dt) = 0;
    /// Swirls too small for the grid.
    virtual SmallEddies eddies(float) const { return {}; }
    /// Adds what stirs the flow.
    virtual void stir(const Fluid& fluid, Forces& forces, float time) = 0;
};

std::unique_ptr<Scene> make_thick_plume(const SceneOptions& options);
std::unique_ptr<Scene> make_thin_wisps(const SceneOptions& options);
std::unique_ptr<Scene> make_rolling_haze(const SceneOptions& options);

}  // namespace clips
