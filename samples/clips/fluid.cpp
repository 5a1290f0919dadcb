#include "fluid.h"

#include <cmath>

#include "parallel.h"

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
      expansion(cell_centres(settings.cells, 1)),
      settings_(settings),
      projection_(settings.cells, settings.walls),
      flow_(settings.cells),
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

/// One explicit step of viscosity. MacCormack never damps shear between neighbouring cells; in a rising column that
/// shows as straight vertical streaks of the grid's width.
void Fluid::diffuse(Field& f, float amount) {
    const std::size_t dy = std::size_t(f.size.x), dz = dy * std::size_t(f.size.y);
    scratch_ = f.values;
    for_slabs(f.size.z - 2, [&](int begin, int end) {
        for (int k = begin + 1; k < end + 1; ++k)
            for (int j = 1; j < f.size.y - 1; ++j) {
                const float* p = scratch_.data() + f.index(0, j, k);
                float* out = f.values.data() + f.index(0, j, k);
                for (int i = 1; i < f.size.x - 1; ++i) {
                    const float* c = p + i;
                    const float around = c[-1] + c[1] + *(c - dy) + c[dy] + *(c - dz) + c[dz];
                    out[i] += amount * (around - 6.0f * *c);
                }
            }
    });
}

void Fluid::advect(float dt, const SmallEddies& eddies) {
    for_slabs(settings_.cells.z, [&](int begin, int end) { flow_.gather(velocity, begin, end); });
    const float reach = fastest() * dt;
    if (!settings_.fill) {
        move_density_.active().find(density, 1e-4f, reach * float(settings_.detail) + 1.0f);
        move_temperature_.active().find(temperature, 1e-4f, reach + 1.0f);
    }
    move_density_.trace(flow_, dt, eddies);
    move_density_.advect(density);
    move_temperature_.trace(flow_, dt);
    move_temperature_.advect(temperature);
    move_u_.trace(flow_, dt);
    move_v_.trace(flow_, dt);
    move_w_.trace(flow_, dt);
    move_u_.advect(velocity.u);
    move_v_.advect(velocity.v);
    move_w_.advect(velocity.w);

    for (Field* f : {&velocity.u, &velocity.v, &velocity.w}) diffuse(*f, settings_.viscosity * dt);
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
    projection_.project(velocity, expansion, settings_.pressure_cycles);
}

}  // namespace clips
