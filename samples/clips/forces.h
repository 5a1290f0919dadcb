// Body forces on the flow, gathered at cell centres and then added to the faces.
#pragma once

#include <vector>

#include "field.h"
#include "noise.h"

namespace clips {

class Forces {
  public:
    explicit Forces(glm::ivec3 cells);

    void clear();

    /// Hot gas rises, heavy smoke sinks: cells/s^2 per unit of temperature and of density (Fedkiw et al.
    /// 2001, eq. 8).
    void add_buoyancy(const Field& temperature, const Field& density, float lift, float weight);

    /// Vorticity confinement: gives back the small swirls that the grid damps (Fedkiw et al. 2001, section
    /// 3).
    void add_confinement(const Velocity& velocity, float strength);

    /// Stirring with two turbulence tiles that drift against each other. `scale`: tiles per cell; `drift`:
    /// tiles by which they have moved; `strength`: cells/s^2. With `where`, only in places with smoke or heat
    /// in that field.
    void add_turbulence(const TurbulenceTile& tile, float scale, glm::vec3 drift, float strength, const Field* where,
                        float gain = 1.0f);

    void apply(Velocity& velocity, float dt) const;

  private:
    std::size_t index(int i, int j, int k) const {
        return (std::size_t(k) * cells_.y + std::size_t(j)) * cells_.x + std::size_t(i);
    }

    glm::ivec3 cells_;
    std::vector<glm::vec3> force_;
    std::vector<glm::vec4> vorticity_;  ///< w is its length
};

}  // namespace clips
