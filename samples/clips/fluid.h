// The solver: velocity, temperature and smoke density in a box, stepped with stable fluids (Stam 1999).
//
// Density is on a finer lattice than velocity. Smoke looks sharp because the flow stretches and folds density; the flow
// itself is smoother, and its pressure costs most of the time.
#pragma once

#include "advection.h"
#include "field.h"
#include "forces.h"
#include "projection.h"

namespace clips {

struct FluidSettings {
    glm::ivec3 cells{48, 64, 32};
    int detail = 2;  ///< density samples per cell and axis
    Walls walls;
    float lift = 0.0f;         ///< cells/s^2 per unit of temperature
    float weight = 0.0f;       ///< cells/s^2 per unit of density
    float confinement = 0.0f;  ///< 1/s
    float viscosity = 0.0f;    ///< cells^2/s
    float drag = 0.1f;         ///< 1/s
    float cooling = 1.0f;      ///< 1/s
    int pressure_cycles = 3;
    bool fill = false;  ///< smoke is everywhere: advect every sample
};

class Fluid {
  public:
    explicit Fluid(const FluidSettings& settings);

    const FluidSettings& settings() const { return settings_; }

    /// Moves smoke, heat and the flow itself along the flow.
    void advect(float dt, const SmallEddies& eddies);
    /// Adds buoyancy and confinement to `forces`, applies all of them, and projects.
    void push(Forces& forces, float dt);

    Velocity velocity;
    Field temperature;
    Field density;
    Field expansion;  ///< 1/s, at cell centres: heated gas expands; set for each step

  private:
    float fastest() const;
    void diffuse(Field& component, float amount);

    FluidSettings settings_;
    Projection projection_;
    Flow flow_;
    std::vector<float> scratch_;
    Advector move_u_, move_v_, move_w_, move_temperature_, move_density_;
};

}  // namespace clips
