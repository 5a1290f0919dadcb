#include "fluid.h"

#include <cmath>

namespace clips {
namespace {

Field cell_centres(glm::ivec3 cells, int detail) {
    const float spacing = 1.0f / float(detail);
    return Field(cells * detail, glm::vec3(0.5f * spacing), spacing);
}

}  // namespace

Fluid::Fluid(const FluidSettings& settings)
    : velocity(settings.cells),
      temperature(cell_centres(settings.cells, 1)),
      density(cell_centres(settings.cells, settings.detail)),
      settings_(settings),
      projection_(settings.cells, settings.walls),
      move_u_(velocity.u),
      move_v_(velocity.v),
      move_w_(velocity.w),
      move_temperature_(temperature),
      move_density_(density) {}

float Fluid::fastest() const {
    float most = 0.0f;
    for (const Field* f : {&velocity.u, &velocity.v, &velocity.w})
        for (float x : f->values) most = std::max(most, std::abs(x));
    return most;
}

void Fluid::advect(float dt) {
    const float reach = fastest() * dt;
    if (!settings_.fill) {
        move_density_.active().find(density, 1e-4f, reach * float(settings_.detail) + 1.0f);
        move_temperature_.active().find(temperature, 1e-4f, reach + 1.0f);
    }
    move_density_.trace(velocity, dt);
    move_density_.advect(density);
    move_temperature_.trace(velocity, dt);
    move_temperature_.advect(temperature);
    move_u_.trace(velocity, dt);
    move_v_.trace(velocity, dt);
    move_w_.trace(velocity, dt);
    move_u_.advect(velocity.u);
    move_v_.advect(velocity.v);
    move_w_.advect(velocity.w);

    const float keep = std::exp(-settings_.drag * dt);
    for (Field* f : {&velocity.u, &velocity.v, &velocity.w})
        for (float& x : f->values) x *= keep;
    const float warm = std::exp(-settings_.cooling * dt);
    for (float& x : temperature.values) x *= warm;
}

void Fluid::push(Forces& forces, float dt) {
    forces.add_buoyancy(temperature, density, settings_.lift, settings_.weight);
    if (settings_.confinement > 0.0f) forces.add_confinement(velocity, settings_.confinement);
    forces.apply(velocity, dt);
    projection_.project(velocity, settings_.pressure_cycles);
}

}  // namespace clips
