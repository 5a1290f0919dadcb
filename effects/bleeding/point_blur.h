// Gaussians over scattered points, such as the vertices of a surface, by standard deviation in mm.
//
// Distance is through space, not along the surface: in most files arteries and the heart under them are separate
// meshes, and walking along edges would not lead from one to the other. One thread at a time.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lapfx::bleeding {

class PointBlur {
  public:
    /// `deviation` in mm, above 0. Points are gathered into cells of half that size, so a dense mesh costs no more than
    /// a coarse one. `weights` may be the area that each point represents. Points with a NaN or huge (beyond 1e6
    /// deviations) coordinate are left out.
    PointBlur(std::span<const glm::vec3> points, std::span<const float> weights, double deviation);

    /// Means of `values`, one per point, at all points. A point that was left out, or has no weight near it, keeps its
    /// own.
    std::vector<float> operator()(std::span<const float> values) const;

  private:
    struct Run {
        std::uint32_t begin = 0, end = 0;
    };
    struct Cell {
        glm::dvec3 centre{0.0};  // weight is centred here
        double weight = 0.0;
        std::uint32_t block = 0;
    };
    void gather(std::vector<std::array<int, 3>>& blocks);
    void link(const std::vector<std::array<int, 3>>& blocks);
    double mean_at(std::size_t point, std::span<const double> sums, double& weight) const;

    double deviation_;
    std::span<const glm::vec3> points_;
    std::span<const float> weights_;
    std::vector<std::uint32_t> cell_of_;  // each point has its cell, or none
    std::vector<Cell> cells_;             // block by block
    std::vector<std::array<Run, 27>>
        neighbours_;  // per block, which is as wide as the Gaussian reaches: its cells and those around it
};

}  // namespace lapfx::bleeding
