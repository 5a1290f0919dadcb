// Pressure projection: makes a velocity free of divergence (Stam 1999) with a geometric multigrid solver.
#pragma once

#include <vector>

#include "field.h"

namespace clips {

/// The borders of the box. The bottom is tissue; elsewhere the flow may leave and fresh gas may enter.
struct Walls {
    bool bottom = true;
};

class Projection {
  public:
    Projection(glm::ivec3 cells, Walls walls);

    /// Subtracts the pressure gradient, so that the divergence becomes `expansion` (1/s, cell centres). Each V-cycle
    /// reduces the divergence by about a factor of 8; the pressure of the previous step is the first guess.
    void project(Velocity& velocity, const Field& expansion, int cycles);

    /// Root mean square divergence, 1/s.
    static double divergence(const Velocity& velocity);

  private:
    /// One grid of the hierarchy, with a rim of ghost cells around it.
    struct Level {
        glm::ivec3 cells;
        float h2;  ///< cell size squared
        std::vector<float> p, rhs, residual;

        std::size_t at(int i, int j, int k) const {
            return (std::size_t(k + 1) * std::size_t(cells.y + 2) + std::size_t(j + 1)) * std::size_t(cells.x + 2) +
                   std::size_t(i + 1);
        }
    };

    void set_ghosts(const Level& level, std::vector<float>& values) const;
    void smooth(Level& level, int sweeps) const;
    void find_residual(Level& level) const;
    void restrict_to(const Level& fine, Level& coarse) const;
    void prolong_to(Level& coarse, Level& fine) const;
    void cycle(std::size_t level);

    Walls walls_;
    std::vector<Level> levels_;
};

}  // namespace clips
